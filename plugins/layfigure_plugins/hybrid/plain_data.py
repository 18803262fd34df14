"""The hybrid's state as JSON-ready plain data, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from layfigure.figures.figure import Figure
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure.techniques.plain_data import limb_names, limbs_named, lock_lists, locks_listed, reading
from layfigure_plugins.hybrid.address import read_address, write_address
from layfigure_plugins.hybrid.state import HybridState

VERSION = 1


def dumped(figure: Figure, state: HybridState) -> dict[str, Any]:
    """Return the state as plain data; the generation is written as the address of its page."""
    return {
        "version": VERSION,
        "seed": pack_pose(figure, state.seed),
        "page": write_address(figure, state.generation, state.page),
        "enabled": limb_names(figure, state.enabled),
        "locks": lock_lists(figure, state.locks),
        "intensity": state.intensity,
        "chosen": limb_names(figure, state.chosen),
        "aim": state.aim,
        "root": state.root,
    }


def loaded(figure: Figure, data: Mapping[str, Any]) -> HybridState:
    """Return the state that plain data describes.

    Raises:
        LayfigureError: another version, another figure, or damaged data.
    """
    with reading("the hybrid technique", data, VERSION):
        generation, page = read_address(figure, data["page"])
        return HybridState(
            seed=unpack_pose(figure, data["seed"]),
            generation=generation,
            enabled=limbs_named(figure, data["enabled"]),
            locks=locks_listed(figure, data["locks"]),
            page=page,
            intensity=_intensity(data["intensity"]),
            chosen=limbs_named(figure, data["chosen"]),
            aim=_switch(data["aim"]),
            root=None if data["root"] is None else _switch(data["root"]),
        )


def _intensity(value: Any) -> float:
    if isinstance(value, bool) or not 0 <= value <= 100:
        raise ValueError(f"intensity {value}")
    return float(value)


def _switch(value: Any) -> bool:
    if not isinstance(value, bool):
        raise TypeError(f"a switch that is {value!r}")
    return value
