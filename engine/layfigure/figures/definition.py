"""What a ``.fig`` file says, before mirrors are expanded: plain frozen values, written back as they were read."""

from __future__ import annotations

from dataclasses import dataclass

Vector = tuple[float, float, float]
DOF_KINDS = ("flexion", "pivot", "twist")
EULER_KINDS = ("x", "y", "z")  # of joints that turn about their axes one after the other (animation.md 1)
ALL_KINDS = (*DOF_KINDS, *EULER_KINDS)
MAXIMUM_TURN = 1e6  # degrees that such a joint may turn; hands of clocks go round and round
VOLUME_KINDS = ("sphere", "cylinder", "cone", "cube")


@dataclass(frozen=True)
class Axis:
    """A signed coordinate axis: ``index`` 0, 1, 2 for x, y, z and ``sign`` +1 or -1."""

    index: int
    sign: int

    def __str__(self) -> str:
        return ("-" if self.sign < 0 else "") + "xyz"[self.index]


@dataclass(frozen=True)
class Dof:
    """One rotational degree of freedom with its limits in degrees, ``low <= high``."""

    kind: str
    low: float
    high: float


@dataclass(frozen=True)
class Volume:
    """A solid that fleshes out a limb, in the limb's own coordinates and units.

    ``points`` holds one point for a sphere (centre), two for a cylinder (ends) and a cone (base centre, tip), four
    for a cube (corner and its three neighbours). ``radius`` is 0 for a cube.
    """

    kind: str
    points: tuple[Vector, ...]
    radius: float
    colour: str


@dataclass(frozen=True)
class LimbDefinition:
    """One limb block: axes, segment, degrees of freedom, volumes and the joints placed on it, in file order.

    ``right_handed`` stands in a root only: all points of the figure are right-handed, Z toward the viewer. ``joint``
    is what motions call the joint; empty stands for the limb's name.
    """

    name: str
    axis: Axis = Axis(1, 1)
    flexion_axis: Axis = Axis(0, 1)
    begin: Vector = (0.0, 0.0, 0.0)
    end: Vector = (0.0, 0.0, 0.0)
    dofs: tuple[Dof, ...] = ()
    volumes: tuple[Volume, ...] = ()
    joints: tuple[JointDefinition, ...] = ()
    right_handed: bool = False
    joint: str = ""


@dataclass(frozen=True)
class JointDefinition:
    """A child limb placed at ``position`` of its parent, made twice when ``mirror`` names two prefixes."""

    position: Vector
    limb: LimbDefinition
    mirror: tuple[str, str] | None = None
