"""The house's own commands, one module per concern; plug-ins and techniques add theirs."""

from __future__ import annotations

from layfigure.plugins.records import Command
from layfigure.session.commands import candidates, files, goals, interface, limbs, locks, pose, view

BUILT_IN: dict[str, Command] = {
    command.id: command
    for module in (candidates, pose, limbs, goals, locks, view, files, interface)
    for command in module.COMMANDS
}
