"""Ask and tell: what passes between a session (or a simulated user) and a posing technique.

A technique is a pure machine over plain state. ``ask(state)`` shows, ``tell(state, event)`` answers with the next
state, ``recommend(state)`` is the pose it stands at. Undo is an older state; nothing is hidden in the object.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol, TypeVar

from layfigure.drawing.marks import Mark
from layfigure.figures.figure import Figure
from layfigure.poses.locks import Lock
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import SolverObject

CHANNELS = frozenset({"limb_pick", "best", "grade", "goal", "drag", "control"})


@dataclass(frozen=True)
class Setting:
    """What a technique starts from: the shared pose, which limbs may change, what is locked, whether it is fresh.

    ``fresh`` is true for a new figure and after initialising everything: first-generation rules apply (posing.md 5).
    """

    pose: Pose
    enabled: frozenset[int]
    fresh: bool
    locks: tuple[Lock, ...] = ()


# --- events -----------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class LimbPick:
    """The user takes limbs of candidate ``candidate`` (0-based). ``vary`` is "", "swing" or "twist" (Shift, Ctrl)."""

    candidate: int
    limbs: tuple[int, ...]
    vary: str = ""


@dataclass(frozen=True)
class Best:
    """The user takes candidate ``candidate`` (0-based) as a whole."""

    candidate: int


@dataclass(frozen=True)
class Grade:
    """The user gives candidate ``candidate`` (0-based) a grade from 0 to 10."""

    candidate: int
    grade: int


@dataclass(frozen=True)
class Drag:
    """The user sets one joint to flexion, pivot and twist in degrees (a joint ball, a typed number)."""

    limb: int
    angles: tuple[float, float, float]


@dataclass(frozen=True)
class Goal:
    """The user wants the tip of ``limb`` (the root: its origin) at a world position in figure units.

    ``dragging`` is true while a pointer is still moving: the answer is wanted at once and must not jump.
    """

    limb: int
    position: tuple[float, float, float]
    dragging: bool = False


@dataclass(frozen=True)
class Control:
    """The user operates one of the technique's own controls: an action (value None), a slider or a choice."""

    name: str
    value: float | str | bool | None = None


@dataclass(frozen=True)
class PoseSet:
    """Something else changed the shared pose: a file, a flip, another technique, an edit by hand.

    ``limbs`` names the joints that an edit by hand set (typed, nudged, put back to rest, pasted), so that a technique
    can go on with what it shows; None means that the whole pose is another one.
    """

    pose: Pose
    fresh: bool = False
    limbs: tuple[int, ...] | None = None


@dataclass(frozen=True)
class EnabledSet:
    """The set of limbs that may change is now ``enabled``."""

    enabled: frozenset[int]


@dataclass(frozen=True)
class LocksSet:
    """What is locked is now ``locks``. A technique that pays no heed to locks may raise ImpossibleError."""

    locks: tuple[Lock, ...]


Event = LimbPick | Best | Grade | Drag | Goal | Control | PoseSet | EnabledSet | LocksSet


# --- what a technique declares and offers -------------------------------------------------------------------------


@dataclass(frozen=True)
class Action:
    """A button or key of a technique: running it tells ``Control(name)``, or ``Control(name, word)`` with a word.

    ``navigates`` marks moves through what is offered, which undo passes over. ``argument`` names the one word that
    the command may take; such actions get no button.
    """

    name: str
    title: str
    keys: tuple[str, ...] = ()
    navigates: bool = False
    argument: str = ""


@dataclass(frozen=True)
class Slider:
    """A number the user sets: ``Control(name, value)`` with low <= value <= high. Keys go down and up one step."""

    name: str
    title: str
    low: float
    high: float
    step: float
    keys: tuple[str, str] | None = None
    unit: str = ""


