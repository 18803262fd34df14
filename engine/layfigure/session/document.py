"""The document: what undo brings back, as one frozen value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from layfigure.figures.figure import Figure
from layfigure.poses.locks import Lock
from layfigure.poses.pose import Pose

if TYPE_CHECKING:
    from layfigure.motions.motion import Motion

RATE = Fraction(24)
"""Frames a second, where nothing else is said."""


@dataclass(frozen=True, eq=False)
class Document:
    """One figure in work: its shared pose, what may change, what is locked, and the state of every technique.

    ``fresh`` is true until the pose is first changed: techniques then start with first-generation rules. ``symmetric``
    is true while edits of one side are made on the other as well. ``slots`` are poses put aside, by number.

    ``motion`` is what the pose is a moment of, if anything, at frame ``playhead`` and ``rate`` frames a second: undo
    brings back the pose together with where it stood in time. Techniques know nothing of it.
    """

    figure: Figure
    pose: Pose
    enabled: frozenset[int]
    technique: str = ""
    fresh: bool = True
    states: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    locks: tuple[Lock, ...] = ()
    symmetric: bool = False
    slots: Mapping[int, Pose] = field(default_factory=lambda: MappingProxyType({}))
    motion: Motion | None = None
    playhead: Fraction = Fraction(0)
    rate: Fraction = RATE

    @staticmethod
    def new(figure: Figure) -> Document:
        """Return a fresh document: the figure at rest, every movable limb enabled."""
        return Document(figure, Pose.rest(figure), frozenset(figure.movable))

    def with_state(self, technique: str, state: Any, pose: Pose) -> Document:
        """Return the document after a technique moved to ``state`` and stands at ``pose``."""
        states = MappingProxyType({**self.states, technique: state})
        return replace(self, states=states, pose=pose, fresh=self.fresh and pose == self.pose)

    def same_as(self, other: Document) -> bool:
        """Whether nothing that undo could bring back differs."""
        return (
            self.figure is other.figure
            and self.pose == other.pose
            and (self.enabled, self.technique, self.fresh) == (other.enabled, other.technique, other.fresh)
            and (self.locks, self.symmetric, self.slots) == (other.locks, other.symmetric, other.slots)
            and (self.motion is other.motion or self.motion == other.motion)
            and (self.playhead, self.rate) == (other.playhead, other.rate)
            and self.states.keys() == other.states.keys()
            and all(
                self.states[key] is other.states[key] or self.states[key] == other.states[key] for key in self.states
            )
        )
