"""A technique under examination: every call is made twice, and compared, and watched for what it must not do."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, TypeVar

import numpy as np

from layfigure.drawing.marks import ROLES
from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.plugins.host import Host
from layfigure.plugins.records import Technique
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Choice, Event, Offer, Setting, Slider, TechniqueObject, Toggle
from layfigure.testing.fingerprint import fingerprint, offer_print, pose_print
from layfigure.testing.hosting import TestingBench

T = TypeVar("T")


@dataclass(frozen=True)
class Told:
    """The state after an event, or why the technique would not have it (then the state is the one from before)."""

    state: Any
    refusal: str = ""


@dataclass(frozen=True)
class Subject:
    """One technique on one figure. Its methods are the technique's, guarded; a breach is an AssertionError."""

    record: Technique
    figure: Figure
    host: Host
    technique: TechniqueObject[Any] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "technique", self.fresh())

    def fresh(self) -> TechniqueObject[Any]:
        """Return another object of the technique, which knows nothing of what this one was told."""
        bench = TestingBench(self.figure, host=self.host)
        return self._call("make", lambda: self.record.make(bench))

    def breach(self, sentence: str) -> AssertionError:
        """Return the error that says what the technique did wrong."""
        return AssertionError(f"technique {self.record.id} on {self.figure.name}: {sentence}")

    def require(self, truth: bool, sentence: str) -> None:
        """Raise the sentence unless it is true that the law is kept."""
        if not truth:
            raise self.breach(sentence)

    def start(self, setting: Setting) -> Any:
        """Return the first state, the same at every start, at the setting's pose."""
        state = self._call("start", lambda: self.technique.start(setting))
        again = self._call("start", lambda: self.technique.start(setting))
        self.require(self.dump(state) == self.dump(again), "start gives two states for one setting")
        self.require(self.recommend(state) == setting.pose, "after start it recommends another pose than the setting's")
        return state

    def ask(self, state: Any) -> Offer:
        """Return the offer of a state, the same twice, in order; the state is as it was."""
        before = fingerprint(state)
        offer = self._call("ask", lambda: self.technique.ask(state))
        first = self._call("marks", lambda: offer_print(offer))
        second = self._call("ask", lambda: offer_print(self.technique.ask(state)))
        self.require(first == second, "ask gives two offers for one state")
        self.require(fingerprint(state) == before, "ask changes the state that it is given")
        self._check_offer(offer)
        return offer

    def tell(self, state: Any, event: Event) -> Told:
        """Return what becomes of a state by an event, the same twice; neither of the two is changed."""
        before = fingerprint((state, event))
        told = self._tell(state, event)
        unchanged = fingerprint((state, event)) == before
        self.require(unchanged, f"tell changes the state that it is given, on {spoken(event)}")
        again = self._tell(state, event)
        same = told.refusal == again.refusal and self.dump(told.state) == self.dump(again.state)
        self.require(same, f"tell gives two answers to one {spoken(event)}")
        return told

    def recommend(self, state: Any) -> Pose:
        """Return the pose that a state stands at, the same twice."""
        pose = self._call("recommend", lambda: self.technique.recommend(state))
        self._check_pose(pose, "recommend")
        again = self._call("recommend", lambda: self.technique.recommend(state))
        self.require(pose_print(pose) == pose_print(again), "recommend gives two poses for one state")
        return pose

    def dump(self, state: Any) -> str:
        """Return a state as the JSON text of its dump."""
        data = self._call("dump", lambda: self.technique.dump(state))
        try:
            text = json.dumps(data, allow_nan=False, sort_keys=True)
        except (TypeError, ValueError) as error:
            raise self.breach(f"dump gives something that JSON cannot say ({error})") from error
        self.require(isinstance(data, dict) and "version" in data, 'dump gives no "version"')
        return text

    def _tell(self, state: Any, event: Event) -> Told:
        try:
            return Told(self.technique.tell(state, event))
        except LayfigureError as error:
            self.require(bool(str(error)), f"it refuses {spoken(event)} without a sentence")
            return Told(state, str(error))
        except Exception as error:
            raise self.breach(f"tell raised {type(error).__name__} ({error}) on {spoken(event)}") from error

    def _call(self, name: str, function: Callable[[], T]) -> T:
        try:
            return function()
        except AssertionError:
            raise
        except Exception as error:
            raise self.breach(f"{name} raised {type(error).__name__} ({error})") from error

    def _check_pose(self, pose: object, source: str) -> None:
        shape = (len(self.figure.limbs), 3)
        self.require(isinstance(pose, Pose), f"{source} gives a {type(pose).__name__} where a Pose belongs")
        assert isinstance(pose, Pose)
        self.require(pose.angles.shape == shape, f"{source} gives a pose of {len(pose.angles)} limbs, not {shape[0]}")
        finite = np.isfinite(pose.angles).all() and np.isfinite(pose.translation).all()
        self.require(bool(finite), f"{source} gives a pose with numbers that are not finite")
        self.require(pose.with_angles(pose.angles) == pose, f"{source} gives a pose that Pose.of did not make")

    def _check_offer(self, offer: Offer) -> None:
        for number, pose in enumerate(offer.candidates, start=1):
            self._check_pose(pose, f"candidate {number}")
        self.require(len(offer.badges) <= len(offer.candidates), "it offers more badges than candidates")
        for mark in (*offer.marks(), *offer.cones()):
            self.require(mark.role in ROLES, f'a mark has the role "{mark.role}"; roles are {", ".join(ROLES)}')
            self.require(bool(np.isfinite(mark.points).all()), "a mark has points that are not finite")
        for control in self.record.controls:
            if isinstance(control, Slider | Choice | Toggle):
                self.require(control.name in offer.values, f"the offer's values lack its control {control.name}")


def spoken(event: object) -> str:
    """Return an event as a sentence names it, not too long."""
    text = type(event).__name__ if hasattr(event, "pose") else repr(event)
    return text if len(text) < 160 else f"{text[:150]}…"
