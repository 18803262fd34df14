"""Reach: inverse kinematics as the thesis has it, by translations passed from limb to limb."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Solver
from layfigure_plugins.reach.solver import Reach


@hookimpl
def layfigure_solvers() -> list[Solver]:
    """Return the solver of the thesis."""
    return [Solver("ik.reach", "Reach (thesis)", Reach)]
