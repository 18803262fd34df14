"""A plug-in to copy from: a technique that shakes every limb a little, and a renderer that draws dots."""

import random

import numpy as np
from layfigure.errors import ImpossibleError, LayfigureError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Renderer, Technique
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Action, Best, Control, EnabledSet, LimbPick, Offer, PoseSet, Slider
from layfigure.techniques.control_values import checked_value

CONTROLS = (Action("shake", "Shake again", ("m",)), Slider("amount", "Amount", 0, 90, 5, ("-", "+"), "°"))
FIELDS = {"version", "pose", "enabled", "amount", "round"}


class Wiggle:
    """Nine shaken copies of the pose. The state is a plain dict; nothing is kept in the object."""

    def __init__(self, bench):
        self.figure = bench.figure
        self.limbs = len(bench.figure.limbs)

    def start(self, setting):
        return {"version": 1, "pose": setting.pose, "enabled": setting.enabled, "amount": 20.0, "round": 0}

    def ask(self, state):
        shaken = tuple(self._shaken(state, number) for number in range(9))
        return Offer(shaken, title=f"Round {state['round'] + 1}", values={"amount": state["amount"]})

    def tell(self, state, event):
        match event:
            case LimbPick(candidate, limbs) if candidate in range(9) and set(limbs) <= set(range(self.limbs)):
                return {**state, "pose": state["pose"].with_joints_of(self._shaken(state, candidate), limbs)}
            case Best(candidate) if candidate in range(9):
                return {**state, "pose": self._shaken(state, candidate), "round": state["round"] + 1}
            case Control("shake", None):
                return {**state, "round": state["round"] + 1}
            case Control():
                return {**state, "amount": checked_value(CONTROLS, event)}
            case PoseSet(pose):
                return {**state, "pose": pose}
            case EnabledSet(enabled):
                return {**state, "enabled": enabled}
        raise ImpossibleError("wiggling has no use for that")

    def recommend(self, state):
        return state["pose"]

    def dump(self, state):
        pose = state["pose"]
        plain = {"angles": pose.angles.tolist(), "translation": pose.translation.tolist()}
        return {**state, "pose": plain, "enabled": sorted(state["enabled"])}

    def load(self, data):
        if data.get("version") != 1 or not set(data) >= FIELDS:
            raise LayfigureError("this is not a state of Wiggle 1; start the technique again")
        pose = Pose.of(data["pose"]["angles"], data["pose"]["translation"])
        return {**data, "pose": pose, "enabled": frozenset(data["enabled"])}

    def _shaken(self, state, number):
        chance = random.Random(state["round"] * 9 + number)
        pose = state["pose"]
        for limb in sorted(state["enabled"]):
            low, high = self.figure.arrays.limits[limb].T
            shift = [chance.uniform(-1, 1) * state["amount"] for _ in range(3)]
            pose = pose.with_joint(limb, *np.clip(pose.angles[limb] + shift, low, high))
        return pose


class Dots:
    """Draws the first point of every primitive as a dot of its colour."""

    def draw(self, render_list, target, look):
        for (left, top, width, height), (first, last), background in zip(
            render_list.rectangles, render_list.slices, render_list.backgrounds, strict=True
        ):
            above, before = max(top, 0), max(left, 0)
            view = target.pixels[above : max(top + height, 0), before : max(left + width, 0)]
            view[:] = packed(background)
            for item in range(first, last):
                x, y, _ = render_list.points[item, 0]
                if np.isfinite(x) and np.isfinite(y):
                    row, column = int(y) - above, int(x) - before
                    dot = view[max(row - 2, 0) : max(row + 3, 0), max(column - 2, 0) : max(column + 3, 0)]
                    dot[:] = packed(render_list.palette[render_list.colours[item]])


def packed(rgb):
    red, green, blue = (int(value) for value in rgb)
    return np.uint32(red << 16 | green << 8 | blue)


@hookimpl
def layfigure_techniques():
    channels = frozenset({"limb_pick", "best", "control"})
    return [Technique("wiggle", "Wiggle", Wiggle, channels, CONTROLS)]


@hookimpl
def layfigure_renderers():
    return [Renderer("dots", "Dots", Dots)]
