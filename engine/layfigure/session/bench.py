"""The bench: what the house lends to techniques, solvers above all."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from layfigure import compiled
from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.plugins.host import Host
from layfigure.poses.locks import Lock
from layfigure.poses.pose import Pose
from layfigure.suggestions import did_you_mean
from layfigure.techniques.contract import Kept
from layfigure.techniques.keeping import keep
from layfigure.techniques.solving import SolverObject

Option = float | str | bool

KEEPER = "ik.dls"
"""The solver that brings poses back to their locks."""


class Solvers:
    """The solvers of one session, made once per figure and kept.

    ``waits`` says whether a compiled solver is waited for: a replay must not depend on what is ready yet, but a window
    stays usable while it is compiled. ``await_compiled`` is called where it is not waited for and not ready; a front
    end that wants to say that it waits puts its waiting there.
    """

    def __init__(self, host: Host) -> None:
        self.waits = True
        self._host = host
        self.await_compiled: Callable[[], None] = lambda: None
        self._made: dict[tuple[str, int], tuple[Figure, SolverObject]] = {}

    def get(self, identifier: str, figure: Figure) -> SolverObject:
        """Return a solver for a figure.

        Raises:
            ImpossibleError: no such solver is in service, or it is not compiled yet.
            PluginError: making it failed, and its plug-in was set aside.
        """
        record = self._host.solvers.get(identifier)
        if record is None:
            known = ", ".join(self._host.solvers) or "none"
            hint = did_you_mean(identifier, self._host.solvers)
            raise ImpossibleError(f'there is no solver "{identifier}"; in service: {known}{hint}')
        if record.compiled and self.waits:
            compiled.load()
        if record.compiled and not compiled.loaded():
            self.await_compiled()
        if record.compiled and not compiled.loaded():
            raise ImpossibleError("the solver is still being compiled; try again in a few seconds")
        key = (identifier, id(figure))
        if key not in self._made:
            self._made[key] = (figure, self._host.call(record, "making", record.make, figure))
        return self._made[key][1]


@dataclass(frozen=True)
class FigureBench:
    """The bench a technique is made with."""

    figure: Figure
    options: Mapping[str, Option]
    solvers: Solvers

    def option(self, name: str, default: Option) -> Option:
        """Return a user's setting for this technique, or the default."""
        return self.options.get(name, default)

    def solver(self, identifier: str) -> SolverObject:
        """Return a plug-in's solver for the figure.

        Raises:
            ImpossibleError: no such solver is in service, or it is not compiled yet.
        """
        return self.solvers.get(identifier, self.figure)

    def keep(self, poses: Sequence[Pose], locks: Sequence[Lock], movable: frozenset[int]) -> tuple[Kept, ...]:
        """Return poses brought back to their locks by turning the root and ``movable`` joints and carrying the root.

        Raises:
            ImpossibleError: there are locks on ends, and no solver is in service.
        """
        return keep(lambda: self.solver(KEEPER), self.figure, (poses, locks, movable | {0}))
