"""Where a root goes over seams: on each axis, a place that travels goes on from where the last one ended.

A motion's ``place`` is written as if it began where the author stood. At a seam, on each axis: where one of the two
sides travels (ends elsewhere than it began), the next begins where the last ended, so ten strides lead ten strides
far, and a way back leads back. Where neither does, each stands at the place it says: a sitting figure sits low, and
stands up to its full height.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from layfigure.motions.keys import PLACE, Span
from layfigure.motions.motion import Motion

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Travel:
    """What is added to the spans of ``place``: ``offsets`` (s, 3) from ``begins`` (s,), ``round`` (3,) a repetition.

    ``before`` (3,) holds in later rounds until the first span begins again.
    """

    begins: Floats
    offsets: Floats
    round: Floats
    before: Floats


def travel(motion: Motion) -> Travel:
    """Return what is added to the place of a motion over its seams."""
    spans = motion.tracks[PLACE]
    offsets = [[Fraction(0)] * 3]
    for left, right in pairwise(spans):
        offsets.append([offset + step for offset, step in zip(offsets[-1], _step(left, right), strict=True)])
    around = [offset + step for offset, step in zip(offsets[-1], _step(spans[-1], spans[0]), strict=True)]
    begins = np.array([float(span.begin) for span in spans])
    before = np.array([float(last - turn) for last, turn in zip(offsets[-1], around, strict=True)])
    return Travel(begins, np.array(offsets, dtype=np.float64), np.array(around, dtype=np.float64), before)


def _step(left: Span, right: Span) -> list[Fraction]:
    """Return what to add, axis by axis, to the place of the right span beyond what is added to the left one's."""
    steps = []
    for began, ended, begins, ends in zip(left.first, left.last, right.first, right.last, strict=True):
        travels = began != ended or begins != ends
        steps.append(ended - begins if travels else Fraction(0))
    return steps
