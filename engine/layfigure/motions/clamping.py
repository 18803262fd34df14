"""A figure's limits and a motion: joint limits always win, and a report says where they had to."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.files.decimals import plain
from layfigure.motions.joints import joint_limbs
from layfigure.motions.keys import PLACE, ROOT_JOINT, Key, Span, Values
from layfigure.motions.motion import Motion

Floats = NDArray[np.float64]
_NOTHING = 1e-9  # degrees that rounding alone can step over a limit


@dataclass(frozen=True)
class ClampReport:
    """How often limits won: ``clamped`` of ``samples``, the worst being joint.kind, by ``excess`` degrees at ``frame``.

    A sample is one joint that the motion moves at one time; of a motion's own keys, one key. ``excess`` is how far
    beyond the limit the motion went, with its sign.
    """

    clamped: int = 0
    samples: int = 0
    joint: str = ""
    kind: str = ""
    excess: float = 0.0
    frame: Fraction = Fraction(0)
    counted: str = "samples"

    def __bool__(self) -> bool:
        """Whether anything was clamped."""
        return self.clamped > 0

    def __str__(self) -> str:
        if not self.clamped:
            return f"clamped none of {self.samples} {self.counted}"
        worst = f"{self.joint}.{self.kind} {plain_signed(self.excess)} degrees at frame {plain(float(self.frame), 3)}"
        return f"clamped {self.clamped} of {self.samples} {self.counted}, worst {worst}"

    def with_other(self, other: ClampReport) -> ClampReport:
        """Return both reports as one; of two worst ones equally far out, the first."""
        worse = other if abs(other.excess) > abs(self.excess) else self
        counts = self.clamped + other.clamped, self.samples + other.samples
        return ClampReport(*counts, worse.joint, worse.kind, worse.excess, worse.frame, self.counted)


def plain_signed(degrees: float) -> str:
    """Return degrees with their sign and as few decimals as matter."""
    shown = plain(abs(degrees), 1)
    return f"{'-' if degrees < 0 else '+'}{shown if shown != '0' else 'less than 0.1'}"


def merged(reports: Iterable[ClampReport]) -> ClampReport:
    """Return several reports as one."""
    whole = ClampReport()
    for report in reports:
        whole = whole.with_other(report)
    return whole


def clamp_samples(
    figure: Figure, limbs: NDArray[np.int64], values: Floats, times: Floats, to_limits: bool = True
) -> tuple[Floats, ClampReport]:
    """Return values (f, j, 3) of limbs (j,) as the figure can take them, and the report; the root turns freely.

    That is inside its limits, unless not ``to_limits``, and swings inside their domain (posing.md 1). A degree of
    freedom that a joint lacks has the limits 0 and 0. Limbs that share a joint id are one joint, and samples of it are
    counted once.
    """
    limits = figure.arrays.limits[limbs].copy()
    limits[limbs == 0] = (-np.inf, np.inf)
    if not to_limits:
        limits[:] = (-np.inf, np.inf)
    wanted = _turned_over(values, limbs)
    kept = np.clip(wanted, limits[..., 0], limits[..., 1])
    _into_domain(kept, limits, figure.arrays.euler[limbs])
    joints = _first_columns(figure, limbs)
    samples = values.shape[0] * len(joints)
    over = wanted - kept
    beyond = np.abs(over) > _NOTHING
    if not beyond.any():
        return kept, ClampReport(0, samples if to_limits else 0)
    count = int(np.count_nonzero(np.logical_or.reduceat(beyond.any(axis=2), joints, axis=1)))
    time, column, component = np.unravel_index(int(np.abs(over).argmax()), over.shape)
    joint, frame = figure.limbs[int(limbs[column])], Fraction(repr(float(times[time])))
    name = joint.joint_id if joint.index else ROOT_JOINT
    return kept, ClampReport(
        count, samples, name, joint.kinds[int(component)], float(over[time, column, component]), frame
    )


def _turned_over(values: Floats, limbs: NDArray[np.int64]) -> Floats:
    """Return values (f, j, 3) with a root that only flexes, or only pivots, turned on through 180 degrees.

    So a somersault goes on; no turn is changed by it.
    """
    if 0 not in limbs:
        return values
    answer = values.copy()
    for column in np.flatnonzero(limbs == 0).tolist():
        swing = answer[:, column, :2]
        alone = (swing == 0.0).any(axis=1) & (np.abs(swing).sum(axis=1) > 180.0)
        swing[alone] = 180.0 - np.mod(180.0 - swing[alone], 360.0)
    return answer


def _into_domain(values: Floats, limits: Floats, axes: NDArray[np.bool_]) -> None:
    """Bring swings of values (f, j, 3) within limits (j, 3, 2) into |flexion| + |pivot| <= 180 in place.

    They go along the line to what is nearest to rest within the limits, so that they stay inside them; where even that
    lies outside the domain, along the line to rest. Joints that turn about ``axes`` have no swing (posing.md 1).
    """
    beyond = (np.abs(values[..., :2]).sum(axis=2) > 180.0).any(axis=0) & ~axes
    for column in np.flatnonzero(beyond).tolist():
        swing = values[:, column, :2]
        nearest = np.clip(0.0, limits[column, :2, 0], limits[column, :2, 1])
        goal = nearest if np.abs(nearest).sum() <= 180.0 else np.zeros(2)
        total, least = np.abs(swing).sum(axis=1, keepdims=True), np.abs(goal).sum()
        share = np.where(total > 180.0, (180.0 - least) / np.maximum(total - least, 1e-300), 1.0)
        swing[:] = np.where(total > 180.0, goal + share * (swing - goal), swing)


def _first_columns(figure: Figure, limbs: NDArray[np.int64]) -> list[int]:
    """Return at which of limbs (j,) each joint begins; limbs of one joint stand together."""
    ids = [figure.limbs[limb].joint_id if limb else ROOT_JOINT for limb in limbs.tolist()]
    return [column for column, joint in enumerate(ids) if not column or joint != ids[column - 1]]


def clamped(motion: Motion, figure: Figure) -> tuple[Motion, ClampReport]:
    """Return a motion whose keys lie inside a figure's limits, and which did not; joints it lacks are left alone.

    Between its keys the default interpolation then keeps them too; others may step over, and are clamped when sampled,
    as are swings of flexion and pivot that come to more than 180 degrees together.
    """
    limits = _exact_limits(figure)
    report = ClampReport(counted="keys")
    tracks = dict(motion.tracks)
    for joint in motion.joints:
        if joint in limits:
            spans = []
            for span in motion.tracks[joint]:
                spans.append(span.revalued(partial(_inside, bounds=limits[joint])))
                report = report.with_other(_keys_report(figure, joint, span, spans[-1]))
            tracks[joint] = tuple(spans)
    return Motion(motion.duration, tracks, motion.marks), report


Bounds = tuple[tuple[Fraction, Fraction], ...]


def _exact_limits(figure: Figure) -> dict[str, Bounds]:
    """Return the limits of joints by id, of limbs that share one those that all of them have; the root has none."""
    found = {}
    for joint, limbs in joint_limbs(figure).items():
        if joint not in (ROOT_JOINT, PLACE):
            pairs = limbs.bounds(figure).tolist()
            found[joint] = tuple((Fraction(repr(low)), Fraction(repr(high))) for low, high in pairs)
    return found


def _inside(values: Values, bounds: Bounds) -> Values:
    x, y, z = (min(max(value, low), high) for value, (low, high) in zip(values, bounds, strict=True))
    return (x, y, z)


def _keys_report(figure: Figure, joint: str, before: Span, after: Span) -> ClampReport:
    kinds = figure.limbs[joint_limbs(figure)[joint].limbs[0]].kinds
    report = ClampReport(0, len(before.keys), counted="keys")
    for old, new in zip(before.keys, after.keys, strict=True):
        if old != new:
            report = report.with_other(_key_report(joint, kinds, old, new))
    return report


def _key_report(joint: str, kinds: tuple[str, str, str], old: Key, new: Key) -> ClampReport:
    over = [float(was - now) for was, now in zip(old.values, new.values, strict=True)]
    worst = max(range(3), key=lambda component: abs(over[component]))
    return ClampReport(1, 0, joint, kinds[worst], over[worst], old.time, "keys")
