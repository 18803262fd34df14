"""The nine that a page shows, and what it says when there are fewer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import pytest

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.kinematics.forward import closeness, place_pose
from layfigure.kinematics.measures import body_height
from layfigure.kinematics.rotation_vector import rotation_vector
from layfigure.poses.locks import Band, Hold, JointLock, Lock, Pin, broken, lock_at
from layfigure.poses.pose import Pose
from layfigure.session.bench import FigureBench
from layfigure.techniques.contract import Control, Kept, LimbPick, Setting
from layfigure.techniques.solving import Problem, Solution, SolverObject
from layfigure_plugins.hybrid.hybrid import Hybrid
from layfigure_plugins.hybrid.page import MOST_TRIES
from layfigure_plugins.hybrid.state import HybridState


@dataclass
class WorseSolver:
    """A solver that gives up on all but every ``keeps``-th problem, and counts."""

    solver: SolverObject
    keeps: int
    solved: int = 0

    def solve(self, pose: Pose, problem: Problem) -> Solution:
        self.solved += 1
        solution = self.solver.solve(pose, problem)
        if self.solved % self.keeps == 0:
            return solution
        torn = Pose.of(solution.pose.angles, solution.pose.translation + np.array([0.0, 50.0, 0.0]))
        return Solution(torn, solution.errors, met=False)


@dataclass(frozen=True)
class WorseBench:
    """The house's bench with a worse solver."""

    bench: FigureBench
    worse: WorseSolver

    @property
    def figure(self) -> Figure:
        return self.bench.figure

    def solver(self, identifier: str) -> WorseSolver:
        return self.worse

    def keep(self, poses: Sequence[Pose], locks: Sequence[Lock], movable: frozenset[int]) -> tuple[Kept, ...]:
        return self.bench.keep(poses, locks, movable)


def nearest_two(figure: Figure, poses: Sequence[Pose]) -> float:
    return min(closeness(figure, a, b) for n, a in enumerate(poses) for b in poses[:n])


def worse(hybrid: Hybrid, keeps: int) -> tuple[Hybrid, WorseSolver]:
    solver = WorseSolver(hybrid.bench.solver("ik.dls"), keeps)
    return Hybrid.on(WorseBench(hybrid.bench, solver)), solver  # type: ignore[arg-type]


