"""ANIMATE: a motion on a stretch of a scene's frames, sampled in batches ahead of the frames that ask for it."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.figures.handedness import MIRRORED
from layfigure.motions.clamping import ClampReport
from layfigure.motions.joints import joints_of
from layfigure.motions.keys import PLACE
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import Rational, rational, written
from layfigure.motions.sampling import Sampled, sample
from layfigure.motions.seams import SeamReport, seam_between
from layfigure.motions.standard import STANDARD, Curves

Floats = NDArray[np.float64]
_FEWEST, _MOST = 16, 512  # frames sampled at a time: twice as many whenever a motion goes on


@dataclass(frozen=True)
class Animate:
    """ANIMATE .. FROM ``first`` TO ``last`` USING ``motion`` [REPEAT]: what happens on scene frames first..last.

    On frame k, both ends included, the model shows ``motion.at(k - first)``, with ``repeat``
    ``motion.at((k - first) mod duration)``; on others it stays as it is. ``last`` None is the end of the scene.
    ``begin`` and ``end`` are the two frames, exactly.

    Raises:
        LayfigureError: a frame is no number, or the last comes before the first.
    """

    motion: Motion
    first: Rational = 0
    last: Rational | None = None
    repeat: bool = False
    begin: Fraction = field(init=False, repr=False, compare=False)
    end: Fraction | None = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        begin = rational(self.first, "FROM")
        end = rational(self.last, "TO") if self.last is not None else None
        if end is not None and end < begin:
            raise LayfigureError(f"ANIMATE goes FROM {written(begin)} TO {written(end)}; TO must not come before")
        for name, value in (("first", begin), ("last", end), ("begin", begin), ("end", end)):
            object.__setattr__(self, name, value)

    def shows(self, frame: int) -> bool:
        """Whether the motion is shown on a scene frame."""
        return self.begin <= frame and (self.end is None or frame <= self.end)


class Moment(NamedTuple):
    """What a motion says on one frame: the limbs it moves (n,), all angles (n, 3), and the root's place (3,) or None.

    The place is in script coordinates and counts from where the motion began.
    """

    moved: NDArray[np.bool_]
    angles: Floats
    place: Floats | None


class Track:
    """One ANIMATE on one figure. ``clamps`` grows as frames are asked for; ``unknown`` are joints the figure lacks."""

    def __init__(self, figure: Figure, animate: Animate, length: int, curves: Curves = STANDARD) -> None:
        self.clamps = ClampReport()
        self._figure, self._animate, self._length, self._curves = figure, animate, length, curves
        self._begins = np.full(len(figure.limbs), np.inf)
        known = joints_of(figure)
        tracks = animate.motion.tracks
        self.unknown = tuple(joint for joint in tracks if joint not in known and joint != PLACE)
        for joint in tracks:
            self._begins[list(known.get(joint, ()))] = float(tracks[joint][0].begin)
        self._place_begins = float(tracks[PLACE][0].begin) if PLACE in tracks else np.inf
        self._window = range(0)
        self._sampled: Sampled | None = None

    @property
    def seam(self) -> SeamReport | None:
        """What jumps where the motion begins anew, if the scene lasts until it does."""
        animate = self._animate
        last = min(Fraction(self._length - 1), animate.end if animate.end is not None else self._length)
        if not animate.repeat or not animate.motion.duration or last - animate.begin < animate.motion.duration:
            return None
        return seam_between(animate.motion, animate.motion, curves=self._curves)

    def on(self, frame: int) -> Moment:
        """Return what the motion says on a frame that it is shown on."""
        sampled = self._ahead(frame)
        row = frame - self._window.start
        elapsed = float(frame - self._animate.begin)
        place = sampled.translations[row] * MIRRORED if elapsed >= self._place_begins else None
        return Moment(self._begins <= elapsed, sampled.angles[row], place)

    def _ahead(self, frame: int) -> Sampled:
        """Return samples that hold a frame, sampled now if need be."""
        if self._sampled is not None and frame in self._window:
            return self._sampled
        goes_on = frame == self._window.stop and self._sampled is not None
        size = min(2 * len(self._window), _MOST) if goes_on else _FEWEST
        animate = self._animate
        last = self._length - 1 if animate.end is None else min(int(animate.end), self._length - 1)
        self._window = range(frame, max(min(frame + size, last + 1), frame + 1))
        times = [shown - animate.begin for shown in self._window]
        self._sampled = sample(self._figure, animate.motion, times, curves=self._curves, repeat=animate.repeat)
        report = self._sampled.clamps
        self.clamps = self.clamps.with_other(replace(report, frame=report.frame + animate.begin))
        return self._sampled
