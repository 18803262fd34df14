"""A motion as flat float arrays, made once: per joint a row of cubic pieces that is searched and evaluated in numpy."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.motions.keys import DEFAULT, Span
from layfigure.motions.motion import Motion
from layfigure.motions.pieces import Piece
from layfigure.motions.span_curve import Eased, SpanCurve, Way, progress
from layfigure.motions.standard import Curves, interpolation
from layfigure.plugins.records import Interpolation

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Row:
    """One joint's pieces in order of time; p pieces.

    Piece 0 lasts until the first span begins; its values are NaN, the joint being where it was. ``table`` holds, for
    each piece and component, the coefficients c0 to c3, and the bounds that rounding must not step over; what is looked
    up at once lies together. Where ``ease`` is not -1, a piece's u is the progress of that ease over ``frames``.
    """

    begins: Floats  # (p,) frames
    table: Floats  # (6, p, 3)
    frames: Floats  # (p,)
    ease: NDArray[np.int64]  # (p,)
    seams: frozenset[float]  # where spans begin


@dataclass(frozen=True, eq=False)
class Compiled:
    """A motion ready to be sampled: rows by joint, the last values (3,) of each, and the eases that they use."""

    rows: Mapping[str, Row]
    eases: tuple[Interpolation, ...]

    def evaluate(self, joint: str, times: Floats, earlier: NDArray[np.int64]) -> Floats:
        """Return a joint's values (f, 3) at ``times`` (f,), NaN before its first span.

        ``earlier`` are the indices of times that lie a little before the float that stands for them.
        """
        row = self.rows[joint]
        piece = np.searchsorted(row.begins, times, side="right") - 1
        for index in earlier.tolist():
            if times[index] in row.seams:
                piece[index] = np.searchsorted(row.begins, times[index], side="left") - 1
        u = times - row.begins[piece]
        u[piece == 0] = 0.0
        self._ease(row, piece, u)
        table, u = row.table, u[:, None]
        values = table[3].take(piece, axis=0)
        for coefficients in table[2::-1]:
            values *= u
            values += coefficients.take(piece, axis=0)
        np.maximum(values, table[4].take(piece, axis=0), out=values)
        return np.asarray(np.minimum(values, table[5].take(piece, axis=0), out=values))

    def _ease(self, row: Row, piece: NDArray[np.int64], u: Floats) -> None:
        """Put the progress of eases in the place of frames, in place."""
        if not self.eases:
            return
        for number in np.unique(row.ease[piece]).tolist():
            if number >= 0:
                eased = row.ease[piece] == number
                shares = (u[eased] / row.frames[piece[eased]]).tolist()
                u[eased] = [progress(self.eases[number], share) for share in shares]


class _Block(NamedTuple):
    """The pieces of some spans: begins (p,), table (p, 6, 3), frames (p,), ease (p,)."""

    begins: Floats
    table: Floats
    frames: Floats
    ease: NDArray[np.int64]


def compiled(motion: Motion, curves: Curves) -> Compiled:
    """Return the arrays of a motion, made once for the interpolations that it names.

    Raises:
        LayfigureError: a key names an interpolation that ``curves`` does not have.
    """
    hows = {key.how for spans in motion.tracks.values() for span in spans for key in span.keys}
    used = tuple(interpolation(curves, how) for how in sorted(hows))
    kept = motion.memory.get(("compiled", used))
    if not isinstance(kept, Compiled):
        eases = tuple(record for record in used if record.ease is not None)
        kept = Compiled({joint: _row(spans, curves, eases) for joint, spans in motion.tracks.items()}, eases)
        motion.memory[("compiled", used)] = kept
    return kept


def _row(spans: Sequence[Span], curves: Curves, eases: Sequence[Interpolation]) -> Row:
    before = _Block(np.array([-1.0]), np.full((1, 6, 3), np.nan), np.ones(1), np.full(1, -1))
    blocks = [before]
    for alike, group in _groups(spans):
        blocks += [_monotone(group)] if alike else [_stretch(span, curves, eases) for span in group]
    parts = [np.concatenate(part) for part in zip(*blocks, strict=True)]
    table = np.ascontiguousarray(np.swapaxes(parts[1], 0, 1))
    return Row(parts[0], table, parts[2], parts[3], frozenset(float(span.begin) for span in spans))


def _groups(spans: Sequence[Span]) -> Iterator[tuple[bool, list[Span]]]:
    """Yield runs of spans: whether all their keys are the default's, and the spans."""
    group: list[Span] = []
    for span in spans:
        plain = all(key.how == DEFAULT for key in span.keys)
        if group and plain and all(key.how == DEFAULT for key in group[0].keys):
            group.append(span)
            continue
        if group:
            yield all(key.how == DEFAULT for key in group[0].keys), group
        group = [span]
    yield all(key.how == DEFAULT for key in group[0].keys), group


