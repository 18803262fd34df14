"""The house's own commands, one module per concern; plug-ins and techniques add theirs."""

from __future__ import annotations

from layfigure.plugins.records import Command
from layfigure.session.commands import (
    candidates,
    clipboard,
    comparing,
    files,
    goals,
    interface,
    limbs,
    locks,
    motions,
    playing,
    pose,
    resting,
    saying,
    slots,
    symmetric,
    view,
)

BUILT_IN: dict[str, Command] = {
    command.id: command
    for module in (
        candidates,
        pose,
        resting,
        clipboard,
        symmetric,
        slots,
        comparing,
        limbs,
        goals,
        locks,
        view,
        files,
        playing,
        motions,
        interface,
        saying,
    )
    for command in module.COMMANDS
}
