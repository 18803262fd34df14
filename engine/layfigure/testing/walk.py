"""A walk: a technique is told random events, one after the other, and watched for limbs that move and should not."""

from __future__ import annotations

from typing import Any

import numpy as np

from layfigure.poses.locks import JointLock, Lock, locked_joints
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import EnabledSet, Event, LocksSet, Offer, PoseSet, Setting
from layfigure.testing.fingerprint import offer_print
from layfigure.testing.scenes import Scene, legal_pose, outside_limits
from layfigure.testing.subject import Subject, spoken
from layfigure.testing.technique_laws import check_round_trip

LIMITS = "limits"
"""A technique that has a toggle of this name keeps joint limits while it is on."""

_HOUSE = ("pose", "edit", "rest", "enabled", "locks")
"""What the house tells every technique, whatever its channels."""


class Walk:
    """A technique's way through random events, from a setting on."""

    def __init__(self, subject: Subject, setting: Setting, chance: np.random.Generator, keeps_limits: bool) -> None:
        self._subject = subject
        self._chance = chance
        self._keeps_limits = keeps_limits
        self._enabled = setting.enabled
        self._locks: tuple[Lock, ...] = setting.locks
        self._still = setting.pose  # what the limbs that may not change have to stay like
        self._strayed = outside_limits(subject.figure, setting.pose)
        self._state = subject.start(setting)
        self._offer = self._look("the start")

    def go(self, steps: int) -> None:
        """Tell that many random events and check every law after each.

        Raises:
            AssertionError: a law is broken.
        """
        first, shown = self._state, offer_print(self._offer)
        for _ in range(steps):
            event = self._event()
            if event is not None:
                self._tell(event)
        again = offer_print(self._subject.ask(first))
        self._subject.require(again == shown, "a state that is left behind offers something else later")
        check_round_trip(self._subject, self._state)

    def _event(self) -> Event | None:
        pose = self._subject.recommend(self._state)
        scene = Scene(self._subject.figure, pose, len(self._offer.candidates), self._chance)
        channels = sorted(self._subject.record.channels)
        draw = self._chance.random()
        if draw < 0.3 or not channels:
            return self._house_event(pose)
        channel = str(self._chance.choice(channels))
        return scene.absurd_event(channel) if draw > 0.85 else scene.event(channel, self._subject.record.controls)

    def _house_event(self, pose: Pose) -> Event:
        figure, chance = self._subject.figure, self._chance
        limbs = [int(limb) for limb in chance.choice(figure.movable, min(3, len(figure.movable)), replace=False)]
        match str(chance.choice(_HOUSE)):
            case "pose":
                return PoseSet(legal_pose(figure, chance))
            case "edit":
                return PoseSet(pose.with_joints_of(legal_pose(figure, chance), limbs), limbs=tuple(limbs))
            case "rest":
                return PoseSet(Pose.rest(figure), fresh=True)
            case "enabled":
                return EnabledSet(frozenset(figure.movable) ^ frozenset(limbs))
            case _:
                return LocksSet(tuple(JointLock(limb) for limb in sorted(limbs[:2])))

    def _tell(self, event: Event) -> None:
        before = self._subject.recommend(self._state)
        told = self._subject.tell(self._state, event)
        if told.refusal:
            demanded = isinstance(event, PoseSet | EnabledSet)
            self._subject.require(not demanded, f"it refuses {spoken(event)}, which every technique takes")
            return
        self._state = told.state
        self._note(event, before)
        self._offer = self._look(spoken(event))

    def _note(self, event: Event, before: Pose) -> None:
        """Take down what the house now demands, and check that the technique's pose is what the house's event says."""
        after = self._subject.recommend(self._state)
        match event:
            case PoseSet(pose):
                self._subject.require(after == pose, "after PoseSet it recommends another pose than the one set")
                self._still = pose
                self._strayed = outside_limits(self._subject.figure, pose)
            case EnabledSet(enabled):
                self._subject.require(after == before, "EnabledSet changes the pose")
                self._enabled, self._still = enabled, before
            case LocksSet(locks):
                self._subject.require(after == before, "locking joints changes the pose")
                self._locks, self._still = locks, before

    def _look(self, after: str) -> Offer:
        """Return the offer after an event; no pose in it may move what has to stay, or leave limits."""
        offer = self._subject.ask(self._state)
        pose = self._subject.recommend(self._state)
        outside = outside_limits(self._subject.figure, pose)
        if offer.values.get(LIMITS) is False:
            self._strayed |= outside
        limits = self._keeps_limits and offer.values.get(LIMITS) is not False
        self._check(pose, f"the pose after {after}", limits)
        for number, candidate in enumerate(offer.candidates, start=1):
            self._check(candidate, f"candidate {number} after {after}", limits)
        self._strayed &= outside
        return offer

    def _check(self, pose: Pose, what: str, limits: bool) -> None:
        figure = self._subject.figure
        moved = pose.angles != self._still.angles
        missing = ~figure.arrays.has_dof
        missing[0] = False
        self._refuse((moved & missing).any(axis=1), f"{what} turns LIMB in a way that its joint does not have")
        kept = np.ones(len(figure.limbs), dtype=bool)
        kept[[0, *self._enabled]] = False
        self._refuse(moved.any(axis=1) & kept, f"{what} moves LIMB, which may not change")
        locked = np.zeros(len(figure.limbs), dtype=bool)
        locked[sorted(locked_joints(self._locks))] = True
        self._refuse(moved.any(axis=1) & locked, f"{what} moves LIMB, whose joint is locked")
        if limits:
            self._refuse(outside_limits(figure, pose) & ~self._strayed, f"{what} takes LIMB beyond its limits")

    def _refuse(self, limbs: np.ndarray[Any, np.dtype[np.bool_]], sentence: str) -> None:
        for limb in np.flatnonzero(limbs)[:1]:
            raise self._subject.breach(sentence.replace("LIMB", self._subject.figure.names[limb]))
