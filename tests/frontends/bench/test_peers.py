"""Peers of the benchmark: skipped in words where they are missing, given the same figure where they are not."""

from __future__ import annotations

import sys
from types import ModuleType
from xml.etree import ElementTree

import numpy as np
import pytest

from layfigure_frontends.bench.ik.forward import rows as forward_rows
from layfigure_frontends.bench.ik.measuring import system_row
from layfigure_frontends.bench.ik.model import arm, body, swing_twist
from layfigure_frontends.bench.ik.paths import poses
from layfigure_frontends.bench.ik.works import solves
from layfigure_frontends.bench.peers.hinges import hinge_model, hinges
from layfigure_frontends.bench.peers.installed import PEERS, Peer, find
from layfigure_frontends.bench.peers.mjcf import mjcf
from layfigure_frontends.bench.peers.urdf import urdf


def everywhere(humanoid, count=50):
    return poses(humanoid, body(humanoid), (np.zeros((20, 3)), count, 11))


def named(*titles):
    return [peer for peer in PEERS if peer.title in titles]


def test_a_peer_that_is_not_installed_is_told_of_in_words(humanoid):
    found = find(Peer("Nobody", "no.such.adapter", (), ("no-such-distribution",)), humanoid)
    assert found.told.startswith("not installed (no-such-distribution is missing")
    assert found.systems == found.forwards == ()


def test_a_peer_that_does_not_start_is_told_of_in_words(humanoid, monkeypatch):
    def broken(figure):
        raise OSError("wrong libc")

    adapter = ModuleType("broken_adapter")
    adapter.systems = broken
    monkeypatch.setitem(sys.modules, "broken_adapter", adapter)
    found = find(Peer("Broken", "broken_adapter", (), ("numpy",)), humanoid)
    assert found.told == "does not start: OSError: wrong libc" and found.systems == ()


def test_hinges_turn_as_swing_and_twist_do_where_a_joint_has_one_angle(humanoid):
    limits = humanoid.arrays.limits
    for kind in range(3):
        angles = np.zeros((2, 20, 3))
        angles[:, 1:, kind] = limits[1:, kind].T
        assert np.allclose(hinge_model(humanoid).tips(angles), swing_twist(humanoid).tips(angles), atol=1e-9)


def test_hinges_turn_elsewhere_where_a_joint_has_two_angles(humanoid):
    apart = hinge_model(humanoid).tips(everywhere(humanoid)) - swing_twist(humanoid).tips(everywhere(humanoid))
    assert np.abs(apart).max() > 10


def test_mjcf_and_urdf_have_a_hinge_per_degree_of_freedom_with_its_limits(humanoid):
    for ends, count in ((body(humanoid), 30), (arm(humanoid, 3), 6)):
        assert len(hinges(humanoid, ends.movable)) == count
        joints = ElementTree.fromstring(mjcf(humanoid, ends.movable)).findall(".//joint")
        revolute = ElementTree.fromstring(urdf(humanoid, ends.movable)).findall("joint[@type='revolute']")
        assert [joint.get("name") for joint in joints] == [joint.get("name") for joint in revolute]
        assert len(joints) == count
    knee = next(joint for joint in revolute if joint.get("name") == "rightforearm_flexion")
    assert float(knee.find("limit").get("upper")) == pytest.approx(np.radians(160))


@pytest.mark.parametrize("peer", named("MuJoCo", "Pinocchio"), ids=lambda peer: peer.title)
def test_a_peer_places_the_figure_where_the_judge_does(humanoid, peer):
    found = find(peer, humanoid)
    if not found.forwards:
        pytest.skip(f"{peer.title}: {found.told}")
    for forward in found.forwards:
        angles = everywhere(humanoid)
        tips = forward.batch(angles)() * forward.unit
        assert np.allclose(tips, forward.model.tips(angles), atol=1e-6)
        assert np.allclose(forward.one(angles[0])() * forward.unit, tips[0], atol=1e-6)


@pytest.mark.parametrize("peer", named("mink", "PlaCo", "Robotics Toolbox", "Pinocchio"), ids=lambda peer: peer.title)
def test_a_peer_solves_arms_by_the_judge_s_own_kinematics(humanoid, peer):
    found = find(peer, humanoid)
    if not found.systems:
        pytest.skip(f"{peer.title}: {found.told}")
    row = system_row(solves(humanoid, 20)[1], found.systems[0])
    assert row.measures["success %"] >= 90 and row.measures["outside"] == 0, row.note


def test_the_mjcf_loads_in_mujoco_and_has_the_figure_s_limits(humanoid):
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_string(mjcf(humanoid, frozenset(humanoid.movable)))
    assert (model.nq, model.nsite) == (30, 20)
    turning = hinges(humanoid, frozenset(humanoid.movable))
    assert np.allclose(model.jnt_range, [(hinge.low, hinge.high) for hinge in turning])
    assert model.jnt_limited.all()


def test_forward_rows_tell_how_far_a_program_is_from_the_judge(humanoid):
    from layfigure_frontends.bench.ik.forward import Forward

    model = swing_twist(humanoid)
    off = Forward("off", model, lambda a: lambda: model.tips(a) + 2.0, lambda a: lambda: model.tips(a) / 2, unit=2.0)
    one, batch = forward_rows(humanoid, (off,), 1)
    assert batch.measures["error"] == 0.0 and one.measures["error"] > 1.0