def _monotone(spans: Sequence[Span]) -> _Block:
    """Return the pieces of spans whose keys are all the default's: a piece from each key, and one for each hold."""
    times = np.array([float(key.time) for span in spans for key in span.keys])
    values = np.array([[float(v) for v in key.values] for span in spans for key in span.keys])
    counts = np.array([len(span.keys) for span in spans])
    lasts = np.cumsum(counts) - 1
    firsts = lasts - counts + 1
    held = np.array([(span.begin < span.keys[0].time, span.keys[-1].time < span.end) for span in spans])
    slopes = _slopes(times, values, (firsts, lasts), held)
    inner = np.ones(len(times), bool)
    inner[lasts] = False
    table = np.zeros((len(times), 6, 3))
    table[:, 0] = table[:, 4] = table[:, 5] = values
    at = np.flatnonzero(inner)
    h = (times[at + 1] - times[at])[:, None]
    secant = (values[at + 1] - values[at]) / h
    table[at, 1] = slopes[at]
    table[at, 2] = (3 * secant - 2 * slopes[at] - slopes[at + 1]) / h
    table[at, 3] = (slopes[at] + slopes[at + 1] - 2 * secant) / (h * h)
    table[at, 4] = np.minimum(values[at], values[at + 1])
    table[at, 5] = np.maximum(values[at], values[at + 1])
    standing = firsts[held[:, 0]]
    rest = np.zeros((len(standing), 6, 3))
    rest[:, 0] = rest[:, 4] = rest[:, 5] = values[standing]
    begins = np.array([float(span.begin) for span in spans])[held[:, 0]]
    times, table = np.insert(times, standing, begins), np.insert(table, standing, rest, axis=0)
    return _Block(times, table, np.ones(len(times)), np.full(len(times), -1))


def _slopes(
    times: Floats, values: Floats, ends: tuple[NDArray[np.int64], NDArray[np.int64]], held: NDArray[np.bool_]
) -> Floats:
    """Return the monotone curve's velocities (k, 3) at keys; as :mod:`layfigure.motions.pieces` on whole arrays.

    ``ends`` are the indices of each span's first and last key; ``held`` (s, 2) whether the joint stands beside them.
    """
    firsts, lasts = ends
    slopes = np.zeros_like(values)
    if len(times) == 1:
        return slopes
    h = np.diff(times)[:, None]
    with np.errstate(divide="ignore", invalid="ignore"):
        secant = np.diff(values, axis=0) / h
        left, right, before, after = h[:-1], h[1:], secant[:-1], secant[1:]
        one, two = 2 * right + left, right + 2 * left
        mean = (one + two) / (one / before + two / after)
        slopes[1:-1] = np.where(before * after > 0, mean, 0.0)
    slopes[firsts] = slopes[lasts] = 0.0
    for side, (edge, step) in enumerate(((firsts, 1), (lasts, -1))):
        free = (lasts > firsts) & ~held[:, side]
        near = edge[free] - (side == 1)
        longer = (lasts - firsts)[free] > 1
        far = np.where(longer, near + step, near)
        slopes[edge[free]] = _edge(h[near], secant[near], h[far], secant[far])
    return slopes