def test_three_pages_show_27_poses_that_look_different_and_keep_the_locks(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    shown: list[Pose] = [opening.seed]
    state = opening
    for page in range(3):
        offer = hybrid.ask(state)
        assert len(offer.candidates) == 9
        assert not any(broken(humanoid, pose, opening.locks) for pose in offer.candidates)
        shown += offer.candidates
        state = hybrid.tell(state, Control("next")) if page < 2 else state
    assert nearest_two(humanoid, shown) > 0.05 * body_height(humanoid)


def test_intensity_0_shows_the_seed_nine_times(hybrid: Hybrid, opening: HybridState) -> None:
    state = hybrid.tell(hybrid.tell(opening, Control("intensity", 0)), Control("mutate"))
    assert hybrid.ask(state).candidates == (opening.seed,) * 9


def test_a_smaller_intensity_stays_nearer_to_the_seed(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    farthest = []
    for intensity in (5, 30, 90):
        state = hybrid.tell(hybrid.tell(opening, Control("intensity", intensity)), Control("mutate"))
        offered = hybrid.ask(state).candidates
        assert len(offered) == 9
        farthest.append(max(closeness(humanoid, opening.seed, pose) for pose in offered))
    assert farthest == sorted(farthest)


def test_candidates_that_cannot_keep_the_locks_are_replaced(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    half, solver = worse(hybrid, 3)
    offer = half.ask(opening)
    assert len(offer.candidates) == 9
    assert offer.note == ""
    assert not any(broken(humanoid, pose, opening.locks) for pose in offer.candidates)
    assert 18 < solver.solved <= MOST_TRIES


def test_a_page_with_fewer_than_nine_says_so_with_counts(hybrid: Hybrid, opening: HybridState) -> None:
    tenth, solver = worse(hybrid, 10)
    offer = tenth.ask(opening)
    assert len(offer.candidates) == 4
    assert solver.solved == MOST_TRIES
    assert offer.note == "only 4 of 40 proposals; 36 could not keep the locks"


def test_a_page_without_any_shows_the_seed_and_says_so(hybrid: Hybrid, opening: HybridState) -> None:
    never, _ = worse(hybrid, 1000)
    offer = never.ask(opening)
    assert offer.candidates == (opening.seed,)
    assert offer.note == "none of 40 proposals; 40 could not keep the locks; this is your pose"


def test_locks_that_no_pose_keeps_end_in_one_sentence(hybrid: Hybrid, humanoid: Figure, standing: Pose) -> None:
    far = (Pin(humanoid.index("lefthand"), (0.0, 0.0, 0.0)), Pin(humanoid.index("leftfoot"), (900.0, 0.0, 0.0)))
    offer = hybrid.ask(hybrid.start(Setting(standing, frozenset(humanoid.movable), fresh=True, locks=far)))
    assert offer.candidates == (standing,)
    assert offer.note == "the locks cannot be kept from this pose; release one; this is your pose"


def test_a_missing_solver_is_said_and_the_pose_stays(hybrid: Hybrid, opening: HybridState) -> None:
    class Bare(WorseBench):
        def solver(self, identifier: str) -> WorseSolver:
            raise ImpossibleError("the solver is still being compiled; try again in a few seconds")

    offer = Hybrid.on(Bare(hybrid.bench, None)).ask(opening)  # type: ignore[arg-type]
    assert offer.candidates == (opening.seed,)
    assert offer.note.startswith("the solver is still being compiled")


def test_proposals_that_look_alike_are_left_out_and_counted(hybrid: Hybrid, humanoid: Figure, standing: Pose) -> None:
    enabled = frozenset({humanoid.index("leftfoot")})
    state = hybrid.start(Setting(standing, enabled, fresh=True, locks=()))
    offer = hybrid.ask(state)
    assert 0 < len(offer.candidates) < 9
    assert (
        offer.note
        == f"only {len(offer.candidates)} of 40 proposals; {40 - len(offer.candidates)} looked like another one"
    )


def test_nothing_that_may_move_is_said(hybrid: Hybrid, standing: Pose) -> None:
    offer = hybrid.ask(hybrid.start(Setting(standing, frozenset(), fresh=True)))
    assert offer.candidates == (standing,)
    assert offer.note.startswith("no end may move")


def test_disabled_limbs_and_locked_joints_keep_their_bits(
    hybrid: Hybrid, humanoid: Figure, standing: Pose, planted: tuple[Lock, ...]
) -> None:
    spine, neck, arm = humanoid.indices(["spine", "neck", "rightupperarm"])
    pose = standing.with_joint(spine, -10.123456, 3, 0).with_joint(neck, 4, 5, 6).with_joint(arm, 20, 30, 1)
    locks = (*planted, JointLock(neck))
    enabled = frozenset(humanoid.movable) - {spine, arm}
    offer = hybrid.ask(hybrid.start(Setting(pose, enabled, fresh=False, locks=locks)))
    assert len(offer.candidates) == 9
    for candidate in offer.candidates:
        assert np.array_equal(candidate.angles[[spine, neck, arm]], pose.angles[[spine, neck, arm]])


def test_the_body_stays_unless_it_may_be_carried(hybrid: Hybrid, opening: HybridState) -> None:
    assert opening.carries_root
    assert any(pose.translation.any() for pose in hybrid.ask(opening).candidates)
    still = hybrid.tell(hybrid.tell(opening, Control("root", value=False)), Control("mutate"))
    for pose in hybrid.ask(still).candidates:
        assert not pose.translation.any()
        assert not pose.angles[0].any()


def test_limits_are_kept(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    state = hybrid.tell(hybrid.tell(opening, Control("intensity", 100)), Control("mutate"))
    for pose in hybrid.ask(state).candidates:
        low, high = humanoid.arrays.limits[1:, :, 0], humanoid.arrays.limits[1:, :, 1]
        assert (pose.angles[1:] >= low).all()
        assert (pose.angles[1:] <= high).all()


def test_holds_bands_and_turns_are_heeded(hybrid: Hybrid, humanoid: Figure, standing: Pose) -> None:
    left, right, head = humanoid.indices(["lefthand", "righthand", "head"])
    locks = (
        Hold(right, left, (-50.0, 0.0, 0.0)),
        lock_at(humanoid, standing, "orientation", head),
        Band(left, (20.0, 10.0, -30.0)),
    )
    state = hybrid.start(Setting(standing, frozenset(humanoid.movable), fresh=True, locks=locks))
    offer = hybrid.ask(state)
    assert len(offer.candidates) == 9
    assert not any(broken(humanoid, pose, locks) for pose in offer.candidates)


@pytest.mark.parametrize("name", ["spider", "robotarm", "juxo", "hand", "horse"])
def test_other_figures_get_nine_as_well(hybrid_on: object, name: str) -> None:
    other: Hybrid = hybrid_on(name)  # type: ignore[operator]
    figure = other.figure
    state = other.start(Setting(Pose.rest(figure), frozenset(figure.movable), fresh=True))
    offer = other.ask(state)
    assert len(offer.candidates) == 9
    assert nearest_two(figure, offer.candidates) > 0.05 * body_height(figure)


def test_a_spider_keeps_its_feet_on_the_ground(hybrid_on: object) -> None:
    spider: Hybrid = hybrid_on("spider")  # type: ignore[operator]
    figure, rest = spider.figure, Pose.rest(spider.figure)
    feet = [limb.index for limb in figure.limbs if "tarsus" in limb.name]
    locks = tuple(lock_at(figure, rest, "place", limb) for limb in feet)
    state = spider.start(Setting(rest, frozenset(figure.movable), fresh=True, locks=locks))
    offer = spider.ask(replace(state))
    assert len(offer.candidates) == 9
    assert not any(broken(figure, pose, locks) for pose in offer.candidates)


def test_pinned_feet_stay_nearly_flat_and_the_body_nearly_upright(
    hybrid: Hybrid, humanoid: Figure, opening: HybridState
) -> None:
    state = hybrid.tell(hybrid.tell(opening, Control("intensity", 40)), Control("mutate"))
    standing = place_pose(humanoid, opening.seed).limb_to_world
    for limb in (0, *humanoid.indices(["rightfoot", "leftfoot"])):
        now = [place_pose(humanoid, pose).limb_to_world[limb] for pose in hybrid.ask(state).candidates]
        turned = [np.linalg.norm(rotation_vector(standing[limb].T @ each)) for each in now]
        assert np.mean(turned) < 15  # degrees; 19 to 27 without care


def test_with_aim_ends_are_turned_too(hybrid: Hybrid, humanoid: Figure, opening: HybridState) -> None:
    aimed = hybrid.tell(hybrid.tell(opening, Control("aim", value=True)), Control("mutate"))
    hand = humanoid.index("lefthand")

    def turns(state: HybridState) -> float:
        return float(np.mean([np.abs(pose.angles[hand]).sum() for pose in hybrid.ask(state).candidates]))

    assert turns(aimed) > 1.2 * turns(opening)


def test_a_later_page_shows_nothing_that_an_earlier_one_showed(
    hybrid: Hybrid, humanoid: Figure, standing: Pose
) -> None:
    state = hybrid.start(Setting(standing, frozenset({humanoid.index("neck")}), fresh=True))
    first, second = hybrid.ask(state).candidates, hybrid.ask(hybrid.tell(state, Control("next"))).candidates
    assert nearest_two(humanoid, [standing, *first, *second]) > 0.05 * body_height(humanoid)


def test_a_body_that_may_not_be_carried_stays_when_candidates_follow_a_pick(
    hybrid: Hybrid, humanoid: Figure, standing: Pose
) -> None:
    left, right = humanoid.indices(["lefthand", "righthand"])
    locks = (Hold(right, left, (-50.0, 0.0, 0.0)), Pin(humanoid.index("head"), (0.0, 77.0, -15.0)))
    state = hybrid.start(Setting(standing, frozenset(humanoid.movable), fresh=True, locks=locks))
    state = hybrid.tell(hybrid.tell(state, Control("root", value=False)), Control("mutate"))
    state = hybrid.tell(state, LimbPick(0, (left,)))
    shown = hybrid.ask(state).candidates
    assert len(shown) > 4
    for pose in (*shown, hybrid.recommend(state)):
        assert not broken(humanoid, pose, locks)
        assert not pose.translation.any()
        assert not pose.angles[0].any()
