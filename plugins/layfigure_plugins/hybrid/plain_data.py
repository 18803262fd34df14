"""The hybrid's state as JSON-ready plain data, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.lock_words import lock_words, read_lock
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure_plugins.hybrid.address import read_address, write_address
from layfigure_plugins.hybrid.state import HybridState

VERSION = 1


def dumped(figure: Figure, state: HybridState) -> dict[str, Any]:
    """Return the state as plain data; the generation is written as the address of its page."""
    return {
        "version": VERSION,
        "seed": pack_pose(figure, state.seed),
        "page": write_address(figure, state.generation, state.page),
        "enabled": [figure.names[limb] for limb in sorted(state.enabled)],
        "locks": [list(lock_words(figure, lock)) for lock in state.locks],
        "intensity": state.intensity,
        "chosen": [figure.names[limb] for limb in sorted(state.chosen)],
        "aim": state.aim,
        "root": state.root,
    }


def loaded(figure: Figure, data: Mapping[str, Any]) -> HybridState:
    """Return the state that plain data describes.

    Raises:
        LayfigureError: another version, another figure, or damaged data.
    """
    if data.get("version") != VERSION:
        raise LayfigureError(f"the hybrid technique reads states of version {VERSION}, not {data.get('version')!r}")
    try:
        generation, page = read_address(figure, data["page"])
        return HybridState(
            seed=unpack_pose(figure, data["seed"]),
            generation=generation,
            enabled=frozenset(figure.indices(data["enabled"])),
            locks=tuple(read_lock(figure, words) for words in data["locks"]),
            page=page,
            intensity=_intensity(data["intensity"]),
            chosen=frozenset(figure.indices(data["chosen"])),
            aim=_switch(data["aim"]),
            root=None if data["root"] is None else _switch(data["root"]),
        )
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise LayfigureError(f"the state is damaged ({error}); start the technique again") from None


def _intensity(value: Any) -> float:
    if isinstance(value, bool) or not 0 <= value <= 100:
        raise ValueError(f"intensity {value}")
    return float(value)


def _switch(value: Any) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"a switch that is {value!r}")
    return value
