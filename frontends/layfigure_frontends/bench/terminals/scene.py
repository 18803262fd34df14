"""An animation of 160 x 100 half-block pixels, and what programs that show it have in common."""

from __future__ import annotations

import json
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from layfigure.drawing.camera import Camera, as_matrix
from layfigure.drawing.joint_kinds import coded_by_kind, kinds_shown
from layfigure.drawing.render_list import RECOMMENDED, Rectangle, RenderList, new_target
from layfigure.drawing.shots import Shot
from layfigure.plugins.host import Host
from layfigure.poses.pose import Pose
from layfigure_frontends.bench.scenes import humanoid, listed, random_poses

COLUMNS, ROWS = 160, 50
FRAMES, PER_SECOND = 60, 30.0
MARK = 6  # a key is answered by its letter so many times


def animation() -> tuple[NDArray[np.uint32], NDArray[np.uint8]]:
    """Return (60, 100, 160) pixels and kinds of joints: two figures in motion, seen from a camera that goes round."""
    renderer = Host.discover().renderers["raster"].make()
    pictures, kinds = [], []
    for shown in (_listed(frame) for frame in range(FRAMES)):
        target, coded = new_target(COLUMNS, 2 * ROWS), new_target(COLUMNS, 2 * ROWS)
        renderer.draw(shown, target, RECOMMENDED)
        renderer.draw(coded_by_kind(shown, humanoid()), coded, RECOMMENDED)
        pictures.append(target.pixels)
        kinds.append(kinds_shown(coded.pixels))
    return np.stack(pictures), np.stack(kinds)


def _listed(frame: int) -> RenderList:
    turn = 2 * np.pi * frame / FRAMES
    across = np.array([[np.cos(turn), 0, -np.sin(turn)], [0, 1, 0], [np.sin(turn), 0, np.cos(turn)]])
    camera = Camera(as_matrix(across))
    ends = random_poses(humanoid(), 4)
    share = (1 - np.cos(turn)) / 2
    poses = [Pose.of(a.angles * (1 - share) + b.angles * share) for a, b in (ends[:2], ends[2:])]
    return listed(poses, [Shot(i, Rectangle(80 * i, 0, 80, 100), camera) for i in range(2)])


@dataclass
class Performance:
    """What a program counts while it shows the animation; ``file`` is where the result goes."""

    file: Path
    seconds: float
    frames: int = 0
    begun: float = field(default_factory=time.monotonic)
    cpu: float = field(default_factory=time.process_time)
    letter: str = "."

    @property
    def over(self) -> bool:
        """Whether the time is up."""
        return time.monotonic() - self.begun >= self.seconds

    @property
    def line(self) -> str:
        """The line below the picture: the last key."""
        return f"key {self.letter * MARK}"

    def begin(self) -> None:
        """Count from now on."""
        self.begun, self.cpu = time.monotonic(), time.process_time()

    def due(self) -> int:
        """Return which frame is to be shown now."""
        return int((time.monotonic() - self.begun) * PER_SECOND)

    def end(self) -> None:
        """Write down how it went."""
        result = {
            "frames": self.frames,
            "seconds": time.monotonic() - self.begun,
            "cpu": time.process_time() - self.cpu,
        }
        self.file.write_text(json.dumps(result), encoding="utf-8")


def asked() -> tuple[NDArray[np.uint32], Performance]:
    """Return the animation and the performance that the command line asks for: FRAMES RESULT SECONDS."""
    frames, result, seconds = sys.argv[1:4]
    return np.load(frames), Performance(Path(result), float(seconds))
