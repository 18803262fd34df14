"""Which limbs follow when some begin to move."""

from __future__ import annotations

import pytest

from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.poses.locks import Hold, JointLock, Pin
from layfigure.techniques.chains import following
from layfigure.techniques.solving import chain_of


@pytest.fixture(scope="module")
def humanoid() -> Figure:
    return load_figure("humanoid")


def chain(figure: Figure, name: str) -> frozenset[int]:
    return chain_of(figure, figure.index(name), 0)


def test_without_locks_nothing_follows(humanoid: Figure) -> None:
    arm = chain(humanoid, "lefthand")
    assert following(humanoid, arm, (JointLock(2),)) == (arm, ())


def test_an_end_pinned_elsewhere_is_not_touched(humanoid: Figure) -> None:
    arm = chain_of(humanoid, humanoid.index("lefthand"), 3)
    assert following(humanoid, arm, (Pin(humanoid.index("righthand"), (0, 0, 0)),)) == (arm, ())


def test_a_pinned_end_that_would_be_carried_along_brings_its_chain(humanoid: Figure) -> None:
    pin = Pin(humanoid.index("righthand"), (0, 0, 0))
    limbs, locks = following(humanoid, chain(humanoid, "lefthand"), (pin,))
    assert limbs == chain(humanoid, "lefthand") | chain(humanoid, "righthand")
    assert locks == (pin,)


def test_a_hold_brings_both_chains(humanoid: Figure) -> None:
    hold = Hold(humanoid.index("righthand"), humanoid.index("leftthigh"), (0, 0, 0))
    limbs, _ = following(humanoid, chain(humanoid, "leftfoot"), (hold,))
    assert limbs == chain(humanoid, "leftfoot") | chain(humanoid, "righthand")


def test_a_carried_root_touches_every_lock(humanoid: Figure) -> None:
    pins = tuple(Pin(limb, (0, 0, 0)) for limb in humanoid.indices(["rightfoot", "leftfoot"]))
    limbs, locks = following(humanoid, frozenset({0}), pins, carried=True)
    assert limbs == {0} | chain(humanoid, "rightfoot") | chain(humanoid, "leftfoot")
    assert locks == pins