def _edge(h: Floats, d: Floats, k: Floats, e: Floats) -> Floats:
    """Return PCHIP's one-sided velocities (n, 3) at ends of spans; with far = near it is the secant."""
    slope = ((2 * h + k) * d - h * e) / (h + k)
    steep = (d * e <= 0) & (np.abs(slope) > 3 * np.abs(d))
    return np.asarray(np.where(slope * d <= 0, 0.0, np.where(steep, 3 * d, slope)))


class _Line(NamedTuple):
    """One piece: where it begins, its six rows of the table, and for an eased one its frames and which ease."""

    begin: float
    rows: Sequence[Sequence[float]]
    frames: float = 1.0
    ease: int = -1


def _stretch(span: Span, curves: Curves, eases: Sequence[Interpolation]) -> _Block:
    """Return the pieces of one span with ways of any kind."""
    times = [float(key.time) for key in span.keys]
    values = [[float(v) for v in key.values] for key in span.keys]
    held = (span.begin < span.keys[0].time, span.keys[-1].time < span.end)
    curve = SpanCurve(times, values, [key.how for key in span.keys], held, curves)
    lines = [_still(float(span.begin), values[0])] if held[0] else []
    for index, begin in enumerate(times[:-1]):
        ways = [curve.way(component, index) for component in range(3)]
        if isinstance(ways[0][0], Eased):
            lines.append(_eased(begin, ways, eases))
            continue
        bounds = _WHOLE
        if span.keys[index + 1].how == DEFAULT:
            ends = list(zip(values[index], values[index + 1], strict=True))
            bounds = ([min(pair) for pair in ends], [max(pair) for pair in ends])
        lines += [_cubics(begin + since, parts, bounds) for since, parts in _aligned(ways)]
    lines.append(_still(times[-1], values[-1]))
    begins, rows, frames, ease = zip(*lines, strict=True)
    return _Block(np.array(begins), np.array(rows), np.array(frames), np.array(ease))


_WHOLE: tuple[list[float], list[float]] = ([-np.inf] * 3, [np.inf] * 3)
_NONE = [0.0] * 3


def _still(begin: float, values: Sequence[float]) -> _Line:
    return _Line(begin, [values, _NONE, _NONE, _NONE, values, values])


def _cubics(begin: float, parts: Sequence[Piece], bounds: tuple[list[float], list[float]]) -> _Line:
    _, *coefficients = zip(*parts, strict=True)
    return _Line(begin, [[float(c) for c in row] for row in coefficients] + list(bounds))


def _eased(begin: float, ways: Sequence[Way], eases: Sequence[Interpolation]) -> _Line:
    eased = [way[0] for way in ways if isinstance(way[0], Eased)]
    starts, changes = [float(way.start) for way in eased], [float(way.change) for way in eased]
    return _Line(begin, [starts, changes, _NONE, _NONE, *_WHOLE], float(eased[0].frames), eases.index(eased[0].record))


def _aligned(ways: Sequence[Way]) -> Iterator[tuple[float, list[Piece]]]:
    """Yield (frames since the key, a piece per component), cut wherever any of the components is."""
    rows = [[piece for piece in way if isinstance(piece, Piece)] for way in ways]
    starts = [[0.0, *accumulate(float(piece.frames) for piece in row)] for row in rows]
    if starts[0] == starts[1] == starts[2]:
        yield from zip(starts[0][:-1], (list(parts) for parts in zip(*rows, strict=True)), strict=True)
        return
    total = min(start[-1] for start in starts)
    cuts = sorted({cut for start in starts for cut in start[:-1] if cut < total})
    for cut, end in pairwise([*cuts, total]):
        numbers = [bisect_right(start[1:-1], cut) for start in starts]
        yield (
            cut,
            [
                row[number].later(cut - start[number], end - cut)
                for row, number, start in zip(rows, numbers, starts, strict=True)
            ],
        )
