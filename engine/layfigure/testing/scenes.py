"""What the checkers try things on: poses within the limits, and events that a person, or nobody, would send."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import place_pose
from layfigure.kinematics.measures import body_height
from layfigure.poses.locks import tips_of
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Action,
    Best,
    Choice,
    Control,
    Controls,
    Drag,
    Event,
    Goal,
    Grade,
    LimbPick,
    Shortcut,
    Slider,
    Toggle,
)

Floats = NDArray[np.float64]

EVENTS = {"limb_pick": LimbPick, "best": Best, "grade": Grade, "goal": Goal, "drag": Drag, "control": Control}
ABSURD = (math.nan, math.inf, -math.inf, 1e9, -1e300)


def legal_pose(figure: Figure, chance: np.random.Generator, share: float = 1.0) -> Pose:
    """Return a random pose within the limits, nearer to rest for a smaller ``share``, turned and carried a little."""
    low, high = figure.arrays.limits[..., 0], figure.arrays.limits[..., 1]
    nearest = np.clip(0.0, low, high)
    angles = nearest + (chance.uniform(low, high) - nearest) * share
    swing = np.abs(angles[:, :2]).sum(axis=1, keepdims=True)
    fits = (angles[:, :2] * 179.0 / np.maximum(swing, 179.0) >= low[:, :2]).all(axis=1)
    fits &= ~figure.arrays.euler
    angles[:, :2] *= np.where(fits[:, None], 179.0 / np.maximum(swing, 179.0), 1.0)
    angles[0] = chance.uniform(-20.0, 20.0, 3)
    return Pose.of(angles, chance.uniform(-0.1, 0.1, 3) * body_height(figure), figure.arrays.euler)


def outside_limits(figure: Figure, pose: Pose) -> NDArray[np.bool_]:
    """Return which joints (n,) are outside their limits; the root has none.

    On the boundary of the domain (f, p) and (-f, -p) are one rotation: one of the two within the limits will do.
    """
    low, high = figure.arrays.limits[..., 0] - 1e-6, figure.arrays.limits[..., 1] + 1e-6
    twin = pose.angles.copy()
    at_the_edge = (np.abs(twin[:, :2]).sum(axis=1) >= 180.0 - 2e-6) & ~figure.arrays.euler
    twin[at_the_edge, :2] *= -1.0
    fits = [((angles >= low) & (angles <= high)).all(axis=1) for angles in (pose.angles, twin)]
    outside = np.logical_not(fits[0] | fits[1])
    outside[0] = False
    return np.asarray(outside)


@dataclass(frozen=True)
class Scene:
    """What random events are made from: the figure, the pose on show, how many candidates, and chance."""

    figure: Figure
    pose: Pose
    candidates: int
    chance: np.random.Generator

    def event(self, channel: str, controls: tuple[Controls, ...]) -> Event | None:
        """Return an event of a channel that makes sense now, or None if none does."""
        if channel in ("limb_pick", "best", "grade"):
            return self._about_a_candidate(channel) if self.candidates else None
        match channel:
            case "goal":
                return self._goal()
            case "drag":
                limb = self._limb()
                return Drag(limb, self._angles(limb))
            case _:
                return self._control(controls)

    def _about_a_candidate(self, channel: str) -> Event:
        number = int(self.chance.integers(self.candidates))
        match channel:
            case "limb_pick":
                return LimbPick(number, self._limbs(), str(self.chance.choice(["", "", "swing", "twist"])))
            case "best":
                return Best(number)
            case _:
                return Grade(number, int(self.chance.integers(11)))

    def absurd_event(self, channel: str) -> Event:
        """Return an event of a channel that nobody means: numbers that are none, limbs and candidates that are not."""
        value = float(self.chance.choice(ABSURD))
        limb = int(self.chance.choice([self._limb(), -1, 10**6]))
        candidate = int(self.chance.choice([-1, 99, 10**9]))
        match channel:
            case "limb_pick":
                return LimbPick(candidate, (limb,), str(self.chance.choice(["", "sideways"])))
            case "best":
                return Best(candidate)
            case "grade":
                return Grade(candidate, int(self.chance.choice([-1, 11, 10**9])))
            case "goal":
                return Goal(limb, (value, 0.0, -value), bool(self.chance.integers(2)))
            case "drag":
                return Drag(limb, (value, -value, value))
        return Control("there is no such control", value)

    def _limb(self) -> int:
        return int(self.chance.choice(self.figure.selectable))

    def _limbs(self) -> tuple[int, ...]:
        return tuple(dict.fromkeys(self._limb() for _ in range(int(self.chance.integers(1, 4)))))

    def _angles(self, limb: int) -> tuple[float, float, float]:
        """Return angles that a person may ask for: of a joint that turns about x, y and z in other turns too."""
        widest = 800.0 if self.figure.limbs[limb].euler else 180.0
        first, second, third = self.chance.uniform(-widest, widest, 3).tolist()
        return (first, second, third)

    def _goal(self) -> Goal:
        limb = self._limb()
        tip = tips_of(self.figure, place_pose(self.figure, self.pose))[limb]
        reach = float(self.chance.choice([0.02, 0.2, 3.0])) * body_height(self.figure)
        x, y, z = (tip + self.chance.uniform(-1.0, 1.0, 3) * reach).tolist()
        return Goal(limb, (x, y, z), bool(self.chance.integers(2)))

    def _control(self, controls: tuple[Controls, ...]) -> Control | None:
        known = [control for control in controls if not isinstance(control, Shortcut)]
        if not known:
            return None
        control = known[int(self.chance.integers(len(known)))]
        values = list(values_of(control))
        return Control(control.name, values[int(self.chance.integers(len(values)))])


def values_of(control: Action | Slider | Choice | Toggle) -> Iterator[float | str | bool | None]:
    """Yield values over the range of a control."""
    match control:
        case Slider(low=low, high=high, step=step):
            yield from (low, min(low + step, high), low + step * ((high - low) / step // 2), high)
        case Choice(options=options):
            yield from (option for option, _ in options)
        case Toggle():
            yield from (True, False)
        case Action():
            yield None


def nonsense_for(control: Action | Slider | Choice | Toggle) -> Iterator[float | str | bool | None]:
    """Yield values that a control cannot take."""
    match control:
        case Slider(low=low, high=high, step=step):
            yield from (low - step, high + step, math.nan, math.inf, "loud", None, True)
        case Choice():
            yield from ("no such option", "", 3.0, True, None)
        case Toggle():
            yield from ("maybe", 2.0, None)
        case Action(argument=argument):
            yield from ("no such thing", "\0", "9" * 500) if argument else ()
