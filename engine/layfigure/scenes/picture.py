"""What a scene becomes: pictures of figures in their places, each a frozen value that any renderer can show."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.scenes.camera import SceneCamera

if TYPE_CHECKING:
    from layfigure.motions.clamping import ClampReport
    from layfigure.motions.seams import SeamReport

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Actor:
    """A figure as it stands in one picture: joint angles (n, 3) in degrees and the root's translation (3,).

    Row 0 of the angles turns the root. Left-handed, figure units, not rounded; the arrays are read-only. A graphical
    object is an actor too: a figure of a root alone.
    """

    figure: Figure
    angles: Floats
    translation: Floats

    @staticmethod
    def of(figure: Figure, pose: Pose | None = None) -> Actor:
        """Return a figure in a pose, or at rest at the origin."""
        shown = Pose.rest(figure) if pose is None else pose
        return Actor(figure, shown.angles, shown.translation)


@dataclass(frozen=True, eq=False)
class ScenePicture:
    """One picture: its actors, the camera, and perhaps the ground.

    ``floor`` is the height of the ground in world units; with None there is none, and neither grid nor shadow are
    drawn. Where there are ``sides``, cameras for further views, the picture is a sheet: the camera's view at the left,
    the sides one under the other in the right third, all of them without the ground.
    """

    actors: tuple[Actor, ...]
    camera: SceneCamera
    floor: float | None = None
    sides: tuple[SceneCamera, ...] = ()


@dataclass(frozen=True, eq=False)
class Shooting:
    """One scene, ready to be drawn, with what there is to say about it.

    ``clamps`` tells where joint limits held motions back, ``seams`` of every repeated motion how far it jumps when it
    begins anew, ``unknown`` the joints that motions name and nobody has.
    """

    number: int
    pictures: tuple[ScenePicture, ...]
    clamps: ClampReport | None = None
    seams: tuple[SeamReport, ...] = ()
    unknown: tuple[str, ...] = field(default=())
