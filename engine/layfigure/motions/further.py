"""What a motion can do beyond the algebra of 1986, one function each; :class:`Motion` has them as methods."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

from layfigure.errors import LayfigureError
from layfigure.motions.keys import Mark, held, joint_id
from layfigure.motions.numbers import RATE, Rational, rational, written
from layfigure.motions.standard import STANDARD, Curves

if TYPE_CHECKING:
    from layfigure.figures.figure import Figure
    from layfigure.motions.clamping import ClampReport
    from layfigure.motions.motion import Motion
    from layfigure.motions.seams import SeamReport


def speed(motion: Motion, factor: Rational) -> Motion:
    """Return the motion that many times as fast.

    Raises:
        LayfigureError: the factor is not over 0.
    """
    times = rational(factor, "the speed")
    if times <= 0:
        raise LayfigureError(
            f"the speed is {written(times)}, but must be over 0; the reverse of a motion runs backwards"
        )
    return motion.scale(frames=1 / times)


def fit(motion: Motion, seconds: Rational, rate: Rational = RATE) -> Motion:
    """Return the motion stretched or pressed to last some seconds at ``rate`` frames a second.

    Raises:
        LayfigureError: a number is not over 0, or the motion has no length.
    """
    wanted = rational(seconds, "the time to fit") * rational(rate, "the rate")
    if wanted <= 0 or not motion.duration:
        raise LayfigureError("a motion of some length can be fitted to a time over 0, no other")
    return motion.scale(frames=wanted / motion.duration)


def hold(motion: Motion, frames: Rational) -> Motion:
    """Return the motion with its joints staying where they end for some frames more.

    Raises:
        LayfigureError: the number is negative.
    """
    more = rational(frames, "the frames to hold")
    if more < 0:
        raise LayfigureError(f"a motion cannot be held for {written(more)} frames; give 0 or more")
    until = motion.duration + more
    return replace(motion, duration=until, tracks=held(motion.tracks, motion.duration, until))


def then(motion: Motion, other: Motion, curves: Curves = STANDARD) -> tuple[Motion, SeamReport]:
    """Return this motion followed by another, and what jumps at the seam; raises as ``Motion.at`` does."""
    from layfigure.motions.seams import seam_between

    return motion + other, seam_between(motion, other, curves=curves)


def loop(motion: Motion, curves: Curves = STANDARD) -> SeamReport:
    """Return what jumps where the motion is repeated, from its end to its beginning; raises as ``Motion.at`` does."""
    from layfigure.motions.seams import seam_between

    return seam_between(motion, motion, curves=curves)


def marked(motion: Motion, time: Rational, name: str) -> Motion:
    """Return the motion with a mark (an event); marks move with time as it is scaled, reversed and joined.

    Raises:
        LayfigureError: the time lies outside the motion, or the name is none.
    """
    return replace(motion, marks=(*motion.marks, Mark(rational(time, "the mark"), joint_id(name))))


def warp(motion: Motion, ease: Callable[[float], float]) -> Motion:
    """Return the motion with its time eased: :func:`layfigure.motions.warping.warp`."""
    from layfigure.motions.warping import warp

    return warp(motion, ease)


def mirror(motion: Motion, figure: Figure) -> Motion:
    """Return the motion as a mirror shows it: :func:`layfigure.motions.mirroring.mirror`."""
    from layfigure.motions.mirroring import mirror

    return mirror(motion, figure)


def within_rates(motion: Motion, velocity: Rational | None = None, acceleration: Rational | None = None) -> Motion:
    """Return the motion slowed where it is too fast: :func:`layfigure.motions.rates.within_rates`."""
    from layfigure.motions.rates import within_rates

    return within_rates(motion, velocity, acceleration)


def clamped(motion: Motion, figure: Figure) -> tuple[Motion, ClampReport]:
    """Return the motion with its keys inside a figure's limits: :func:`layfigure.motions.clamping.clamped`."""
    from layfigure.motions.clamping import clamped

    return clamped(motion, figure)


def slerp(motion: Motion, figure: Figure) -> Motion:
    """Return the motion by the shortest turns from key to key: :func:`layfigure.motions.slerp.slerp`."""
    from layfigure.motions.slerp import slerp

    return slerp(motion, figure)
