"""What jumps at the seams of a motion: degrees, and degrees per second."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

from layfigure.files.decimals import plain
from layfigure.motions.keys import PLACE, Span
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import RATE, Rational, rational
from layfigure.motions.span_curve import State, exact_states
from layfigure.motions.standard import STANDARD, Curves


@dataclass(frozen=True)
class Seam:
    """One joint at one seam: how far its angle jumps (degrees) and its velocity (degrees per second), at the most."""

    time: Fraction
    joint: str
    jump: float
    velocity_jump: float

    def __str__(self) -> str:
        jump, velocity = plain(self.jump, 1), plain(self.velocity_jump, 1)
        return f"{self.joint} {jump} degrees and {velocity} degrees/s at frame {plain(float(self.time), 3)}"


@dataclass(frozen=True)
class SeamReport:
    """Every joint that is moved on both sides of a seam, at every seam, in order of time."""

    seams: tuple[Seam, ...] = ()

    @property
    def worst(self) -> Seam | None:
        """The seam of the largest jump in angle; of two the one with the larger jump in velocity."""
        return max(self.seams, key=lambda seam: (seam.jump, seam.velocity_jump), default=None)

    @property
    def jump(self) -> float:
        """The largest jump in degrees."""
        return self.worst.jump if self.worst else 0.0

    def __str__(self) -> str:
        if self.worst is None:
            return "no seams"
        count = len({seam.time for seam in self.seams})
        return f"{count} seam{'s' if count > 1 else ''}, worst {self.worst}"


def seams(motion: Motion, rate: Rational = RATE, curves: Curves = STANDARD) -> SeamReport:
    """Return what jumps at the seams of a motion that is played at ``rate`` frames a second.

    A joint that is silent in between keeps still there. The root's place is left out: it goes on over seams.

    Raises:
        LayfigureError: a key names an interpolation that ``curves`` does not have.
    """
    per_second = float(rational(rate, "the rate"))
    found = []
    for joint, spans in motion.tracks.items():
        if joint != PLACE:
            found += [_seam(joint, pair, per_second, curves) for pair in pairwise(spans)]
    return SeamReport(tuple(sorted(found, key=lambda seam: seam.time)))


def seam_between(left: Motion, right: Motion, rate: Rational = RATE, curves: Curves = STANDARD) -> SeamReport:
    """Return what jumps at the one seam of ``left + right``, for joints that both move.

    Raises:
        LayfigureError: a key names an interpolation that ``curves`` does not have.
    """
    per_second = float(rational(rate, "the rate"))
    found = []
    for joint in left.tracks:
        if joint in right.tracks and joint != PLACE:
            ends, begins = left.tracks[joint][-1], right.tracks[joint][0].shifted(left.duration)
            found.append(_seam(joint, (ends, begins), per_second, curves))
    return SeamReport(tuple(found))


def _seam(joint: str, pair: tuple[Span, Span], rate: float, curves: Curves) -> Seam:
    left, right = pair
    arriving, leaving = exact_states(left, left.end, curves), exact_states(right, right.begin, curves)
    if left.end < right.begin:
        arriving = _still(arriving)
    jump = max(abs(float(b.value - a.value)) for a, b in zip(arriving, leaving, strict=True))
    change = max(abs(float(b.velocity - a.velocity)) for a, b in zip(arriving, leaving, strict=True))
    return Seam(right.begin, joint, jump, change * rate)


def _still(states: tuple[State, State, State]) -> tuple[State, State, State]:
    x, y, z = (State(state.value, Fraction(0), Fraction(0)) for state in states)
    return x, y, z
