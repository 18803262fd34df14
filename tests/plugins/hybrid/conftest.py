"""The hybrid at work on shipped figures, with the house's solver."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from layfigure import compiled
from layfigure.figures.figure import Figure
from layfigure.figures.library import load_figure
from layfigure.plugins.host import Host
from layfigure.poses.locks import Lock, lock_at
from layfigure.poses.pose import Pose
from layfigure.session.bench import FigureBench, Solvers
from layfigure.techniques.contract import Setting
from layfigure_plugins.hybrid.hybrid import Hybrid
from layfigure_plugins.hybrid.state import HybridState

MakeHybrid = Callable[[str], Hybrid]


@pytest.fixture(scope="session")
def solvers() -> Solvers:
    compiled.load()
    return Solvers(Host.discover())


@pytest.fixture(scope="session")
def hybrid_on(solvers: Solvers) -> MakeHybrid:
    """Makes the technique for a shipped figure."""
    return lambda name: Hybrid.on(FigureBench(load_figure(name), {}, solvers))


@pytest.fixture(scope="session")
def hybrid(hybrid_on: MakeHybrid) -> Hybrid:
    return hybrid_on("humanoid")


@pytest.fixture(scope="session")
def humanoid(hybrid: Hybrid) -> Figure:
    return hybrid.figure


@pytest.fixture(scope="session")
def standing(humanoid: Figure) -> Pose:
    return Pose.rest(humanoid)


@pytest.fixture(scope="session")
def planted(humanoid: Figure, standing: Pose) -> tuple[Lock, ...]:
    """Both feet pinned where they stand."""
    return tuple(lock_at(humanoid, standing, "place", humanoid.index(name)) for name in ("rightfoot", "leftfoot"))


@pytest.fixture(scope="session")
def opening(hybrid: Hybrid, humanoid: Figure, standing: Pose, planted: tuple[Lock, ...]) -> HybridState:
    """The first generation of a standing figure with both feet pinned."""
    return hybrid.start(Setting(standing, frozenset(humanoid.movable), fresh=True, locks=planted))
