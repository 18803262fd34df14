"""The technique: a joint is given angles, kept within what the joint allows, snapped where that is wanted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure, limits_from
from layfigure.kinematics.joints import committed
from layfigure.poses.locks import Lock, locked_joints
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import (
    Bench,
    Control,
    Drag,
    EnabledSet,
    Event,
    LocksSet,
    Offer,
    PoseSet,
    Setting,
)
from layfigure.techniques.plain_data import limb_names, limbs_named, lock_lists, locks_listed, reading
from layfigure_plugins.forward.snapping import snapped, snapped_about_axes

VERSION = 1
Floats = NDArray[np.float64]


@dataclass(frozen=True)
class ForwardState:
    """The pose, what may change, whether angles snap and keep their limits, and what there is to say."""

    pose: Pose
    enabled: frozenset[int]
    locks: tuple[Lock, ...] = ()
    snap: bool = False
    limits: bool = True
    note: str = ""


@dataclass(frozen=True)
class Forward:
    """Forward kinematics on one figure."""

    figure: Figure = field(repr=False)

    @staticmethod
    def on(bench: Bench) -> Forward:
        """Return the technique for the bench's figure."""
        return Forward(bench.figure)

    def start(self, setting: Setting) -> ForwardState:
        """Return the state to begin with."""
        return ForwardState(setting.pose, setting.enabled, setting.locks)

    def ask(self, state: ForwardState) -> Offer:
        """Return the values of the switches; there is nothing to choose from."""
        return Offer(title="", note=state.note, values={"snap": state.snap, "limits": state.limits})

    def tell(self, state: ForwardState, event: Event) -> ForwardState:
        """Return the state after an event.

        Raises:
            ImpossibleError: the joint is locked, kept or missing, or the event is not for forward kinematics.
        """
        state = replace(state, note="")
        match event:
            case Drag(limb, angles):
                return self._turned(state, limb, angles)
            case Control("snap", bool(on)):
                return replace(state, snap=on)
            case Control("limits", bool(on)):
                return replace(state, limits=on)
            case PoseSet(pose):
                return replace(state, pose=pose)
            case EnabledSet(enabled):
                return replace(state, enabled=enabled)
            case LocksSet(locks):
                return replace(state, locks=locks)
            case _:
                raise ImpossibleError(f"forward kinematics has no use for {event}"[:160])

    def recommend(self, state: ForwardState) -> Pose:
        """Return the pose."""
        return state.pose

    def dump(self, state: ForwardState) -> dict[str, Any]:
        """Return the state as JSON-ready plain data."""
        return {
            "version": VERSION,
            "pose": pack_pose(self.figure, state.pose),
            "enabled": limb_names(self.figure, state.enabled),
            "locks": lock_lists(self.figure, state.locks),
            "snap": state.snap,
            "limits": state.limits,
        }

    def load(self, data: Mapping[str, Any]) -> ForwardState:
        """Return the state that :meth:`dump` described.

        Raises:
            LayfigureError: another version, another figure, or damaged data.
        """
        with reading("forward kinematics", data, VERSION):
            return ForwardState(
                unpack_pose(self.figure, data["pose"]),
                limbs_named(self.figure, data["enabled"]),
                locks_listed(self.figure, data["locks"]),
                bool(data["snap"]),
                bool(data["limits"]),
            )

    def _turned(self, state: ForwardState, limb: int, angles: tuple[float, float, float]) -> ForwardState:
        self._check_may_turn(state, limb)
        wanted = np.array(angles, dtype=np.float64)
        if not np.isfinite(wanted).all():
            raise ImpossibleError("a joint's angles must be finite numbers")
        has = self.figure.arrays.has_dof[limb] if limb else np.ones(3, dtype=np.bool_)
        turns = self.figure.arrays.euler[limb : limb + 1]
        wanted = committed(np.where(has, wanted, 0.0)[None], turns)[0]
        if state.snap:
            wanted = snapped_about_axes(wanted) if turns[0] else snapped(wanted, has)
        kept = self._within_limits(state, limb, wanted)
        return replace(state, pose=state.pose.with_joint(limb, *kept), note=self._note(limb, wanted, kept))

    def _check_may_turn(self, state: ForwardState, limb: int) -> None:
        if not 0 <= limb < len(self.figure.limbs):
            raise ImpossibleError(f"the figure {self.figure.name} has no limb number {limb}")
        name = self.figure.names[limb]
        if limb and not self.figure.limbs[limb].movable:
            raise ImpossibleError(f"the {name} cannot move; turn the limb above it")
        if limb in locked_joints(state.locks):
            raise ImpossibleError(f"the joint of the {name} is locked; unlock it first")
        if limb and limb not in state.enabled:
            raise ImpossibleError(f"the {name} is kept as it is; enable it first")

    def _within_limits(self, state: ForwardState, limb: int, wanted: Floats) -> Floats:
        """Return the angles within the joint's limits; one that was outside may come nearer but go no farther out."""
        if not state.limits:
            return wanted
        low, high = np.transpose(limits_from(self.figure.limbs[limb], state.pose.angles[limb].tolist()))
        return np.asarray(np.clip(wanted, low, high))

    def _note(self, limb: int, wanted: Floats, kept: Floats) -> str:
        held = np.flatnonzero(np.abs(wanted - kept) > 1e-9)
        if not held.size:
            return ""
        column = int(held[0])
        return f"the {self.figure.limbs[limb].kinds[column]} of the {self.figure.names[limb]} ends at {kept[column]:g}°"
