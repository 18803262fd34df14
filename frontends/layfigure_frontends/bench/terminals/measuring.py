"""The rows of ``layfigure bench terminal``."""

from __future__ import annotations

import importlib.util
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from layfigure_frontends.bench.rows import Row, median_seconds
from layfigure_frontends.bench.terminals.link import Link, Seen, watch
from layfigure_frontends.bench.terminals.scene import COLUMNS, ROWS, animation
from layfigure_frontends.terminal.cells import Grid
from layfigure_frontends.terminal.depth import Depth
from layfigure_frontends.terminal.encoder import CellEncoder

LINKS = (Link("direct"), Link("2 Mbit/s, 40 ms", 2e6, 0.04))
PEERS = {"Textual": "textual_program", "curses": "curses_program"}
TARGETS = {"direct": "", "2 Mbit/s, 40 ms": "< 150 ms"}


def rows(quick: bool) -> list[Row]:
    """Return bytes and time of a frame at each depth, then whole programs over several links."""
    pictures, kinds = animation()
    grids = []
    for picture, kind in zip(pictures, kinds, strict=True):
        grid = Grid(COLUMNS, ROWS)
        grid.put_picture(0, 0, picture, kind)
        grids.append(grid)
    measured = [row for depth in reversed(Depth) for row in _frames(depth, grids)]
    with tempfile.TemporaryDirectory() as folder:
        np.save(Path(folder) / "frames.npy", pictures)
        measured.extend(_programs(Path(folder), 4.0 if quick else 8.0))
    return measured


def _frames(depth: Depth, grids: list[Grid]) -> Iterator[Row]:
    encoder = CellEncoder(depth)
    encoder.speed_up()
    sizes = [len(encoder.encode(grid)) for grid in grids * 2][len(grids) :]
    counter = iter(range(10**9))
    spent = median_seconds(lambda: encoder.encode(grids[next(counter) % len(grids)]), 120)
    rest = _at_rest(encoder, grids[0])
    name = depth.name.lower().replace("_", " ")
    yield Row("terminal", f"a moving frame, {name}", 1e3 * spent, "ms", note="encoding 160 x 100 pixels")
    yield Row("terminal", f"bytes of it, {name}", sum(sizes) / len(sizes) / 1024, "KiB", note=f"at rest {rest} bytes")


def _at_rest(encoder: CellEncoder, grid: Grid) -> int:
    encoder.encode(grid)
    return len(encoder.encode(grid))


def _programs(folder: Path, seconds: float) -> Iterator[Row]:
    """Yield rows of whole programs: processor time a frame, and how long a key waits for its picture."""
    installed = {name: module for name, module in PEERS.items() if name != "Textual" or _has_textual()}
    for link in LINKS:
        ours = _run("our_program", link, folder, seconds)
        if link.title == "direct":
            theirs = {name: _run(module, link, folder, seconds) for name, module in installed.items()}
            yield from (_cost(ours, name, seen) for name, seen in theirs.items())
        else:
            theirs = {name: _run(module, link, folder, seconds) for name, module in installed.items()}
        yield from (_latency(link, ours, name, seen) for name, seen in theirs.items())
        if not theirs:
            yield _latency(link, ours, "", None)
    if shutil.which("tmux"):
        yield _latency(Link("in tmux"), _run("our_program", Link("in tmux"), folder, seconds, tmux=True), "", None)


def _cost(ours: Seen, name: str, seen: Seen) -> Row:
    mine, other = (1e3 * each.cpu / max(each.frames, 1) for each in (ours, seen))
    note = f"{_rate(ours)} and {_rate(seen)} frames a second of 30"
    return Row("terminal", "processor time of a frame", mine, "ms", "", name, other, other / mine, note)


def _latency(link: Link, ours: Seen, name: str, seen: Seen | None) -> Row:
    other = 1e3 * seen.typical if seen is not None else None
    ratio = other / (1e3 * ours.typical) if other is not None else None
    slowest = 1e3 * max(ours.latencies, default=ours.typical)
    lost = f"; {seen.unanswered} keys not answered in 2.5 s by {name}" if seen is not None and seen.unanswered else ""
    note = f"slowest {slowest:.0f} ms, {_rate(ours)} frames a second{lost}"
    target = TARGETS.get(link.title, "")
    return Row("terminal", f"key to picture, {link.title}", 1e3 * ours.typical, "ms", target, name, other, ratio, note)


def _rate(seen: Seen) -> str:
    return f"{seen.frames / seen.seconds:.1f}" if seen.seconds else "no"


def _run(module: str, link: Link, folder: Path, seconds: float, *, tmux: bool = False) -> Seen:
    result = folder / "result.json"
    result.unlink(missing_ok=True)
    place = f"layfigure_frontends.bench.terminals.{module}"
    command = [sys.executable, "-m", place, str(folder / "frames.npy"), str(result), str(seconds)]
    unwanted = ("TMUX", "NO_COLOR", "STY")
    environment = {name: value for name, value in os.environ.items() if name not in unwanted}
    environment |= {"TERM": "xterm-256color", "COLORTERM": "truecolor"}
    if not tmux:
        return watch(command, environment, link, result)
    server = ["tmux", "-S", str(folder / "tmux"), "-f", os.devnull]
    try:
        return watch([*server, "new-session", shlex.join(command)], environment, link, result)
    finally:
        subprocess.run([*server, "kill-server"], check=False, capture_output=True)


def _has_textual() -> bool:
    return importlib.util.find_spec("textual") is not None
