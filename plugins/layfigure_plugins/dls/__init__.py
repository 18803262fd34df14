"""The default solver for inverse kinematics: damped least squares in swing-twist coordinates, compiled.

Importing this package is cheap; numba is met when a solver is made.
"""

from __future__ import annotations

from layfigure.figures.figure import Figure
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Solver
from layfigure.techniques.solving import SolverObject


def _make(figure: Figure) -> SolverObject:
    from layfigure_plugins.dls.solver import DampedLeastSquares

    return DampedLeastSquares(figure)


def _warm() -> None:
    """Compile or load the kernel: it has an eager signature, so importing it is enough."""
    from layfigure_plugins.dls import solver  # noqa: F401


@hookimpl
def layfigure_solvers() -> list[Solver]:
    """Return the solver by damped least squares."""
    return [Solver(id="ik.dls", title="Damped least squares", make=_make, compiled=True, warm=_warm)]
