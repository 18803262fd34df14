"""Every technique, renderer and solver that is installed keeps the laws that the kit holds a stranger's to."""

import pytest
from tests.plugins.axis_figures import AXIS_FIGURES, axis_figure

from layfigure import compiled
from layfigure.figures.library import figure_names
from layfigure.plugins.host import Host
from layfigure.testing import check_renderer, check_solver, check_technique

INSTALLED = Host.discover()
LEAVES_LIMITS = {"generator"}
"""Techniques whose next generations leave limits on purpose, so that uncommon poses stay within reach (posing.md 5)."""


@pytest.fixture(scope="module")
def host() -> Host:
    """A host with everything installed, and machine code ready."""
    compiled.load()
    return Host.discover()


def test_everything_installed_is_in_service():
    assert INSTALLED.faults == []
    assert INSTALLED.techniques and INSTALLED.renderers


@pytest.mark.parametrize("figure", figure_names())
@pytest.mark.parametrize("technique", INSTALLED.techniques)
def test_a_technique_keeps_the_laws(host, technique, figure):
    keeps_limits = technique not in LEAVES_LIMITS
    check_technique(host.techniques[technique], [figure], host=host, keeps_limits=keeps_limits)


@pytest.mark.parametrize("figure", AXIS_FIGURES)
@pytest.mark.parametrize("technique", INSTALLED.techniques)
def test_a_technique_keeps_the_laws_where_joints_turn_about_x_y_and_z(host, technique, figure):
    keeps_limits = technique not in LEAVES_LIMITS
    check_technique(host.techniques[technique], [axis_figure(figure)], host=host, keeps_limits=keeps_limits)


@pytest.mark.parametrize("renderer", INSTALLED.renderers)
def test_a_renderer_keeps_the_laws(host, renderer):
    check_renderer(host.renderers[renderer])


@pytest.mark.parametrize("figure", figure_names())
@pytest.mark.parametrize("solver", INSTALLED.solvers)
def test_a_solver_keeps_the_laws(host, solver, figure):
    check_solver(host.solvers[solver], [figure])
