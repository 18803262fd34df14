"""The genetic algorithm's state as JSON-ready plain data, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.techniques.plain_data import limb_names, limbs_named, lock_lists, locks_listed, reading
from layfigure_plugins.genetic.chromosome import TOP, Chromosome
from layfigure_plugins.genetic.crossover import CROSSOVERS
from layfigure_plugins.genetic.population import Breeding
from layfigure_plugins.genetic.state import BEST_GRADE, SIZES, GeneticState

VERSION = 1


def dumped(figure: Figure, state: GeneticState) -> dict[str, Any]:
    """Return the state as plain data; a chromosome is a list of its genes: joint, flexion, pivot, twist."""
    return {
        "version": VERSION,
        "figure": figure.name,
        "pose": pack_pose(figure, state.pose),
        "base": pack_pose(figure, state.base),
        "enabled": limb_names(figure, state.enabled),
        "locks": lock_lists(figure, state.locks),
        "seed": state.seed,
        "generation": state.generation,
        "population": [_genes(figure, chromosome) for chromosome in state.population],
        "grades": list(state.grades),
        "crossover": state.breeding.crossover,
        "size": state.breeding.size,
        "mutation": state.breeding.mutation,
    }


def loaded(figure: Figure, data: Mapping[str, Any]) -> GeneticState:
    """Return the state that plain data describes.

    Raises:
        LayfigureError: another version, another figure, or damaged data.
    """
    with reading("the genetic algorithm", data, VERSION):
        if data.get("figure") != figure.name:
            raise LayfigureError(f"the state is of the figure {data.get('figure')!r}, not of {figure.name}")
        return _read(figure, data)


def _read(figure: Figure, data: Mapping[str, Any]) -> GeneticState:
    population = tuple(_chromosome(figure, genes) for genes in data["population"])
    grades = tuple(None if grade is None else _whole(grade, BEST_GRADE) for grade in data["grades"])
    if len(grades) != len(population) or len(population) not in SIZES:
        raise ValueError(f"{len(population)} individuals, {len(grades)} grades")
    return GeneticState(
        pose=unpack_pose(figure, data["pose"]),
        base=unpack_pose(figure, data["base"]),
        enabled=limbs_named(figure, data["enabled"]) & frozenset(figure.movable),
        locks=locks_listed(figure, data["locks"]),
        seed=_whole(data["seed"], 2**63),
        breeding=_breeding(data),
        generation=_whole(data["generation"], 2**63),
        population=population,
        grades=grades,
    )


def _genes(figure: Figure, chromosome: Chromosome) -> list[list[Any]]:
    rows = chromosome.alleles.tolist()
    return [[figure.names[limb], *row] for limb, row in zip(chromosome.loci, rows, strict=True)]


def _chromosome(figure: Figure, genes: Any) -> Chromosome:
    loci = figure.indices([name for name, *_ in genes])
    if sorted(loci) != sorted(figure.movable):
        raise ValueError("a chromosome lacks a joint or has one twice")
    alleles = [[_whole(number, TOP) for number in numbers] for _, *numbers in genes]
    if any(len(row) != 3 for row in alleles):
        raise ValueError("a gene has not three numbers")
    return Chromosome.of(loci, alleles)  # type: ignore[arg-type]


def _breeding(data: Mapping[str, Any]) -> Breeding:
    crossover, size, rate = data["crossover"], data["size"], data["mutation"]
    if crossover not in CROSSOVERS or size not in SIZES or isinstance(rate, bool | str) or not 0 <= rate <= 100:
        raise ValueError(f"crossover {crossover!r}, population {size!r}, mutation {rate!r}")
    return Breeding(crossover, size, float(rate))


def _whole(value: Any, top: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= top:
        raise ValueError(f"{value!r} is not a whole number from 0 to {top}")
    return value
