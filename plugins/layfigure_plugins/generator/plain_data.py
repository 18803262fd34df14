"""The generator's state as JSON-ready plain data, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from layfigure.figures.figure import Figure
from layfigure.poses.lock_words import read_locks, write_locks
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.techniques.plain_data import limb_names, limbs_named, reading
from layfigure_plugins.generator.address import read_address, write_address
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.state import GeneratorState

VERSION = 1


def dumped(figure: Figure, state: GeneratorState) -> dict[str, Any]:
    """Return the state as plain data; the generation is written as the address of its page."""
    return {
        "version": VERSION,
        "seed": pack_pose(figure, state.seed),
        "page": write_address(figure, state.generation, state.page),
        "intensity": state.intensity,
        "kind": state.kind,
        "enabled": limb_names(figure, state.enabled),
        **({"locks": write_locks(figure, state.locks)} if state.locks else {}),
    }


def loaded(figure: Figure, data: Mapping[str, Any]) -> GeneratorState:
    """Return the state that plain data describes.

    Raises:
        LayfigureError: another version, another figure, or damaged data.
    """
    with reading("the generator", data, VERSION):
        generation, page = read_address(figure, data["page"])
        return GeneratorState(
            seed=unpack_pose(figure, data["seed"]),
            generation=generation,
            page=page,
            intensity=_checked_intensity(data["intensity"]),
            kind=_checked_kind(data["kind"]),
            enabled=limbs_named(figure, data["enabled"]),
            locks=read_locks(figure, data.get("locks", "")),
        )


def _checked_intensity(value: Any) -> float:
    if not 0 <= value <= 100:
        raise ValueError(f"intensity {value}")
    return float(value)


def _checked_kind(value: Any) -> str:
    if value not in (SWING, TWIST):
        raise ValueError(f"kind {value}")
    return str(value)
