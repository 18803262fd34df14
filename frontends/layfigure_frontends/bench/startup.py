"""How long a person waits: for help, for the first paint, for the first real picture; and what stays in memory."""

from __future__ import annotations

import math
import os
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from pathlib import Path

from layfigure_frontends.bench.rows import Row, median_seconds

PATIENCE = 60.0
IDLE_SECONDS = 3.0
SETTLING = 4.0  # what poses is still loaded after the first real picture


def rows(quick: bool) -> list[Row]:
    """Return the start-up rows, each measured on fresh processes."""
    repeats = 5 if quick else 15
    bare = median_seconds(lambda: _run("-c", "pass"), repeats)
    help_ = median_seconds(lambda: _run("-m", "layfigure_frontends", "--help"), repeats)
    found = [
        Row("startup", "layfigure --help", help_, "s", "<= 0.2", "python -c pass", bare, bare / help_, "under 8 times"),
    ]
    return found + _window_rows(repeats)


def _run(*words: str) -> None:
    subprocess.run([sys.executable, *words], check=True, capture_output=True)


def _window_rows(repeats: int) -> list[Row]:
    """Open windows on SDL's dummy driver and watch the file in which a window tells how far it is."""
    runs = sorted((_window() for _ in range(max(repeats // 3, 3))), key=lambda run: run["compiled"])
    middle = runs[len(runs) // 2]
    return [
        Row("startup", "first paint", middle["opening"], "s", "<= 0.15"),
        Row("startup", "stick figures", middle["sticks"], "s"),
        Row("startup", "first real picture, warm cache", middle["compiled"], "s", "<= 0.7"),
        Row("startup", "resident memory of the window", middle["memory"], "MB", "<= 250"),
        Row("startup", "processor while idle", middle["idle"], "%", "<= 1"),
    ]


def _window() -> dict[str, float]:
    """Return seconds to each state of one window, its resident megabytes and its idle per cent of a processor."""
    with tempfile.TemporaryDirectory() as folder:
        told = Path(folder) / "told"
        quiet = {"SDL_VIDEODRIVER": "dummy", "SDL_VIDEO_DRIVER": "dummy", "XDG_STATE_HOME": folder}
        environment = {**os.environ, **quiet, "LAYFIGURE_SENTINEL": str(told)}
        begun = time.perf_counter()
        words = ["-m", "layfigure_frontends", "--frontend", "sdl", "--no-restore"]
        window = subprocess.Popen([sys.executable, *words], env=environment, stderr=subprocess.DEVNULL)
        try:
            seen: dict[str, float] = {}
            while "compiled" not in seen and time.perf_counter() - begun < PATIENCE and window.poll() is None:
                with suppress(OSError, IndexError):
                    seen.setdefault(told.read_text().split()[1], time.perf_counter() - begun)
                time.sleep(0.002)
            seen.setdefault("sticks", seen["compiled"])
            return {**seen, "memory": _resident_megabytes(window.pid), "idle": _idle_percent(window.pid)}
        finally:
            window.terminate()
            window.wait()


def _resident_megabytes(process: int) -> float:
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return math.nan  # only Linux tells
    return next(float(line.split()[1]) / 1024 for line in lines if line.startswith("VmRSS"))


def _idle_percent(process: int) -> float:
    def ticks() -> int:
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        return int(fields[11]) + int(fields[12])

    try:
        time.sleep(SETTLING)
        before = ticks()
        time.sleep(IDLE_SECONDS)
        return (ticks() - before) / os.sysconf("SC_CLK_TCK") / IDLE_SECONDS * 100
    except OSError:
        return math.nan
