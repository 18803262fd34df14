"""Frozen records that plug-ins hand over, once, at load. The engine calls their functions under its own guard."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.render_list import Look, RenderList, Target
from layfigure.errors import PluginError
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import CHANNELS, Bench, Controls, TechniqueObject
from layfigure.techniques.solving import SolverObject

if TYPE_CHECKING:  # motions are built on these records
    from layfigure.motions.pieces import Pieces

_ID = re.compile(r"[a-z][a-z0-9_.-]*")


def _check_id(kind: str, identifier: str) -> None:
    if not _ID.fullmatch(identifier):
        raise PluginError(f"the {kind} id {identifier!r} must be lower-case letters, digits, dots or dashes")


@dataclass(frozen=True)
class Technique:
    """A posing technique. ``make(bench)`` gives the object that works on ``bench.figure``.

    ``channels`` names the events it understands (:data:`layfigure.techniques.contract.CHANNELS`): where ``drag`` is
    among them the panel shows a joint ball, where ``goal`` is, limb ends can be dragged in the views. ``controls`` are
    its keys, sliders, choices and toggles.
    """

    id: str
    title: str
    make: Callable[[Bench], TechniqueObject[Any]]
    channels: frozenset[str]
    controls: tuple[Controls, ...] = ()

    def __post_init__(self) -> None:
        _check_id("technique", self.id)
        unknown = self.channels - CHANNELS
        if unknown:
            raise PluginError(f"technique {self.id}: unknown channels {sorted(unknown)}; known are {sorted(CHANNELS)}")


class RendererObject(Protocol):
    """A renderer at work; it may keep caches but never anything a picture depends on."""

    def draw(self, render_list: RenderList, target: Target, look: Look) -> None:
        """Fill every view's rectangle of ``target`` with its background and primitives."""


@dataclass(frozen=True)
class Renderer:
    """A way to draw. ``compiled`` renderers need machine code that may not be ready in a window's first moments."""

    id: str
    title: str
    make: Callable[[], RendererObject]
    compiled: bool = False
    warm: Callable[[], None] | None = None

    def __post_init__(self) -> None:
        _check_id("renderer", self.id)


@dataclass(frozen=True)
class Solver:
    """A way to do inverse kinematics: ``make(figure)`` gives the object that techniques get from their bench.

    ``compiled`` solvers need machine code that may not be ready in a window's first moments; ``warm`` compiles it.
    """

    id: str
    title: str
    make: Callable[[Figure], SolverObject]
    compiled: bool = False
    warm: Callable[[], None] | None = None

    def __post_init__(self) -> None:
        _check_id("solver", self.id)


@dataclass(frozen=True)
class Command:
    """A named thing to do: ``run(session, words)`` with the words typed after the name.

    ``logged`` commands change the document and are written to the session log; they must give the same result from
    the same words on any machine. ``run`` may return other words to log, where those typed were relative. ``usage``
    shows the words, such as ``"LIMB FLEXION PIVOT TWIST"``.

    A motion that plays is stopped for a command, unless that is ``passive``: it reads and writes nothing of the
    document. One that ``chooses`` among candidates is not run while a motion plays, for other ones come where it stops.
    """

    id: str
    title: str
    run: Callable[[Any, tuple[str, ...]], tuple[str, ...] | None]
    usage: str = ""
    logged: bool = False
    passive: bool = False
    chooses: bool = False

    def __post_init__(self) -> None:
        _check_id("command", self.id)


@dataclass(frozen=True)
class Keymap:
    """A set of key bindings in the text of ``data/keymaps``; the later of two plug-ins' bindings wins."""

    id: str
    title: str
    toml: str

    def __post_init__(self) -> None:
        _check_id("keymap", self.id)


@dataclass(frozen=True)
class OverlayLine:
    """A line to draw over a view, in world units of the view's pose."""

    begin: tuple[float, float, float]
    end: tuple[float, float, float]
    rgb: tuple[int, int, int]


@dataclass(frozen=True)
class Overlay:
    """Lines over the views of the working pose, for showing what a technique knows: ``lines(figure, pose)``."""

    id: str
    title: str
    lines: Callable[[Figure, Pose], Iterable[OverlayLine]]

    def __post_init__(self) -> None:
        _check_id("overlay", self.id)


@dataclass(frozen=True)
class FigureSource:
    """A figure that a plug-in brings, as the text of a ``.fig`` file."""

    id: str
    title: str
    fig: str

    def __post_init__(self) -> None:
        _check_id("figure", self.id)


@dataclass(frozen=True)
class Interpolation:
    """A way from one key to the next, given in one of two forms.

    ``ease(u)`` maps 0..1 to progress with ease(0) = 0 and ease(1) = 1. ``pieces(segment)`` takes one component of the
    angles with the velocity and acceleration that the joint arrives with (:class:`layfigure.motions.pieces.Segment`)
    and returns cubics that lead from its start to its end; it must work on Fractions and on floats.
    """

    id: str
    title: str
    ease: Callable[[float], float] | None = None
    pieces: Pieces | None = None

    def __post_init__(self) -> None:
        _check_id("interpolation", self.id)
        if (self.ease is None) == (self.pieces is None):
            raise PluginError(f"interpolation {self.id}: give it either an ease or pieces")


@dataclass(frozen=True)
class Exchange:
    """What passes between the program and a file format: a figure, poses on it, and perhaps a picture.

    ``picture`` is (height, width) uint32 as 0x00RRGGBB; formats of pictures write it, others may ignore it.
    """

    figure: Figure
    poses: tuple[Pose, ...] = ()
    picture: NDArray[np.uint32] | None = None


Record = Technique | Renderer | Solver | Command | Keymap | Overlay | FigureSource | Interpolation
