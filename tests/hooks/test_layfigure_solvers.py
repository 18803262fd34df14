"""Hook layfigure_solvers: a stranger's solver is had from the bench by its id."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Solver
from layfigure.poses.pose import Pose
from layfigure.techniques.solving import Problem, Solution
from layfigure.testing import TestingBench, make_host


class Still:
    def __init__(self, figure):
        self.figure = figure

    def solve(self, pose, problem):
        return Solution(pose, (), met=not problem.tasks)


class Bringing:
    @hookimpl
    def layfigure_solvers(self):
        return [Solver("ik.still", "Still", Still)]


def test_a_solver_is_made_for_the_figure_and_kept():
    bench = TestingBench("horse", host=make_host(Bringing()))
    solver = bench.solver("ik.still")
    assert solver.figure is bench.figure and bench.solver("ik.still") is solver
    assert solver.solve(Pose.rest(bench.figure), Problem((), frozenset())).met
