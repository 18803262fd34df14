"""The interactive genetic algorithm: grade nine poses and breed the next nine (thesis III; the studies' baseline)."""

from __future__ import annotations

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Technique
from layfigure.techniques.contract import Action, Choice, Shortcut, Slider
from layfigure_plugins.genetic.genetic import Genetic

_CROSSOVERS = (
    ("one-point", "1-pt"),
    ("two-point", "2-pt"),
    ("uniform", "Unif."),
    ("blended", "Blend"),
    ("analogous", "Alike"),
    ("segregation", "Segr."),
)

_CONTROLS = (
    Action("evolve", "Breed", keys=("m",)),
    Shortcut(tuple("0123456789"), "grade {key}", "Grade the candidate and go to the next", hint="grade"),
    Shortcut(("+",), "grade 10", "Grade the candidate 10", hint="10"),
    Shortcut(("n", "pagedown"), "choose next", "Choose the next candidate"),
    Shortcut(("shift+n", "pageup"), "choose previous", "Choose the candidate before"),
    Shortcut(("enter",), "copy-all", "Take the candidate as the pose", hint="take"),
    Slider("mutation", "Mutation", low=0, high=100, step=5, keys=("<", ">"), unit=" %"),
    Choice("crossover", "Crossover", options=_CROSSOVERS, keys=("c",)),
    Choice("population", "Population", options=(("9", "9"), ("12", "12")), keys=("p",)),
)


@hookimpl
def layfigure_techniques() -> list[Technique]:
    """Return the genetic algorithm."""
    return [
        Technique(
            id="ga",
            title="Genetic",
            make=Genetic.on,
            channels=frozenset({"grade", "best", "control"}),
            controls=_CONTROLS,
        )
    ]
