"""How long a person waits: for help, for the first paint, for the first real picture; and what stays in memory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time

from layfigure_frontends.bench.rows import Row, median_seconds


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
    """Open a window on SDL's dummy driver and read the times it reports (see ``--timings`` of the window)."""
    runs = sorted((_window() for _ in range(max(repeats // 3, 3))), key=lambda run: run["first_picture"])
    middle = runs[len(runs) // 2]
    return [
        Row("startup", "first paint", middle["first_paint"], "s", "<= 0.15"),
        Row("startup", "first stick figures", middle["first_figures"], "s"),
        Row("startup", "first real picture, warm cache", middle["first_picture"], "s", "<= 0.7"),
        Row("startup", "resident memory of the window", middle["memory_mb"], "MB", "<= 250"),
    ]


def _window() -> dict[str, float]:
    environment = {**os.environ, "SDL_VIDEODRIVER": "dummy", "SDL_VIDEO_DRIVER": "dummy"}
    command = [sys.executable, "-m", "layfigure_frontends.sdl.timings", repr(time.time())]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True, timeout=120)
    return {key: float(value) for key, value in json.loads(done.stdout).items()}
