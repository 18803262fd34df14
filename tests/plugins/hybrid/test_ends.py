"""Which ends move, and which limbs belong together."""

from __future__ import annotations

import itertools

import pytest

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.poses.locks import Band, Hold, Pin
from layfigure_plugins.hybrid.ends import MOST_ENDS, chains_with, effectors, leaves, reach, stretches


def named(figure: Figure, limbs: object) -> list[str]:
    return [figure.names[limb] for limb in limbs]  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("figure", "ends"),
    [
        ("humanoid", {"rightfoot", "leftfoot", "righthand", "lefthand", "head"}),
        ("robotarm", {"rightfinger", "leftfinger"}),
    ],
)
def test_the_ends_are_the_leaves(figure: str, ends: set[str]) -> None:
    assert set(named(load_figure(figure), leaves(load_figure(figure)))) == ends


def test_a_spider_has_eight_feet_among_its_ends() -> None:
    spider = load_figure("spider")
    assert sum(name.startswith(("righttarsus", "lefttarsus")) for name in named(spider, leaves(spider))) == 8


def test_what_is_pinned_or_held_gets_no_goal_and_what_is_pulled_does(humanoid: Figure) -> None:
    right, left, head = humanoid.indices(["righthand", "lefthand", "head"])
    locks = (Pin(right, (0, 0, 0)), Hold(left, right, (0, 0, 0)), Band(head, (0, 0, 0)))
    found = effectors(humanoid, frozenset(), locks, frozenset(humanoid.movable))
    assert named(humanoid, found) == ["rightfoot", "leftfoot", "head"]


def test_an_end_whose_chain_may_not_move_gets_no_goal(humanoid: Figure) -> None:
    free = frozenset(humanoid.movable) - {humanoid.index(f"right{part}") for part in ("thigh", "leg", "foot")}
    assert "rightfoot" not in named(humanoid, effectors(humanoid, frozenset(), (), free))


@pytest.mark.parametrize(
    ("picked", "chain"),
    [
        ("lefthand", ["leftupperarm", "leftforearm", "lefthand"]),
        ("leftupperarm", ["leftupperarm", "leftforearm", "lefthand"]),
        ("leftshoulders", ["leftupperarm", "leftforearm", "lefthand"]),
        ("head", ["neck"]),
        ("rightleg", ["rightthigh", "rightleg", "rightfoot"]),
        ("spine", ["top", "spine"]),
        ("top", ["top", "spine"]),
    ],
)
def test_a_picked_limb_brings_its_whole_chain(humanoid: Figure, picked: str, chain: list[str]) -> None:
    found = chains_with(humanoid, frozenset({humanoid.index(picked)}))
    assert sorted(named(humanoid, found)) == sorted(chain)


def test_a_chain_is_as_long_as_its_limbs(humanoid: Figure) -> None:
    assert reach(humanoid, humanoid.index("rightfoot")) == pytest.approx(45 + 55 + 30)
    assert reach(humanoid, humanoid.index("righthand")) == pytest.approx(50 + 25 + 33 + 25 + 12)


def test_chains_are_split_where_they_meet(humanoid: Figure) -> None:
    ends = humanoid.indices(["righthand", "lefthand", "head"])
    arm, trunk = stretches(humanoid, ends[0], ends)
    assert (arm.ends, trunk.ends) == (ends[:1], ends)
    assert arm.length == pytest.approx(33 + 25 + 12)


def test_of_very_many_ends_a_few_spread_evenly_move_unless_they_are_chosen(tmp_path) -> None:
    rays = " ".join(
        f"joint 0 0 0 ray{count} {{ 0 0 0 0 9 0 flexiondof -90 90 sphere 0 9 0 1 grey }}" for count in range(60)
    )
    (tmp_path / "star.fig").write_text(f"star {{ 0 0 0 0 0 0 {rays} }}")
    star = load_figure(str(tmp_path / "star.fig"))
    free = frozenset(star.movable)
    moving = effectors(star, frozenset(), (), free)
    assert len(leaves(star)) == 60 and len(moving) == MOST_ENDS and moving[0] == leaves(star)[0]
    assert max(b - a for a, b in itertools.pairwise(moving)) <= 4
    assert len(effectors(star, free, (), free)) == 60