@dataclass(frozen=True)
class Choice:
    """One of several named options: ``Control(name, option)``. The key goes to the next option."""

    name: str
    title: str
    options: tuple[tuple[str, str], ...]  # (value, label)
    keys: tuple[str, ...] = ()


@dataclass(frozen=True)
class Toggle:
    """Something that is on or off: ``Control(name, bool)``. The key switches it over."""

    name: str
    title: str
    keys: tuple[str, ...] = ()


@dataclass(frozen=True)
class Shortcut:
    """Keys that mean a command line while the technique is in use; ``{key}`` in it stands for the key pressed.

    ``hint`` is the word or two that the status line shows, if any.
    """

    keys: tuple[str, ...]
    command: str
    title: str
    hint: str = ""


Controls = Action | Slider | Choice | Toggle | Shortcut


def _no_marks() -> Iterable[Mark]:
    return ()


@dataclass(frozen=True)
class Offer:
    """What a technique shows: candidates to choose from, or none when the pose itself is worked on.

    ``values`` holds the present value of each slider, choice and toggle by name; ``note`` is one line for the status
    bar; ``address`` is a text that leads back to this very offer, or empty. ``badges`` are short texts on the
    candidates, such as grades. ``marks`` are drawn over the working pose (a goal, a chain) and ``cones`` over its
    skeleton (where the next alternatives can lie); they are asked for only when they are shown. ``variants(count,
    intensity)`` gives up to ``count`` small variations of the present pose, 0..100 saying how small, for bringing a
    still figure to life; None where a technique has none.
    """

    candidates: tuple[Pose, ...] = ()
    title: str = ""
    note: str = ""
    values: Mapping[str, float | str | bool] = field(default_factory=dict)
    address: str = ""
    badges: tuple[str, ...] = ()
    marks: Callable[[], Iterable[Mark]] = field(default=_no_marks, compare=False)
    cones: Callable[[], Iterable[Mark]] = field(default=_no_marks, compare=False)
    variants: Callable[[int, float], Sequence[Pose]] | None = field(default=None, compare=False)


@dataclass(frozen=True)
class Kept:
    """A pose brought back to its locks, and whether it now keeps all of them."""

    pose: Pose
    met: bool


class Bench(Protocol):
    """What the house lends to a technique: its figure, and the services of other plug-ins by id."""

    @property
    def figure(self) -> Figure:
        """The figure being posed."""

    def option(self, name: str, default: float | str | bool) -> float | str | bool:
        """Return a user's setting for this technique, or the default."""

    def solver(self, identifier: str) -> SolverObject:
        """Return a plug-in's solver for the figure, such as ``ik.dls``.

        Raises:
            ImpossibleError: no such solver is in service, or it is not compiled yet.
        """

    def keep(self, poses: Sequence[Pose], locks: Sequence[Lock], movable: frozenset[int]) -> tuple[Kept, ...]:
        """Return poses brought back to their locks by turning the root and ``movable`` joints and carrying the root.

        Without locks on ends the poses come back as they are.

        Raises:
            ImpossibleError: no solver is in service.
        """


State = TypeVar("State")


class TechniqueObject(Protocol[State]):
    """A technique at work on one figure. All methods are pure: same arguments, same answer, nothing kept."""

    def start(self, setting: Setting) -> State:
        """Return the state to begin with."""

    def ask(self, state: State) -> Offer:
        """Return what to show; asking twice gives the same offer to the last bit."""

    def tell(self, state: State, event: Event) -> State:
        """Return the state after an event.

        Raises:
            ImpossibleError: the event makes no sense now; the sentence goes to the status line.
        """

    def recommend(self, state: State) -> Pose:
        """Return the pose the technique stands at."""

    def dump(self, state: State) -> dict[str, Any]:
        """Return the state as JSON-ready plain data with a "version"."""

    def load(self, data: Mapping[str, Any]) -> State:
        """Return the state that :meth:`dump` described.

        Raises:
            LayfigureError: another version, or damaged data.
        """
