"""The laws of techniques: the template keeps them, and whatever breaks one is named."""

import importlib.util
import random
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.poses.locks import locked_joints
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Action,
    Best,
    Choice,
    Control,
    Drag,
    EnabledSet,
    Goal,
    LocksSet,
    Offer,
    PoseSet,
    Slider,
)
from layfigure.testing import check_technique

ONE_FILE = Path(__file__).resolve().parents[3] / "docs" / "template" / "one_file.py"
spec = importlib.util.spec_from_file_location("one_file", ONE_FILE)
one_file = importlib.util.module_from_spec(spec)
spec.loader.exec_module(one_file)
(SWAY,) = one_file.layfigure_techniques()


class Sway(one_file.Sway):
    """The template's technique, to be spoiled."""


def check(technique: type, figure: str = "juxo", **changes) -> None:
    for seed in range(6):
        check_technique(replace(SWAY, make=technique, **changes), [figure], seed)


def test_the_template_keeps_the_laws():
    check(Sway)


class Forgetful(Sway):
    def start(self, setting):
        return {**super().start(setting), "pose": Pose.rest(self.figure)}


class Whimsical(Sway):
    def swayed(self, state, number):
        return super().swayed({**state, "gust": random.randrange(10**9)}, number)


class Counting(Sway):
    told = 0

    def tell(self, state, event):
        self.told += 1
        return {**super().tell(state, event), "wind": float(self.told % 50)}


class Scribbling(Sway):
    def tell(self, state, event):
        told = super().tell(state, event)
        state["gust"] += 1
        return told


class Remembering(Sway):
    """Offers by what it was told last, instead of by the state."""

    last = 0

    def tell(self, state, event):
        told = super().tell(state, event)
        self.last = told["gust"] + told["wind"]
        return told

    def ask(self, state):
        return super().ask({**state, "gust": state["gust"] + int(self.last)})


class Approximate(Sway):
    def tell(self, state, event):
        if isinstance(event, PoseSet):
            angles = event.pose.angles + np.where(self.figure.arrays.has_dof, 1e-6, 0.0)
            return {**state, "pose": Pose.of(angles, event.pose.translation)}
        return super().tell(state, event)


class Sprawling(Sway):
    """Lets every limb vary, allowed or not."""

    def swayed(self, state, number):
        return super().swayed({**state, "free": frozenset(self.figure.movable)}, number)


class Deaf(Sway):
    """Says that it heeds locks and does not."""

    def tell(self, state, event):
        return dict(state) if isinstance(event, LocksSet) else super().tell(state, event)


class Boundless(Sway):
    def swayed(self, state, number):
        pose = state["pose"]
        for limb in sorted(state["free"]):
            pose = pose.with_joint(limb, *np.where(self.figure.arrays.has_dof[limb], 60.0 + number, 0.0))
        return pose


class Dislocating(Sway):
    def swayed(self, state, number):
        pose = state["pose"]
        for limb in sorted(state["free"]):
            pose = pose.with_joint(limb, 1.0, 1.0, 1.0)
        return pose


class Nowhere(Sway):
    def ask(self, state):
        pose = state["pose"]
        return Offer((Pose(np.full_like(pose.angles, np.nan), pose.translation),), values={"wind": state["wind"]})


class Fragile(Sway):
    def tell(self, state, event):
        return {**state, "gust": 1 // 0} if isinstance(event, EnabledSet) else super().tell(state, event)


class Agreeable(Sway):
    def tell(self, state, event):
        return dict(state) if isinstance(event, Control) else super().tell(state, event)


class Curious(Sway):
    def tell(self, state, event):
        return {**state, "gust": 7} if isinstance(event, Best | Drag | Goal) else super().tell(state, event)


class Trusting(Sway):
    def load(self, data):
        rest = {"pose": Pose.rest(self.figure), "wind": 0.0, "gust": 0, "free": frozenset()}
        return super().load(data) if "pose" in data else rest


class Lossy(Sway):
    def load(self, data):
        return {**super().load(data), "gust": 0}


class Silent(Sway):
    def ask(self, state):
        return replace(super().ask(state), values={})


class Refusing(Sway):
    def tell(self, state, event):
        if isinstance(event, PoseSet):
            raise ImpossibleError("no")
        return super().tell(state, event)


@pytest.mark.parametrize(
    ("technique", "sentence"),
    [
        (Forgetful, "another pose than the setting's"),
        (Whimsical, "two offers for one state"),
        (Counting, "two answers to one"),
        (Scribbling, "changes the state that it is given"),
        (Remembering, "(later|loaded state|two offers)"),
        (Approximate, "another pose than the one set"),
        (Sprawling, "which may not change"),
        (Deaf, "whose joint is locked"),
        (Boundless, "beyond its limits"),
        (Dislocating, "in a way that its joint does not have"),
        (Nowhere, "not finite"),
        (Fragile, r"tell raised ZeroDivisionError .* on EnabledSet"),
        (Agreeable, "which is nonsense|offer's values say"),
        (Curious, "none of its events, but it changes something"),
        (Trusting, "load takes nothing for a state"),
        (Lossy, "a loaded state offers something else"),
        (Silent, "lack its control wind"),
        (Refusing, "which every technique takes"),
    ],
)
def test_a_broken_law_is_named(technique, sentence):
    with pytest.raises(AssertionError, match=rf"technique sway on juxo: .*({sentence})"):
        check(technique)


def test_a_technique_may_leave_limits_if_it_says_so():
    check_technique(replace(SWAY, make=Boundless), ["juxo"], keeps_limits=False)


def test_a_technique_that_heeds_locks_is_held_to_them():
    class Heeding(Sway):
        def start(self, setting):
            return {**super().start(setting), "still": sorted(locked_joints(setting.locks))}

        def tell(self, state, event):
            if isinstance(event, LocksSet):
                return {**state, "still": sorted(locked_joints(event.locks))}
            return super().tell(state, event)

        def load(self, data):
            return {**super().load(data), "still": data["still"]}

        def swayed(self, state, number):
            return super().swayed({**state, "free": state["free"] - set(state["still"])}, number)

    check(Heeding)


@pytest.mark.parametrize(
    ("controls", "sentence"),
    [
        ((Action("a", "A", ("m",)), Action("b", "B", ("m",))), "two controls have the key m"),
        ((Action("a", "A"), Slider("a", "A", 0, 1, 1)), "two controls are called a"),
        ((Action("a", "A", ("ctrl+i",)),), "ctrl\\+i is another key in a terminal"),
        ((Slider("a", "A", 1, 1, 1),), "has no range"),
        ((*one_file.CONTROLS, Choice("c", "C", (("x", "X"),))), "lack its control c"),
    ],
)
def test_controls_that_cannot_work_are_named(controls, sentence):
    with pytest.raises(AssertionError, match=sentence):
        check_technique(replace(SWAY, controls=controls), ["juxo"])
