"""Sway: a whole technique in one file. Try it: layfigure --plugin one_file.py, or ":plugin one_file.py" at run time."""

import numpy as np
from layfigure.drawing.marks import Mark
from layfigure.errors import ImpossibleError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.poses.pose import Pose
from layfigure.techniques import contract as it
from layfigure.techniques.control_values import checked_value

CONTROLS = (it.Action("gust", "Gust", ("m",)), it.Slider("wind", "Wind", 0, 60, 5, ("-", "+"), "°"))


class Sway:
    def __init__(self, bench):
        self.figure = bench.figure

    def start(self, setting):
        return {"version": 1, "pose": setting.pose, "free": setting.enabled, "wind": 20.0, "gust": 0}

    def ask(self, state):
        nine, arrow = tuple(self.swayed(state, n) for n in range(9)), ((0.0, 0.0, 0.0), (3 * state["wind"], 0.0, 0.0))
        return it.Offer(nine, "Sway", values={"wind": state["wind"]}, marks=lambda: [Mark("guide", arrow)])

    def tell(self, state, event):
        match event:
            case it.LimbPick(number, limbs) if number in range(9) and {*limbs} <= {*range(len(self.figure.limbs))}:
                return {**state, "pose": state["pose"].with_joints_of(self.swayed(state, number), limbs)}
            case it.Control(name):
                value = checked_value(CONTROLS, event)
                return {**state, name: state["gust"] + 1 if name == "gust" else value}
            case it.PoseSet(pose):
                return {**state, "pose": pose}
            case it.EnabledSet(enabled):
                return {**state, "free": enabled}
        raise ImpossibleError("the wind has no use for that")

    def recommend(self, state):
        return state["pose"]

    def dump(self, state):
        return {**state, "pose": pack_pose(self.figure, state["pose"]), "free": sorted(state["free"])}

    def load(self, data):
        if data.get("version") != 1 or not {"pose", "free", "wind", "gust"} <= {*data}:
            raise ImpossibleError("this is not a state of Sway 1; start the technique again")
        return {**data, "pose": unpack_pose(self.figure, data["pose"]), "free": frozenset(data["free"])}

    def swayed(self, state, number):
        shift = np.random.default_rng(state["gust"] * 9 + number).uniform(-1, 1, state["pose"].angles.shape)
        moved = np.clip(state["pose"].angles + shift * state["wind"], *np.moveaxis(self.figure.arrays.limits, 2, 0))
        return state["pose"].with_joints_of(Pose.of(moved), sorted(state["free"]))


@hookimpl
def layfigure_techniques():
    return [Technique("sway", "Sway", Sway, frozenset({"limb_pick", "control"}), CONTROLS)]
