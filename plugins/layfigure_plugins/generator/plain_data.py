"""The generator's state as JSON-ready plain data, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure_plugins.generator.address import read_address, write_address
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.condition_words import read_locks, write_locks
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
        "enabled": [figure.names[limb] for limb in sorted(state.enabled)],
        **({"locks": write_locks(figure, state.locks)} if state.locks else {}),
    }


def loaded(figure: Figure, data: Mapping[str, Any]) -> GeneratorState:
    """Return the state that plain data describes.

    Raises:
        LayfigureError: another version, another figure, or damaged data.
    """
    if data.get("version") != VERSION:
        raise LayfigureError(f"the generator reads states of version {VERSION}, this one is {data.get('version')!r}")
    try:
        generation, page = read_address(figure, data["page"])
        return GeneratorState(
            seed=unpack_pose(figure, data["seed"]),
            generation=generation,
            page=page,
            intensity=_checked_intensity(data["intensity"]),
            kind=_checked_kind(data["kind"]),
            enabled=frozenset(figure.indices(data["enabled"])),
            locks=read_locks(figure, data.get("locks", "")),
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise LayfigureError(f"the generator's state is damaged ({error}); start the technique again") from None


def _checked_intensity(value: Any) -> float:
    if not 0 <= value <= 100:
        raise ValueError(f"intensity {value}")
    return float(value)


def _checked_kind(value: Any) -> str:
    if value not in (SWING, TWIST):
        raise ValueError(f"kind {value}")
    return str(value)
