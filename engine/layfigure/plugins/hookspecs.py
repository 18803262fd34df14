"""The hooks. A plug-in implements any of them with :data:`hookimpl`; see docs/hooks/ for a page on each.

Collecting hooks return a list of frozen records, once, at load; results are used sorted by id. Reading and writing
hooks are asked in turn until one answers. Notifications return nothing. No hook is called per frame.
"""

from __future__ import annotations

from pathlib import Path

import pluggy

from layfigure.plugins.records import (
    Command,
    Exchange,
    FigureSource,
    Interpolation,
    Keymap,
    Overlay,
    Renderer,
    Solver,
    Technique,
)
from layfigure.poses.pose import Pose

hookspec = pluggy.HookspecMarker("layfigure")
hookimpl = pluggy.HookimplMarker("layfigure")


@hookspec
def layfigure_techniques() -> list[Technique]:
    """Return posing techniques."""
    raise NotImplementedError


@hookspec
def layfigure_renderers() -> list[Renderer]:
    """Return renderers."""
    raise NotImplementedError


@hookspec
def layfigure_solvers() -> list[Solver]:
    """Return solvers for inverse kinematics."""
    raise NotImplementedError


@hookspec
def layfigure_commands() -> list[Command]:
    """Return commands for the palette, keymaps and session logs."""
    raise NotImplementedError


@hookspec
def layfigure_keys() -> list[Keymap]:
    """Return key bindings."""
    raise NotImplementedError


@hookspec
def layfigure_overlays() -> list[Overlay]:
    """Return overlays for the views of the working pose."""
    raise NotImplementedError


@hookspec
def layfigure_figures() -> list[FigureSource]:
    """Return figures."""
    raise NotImplementedError


@hookspec
def layfigure_interpolations() -> list[Interpolation]:
    """Return interpolations between keys."""
    raise NotImplementedError


@hookspec(firstresult=True)
def layfigure_read(path: Path) -> Exchange | None:
    """Return what a file holds, or None when the format is not yours."""
    raise NotImplementedError


@hookspec(firstresult=True)
def layfigure_write(document: Exchange, path: Path) -> bool | None:
    """Write a document and return True, or None when the format is not yours."""
    raise NotImplementedError


@hookspec
def layfigure_session_started(session: object) -> None:
    """A session has begun."""


@hookspec
def layfigure_pose_changed(session: object, pose: Pose) -> None:
    """The shared pose changed; called once per committed change."""


@hookspec
def layfigure_session_ending(session: object) -> None:
    """A session is about to end."""
