"""Page addresses: one short word that leads back to the same nine poses, bit for bit.

``humanoid:2.1:next-swing-40:3fff:POSE`` is page 1 of generation 2, made by next-generation rules in swing at intensity
40 with the movable limbs of the mask enabled, round a packed pose. Limbs that go on varying follow the mask, as in
``3fff+7s+9t``. What a page must fulfil is there only where there is something: filters and the spread after the
intensity, as in ``next-swing-40+floor+apart``, and locks after the pose, behind the mask of the limbs that may turn to
keep them, as in ``POSE:3fff~place,leftfoot,16,-100,-30``.
"""

from __future__ import annotations

import re

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.lock_words import read_locks, write_locks
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure_plugins.generator.alternatives import SWING, TWIST
from layfigure_plugins.generator.condition_words import read_choice, write_choice
from layfigure_plugins.generator.conditions import Conditions
from layfigure_plugins.generator.state import PAGES, Generation

_ADDRESS = re.compile(
    r"(?P<figure>.+):(?P<number>\d{1,6})\.(?P<page>\d):(?P<rules>first|next)-(?P<kind>swing|twist)-"
    r"(?P<intensity>[0-9.e-]{1,24})(?P<choice>(?:\+[a-z]{1,20}){0,9}):"
    r"(?P<enabled>[0-9a-f]{1,64})(?P<varied>(?:\+\d{1,4}[st])*):(?P<pose>[^:\s]+)"
    r"(?::(?P<free>[0-9a-f]{1,64})~(?P<locks>[^:\s]+))?"
)
_KINDS = {"s": SWING, "t": TWIST}


def write_address(figure: Figure, generation: Generation, page: int) -> str:
    """Return the address of page ``page`` (from 0) of a generation."""
    rules = "first" if generation.within_limits else "next"
    conditions = generation.conditions
    varied = "".join(f"+{limb}{kind[0]}" for limb, kind in generation.varied)
    choice = write_choice(conditions.filters, conditions.spread)
    how = f"{rules}-{generation.kind}-{repr(generation.intensity).removesuffix('.0')}{choice}"
    who = f"{_mask(figure, generation.enabled)}{varied}:{pack_pose(figure, generation.base)}"
    locks = f":{_mask(figure, conditions.free)}~{write_locks(figure, conditions.locks)}" if conditions.locks else ""
    return f"{figure.name}:{generation.number}.{page + 1}:{how}:{who}{locks}"


def read_address(figure: Figure, address: str) -> tuple[Generation, int]:
    """Return the generation and page (from 0) that an address leads to.

    Raises:
        ImpossibleError: it is not an address, or one of another figure.
        LayfigureError: its pose is damaged.
    """
    found = _ADDRESS.fullmatch(address)
    if not found:
        raise ImpossibleError("that is not the address of a page; copy the whole of it")
    if found["figure"].casefold() != figure.name.casefold():
        raise ImpossibleError(f"that address is of the figure {found['figure']}; open that figure first")
    generation = Generation(
        base=unpack_pose(figure, found["pose"]),
        number=int(found["number"]),
        within_limits=found["rules"] == "first",
        intensity=_intensity(found["intensity"]),
        kind=found["kind"],
        enabled=_enabled(figure, int(found["enabled"], 16)),
        varied=tuple(_varied(figure, text) for text in found["varied"].split("+")[1:]),
        conditions=_conditions(figure, found),
    )
    page = int(found["page"]) - 1
    if not 0 <= page < PAGES:
        raise ImpossibleError(f"that address is of page {page + 1}, but a generation has {PAGES} pages")
    return generation, page


def _conditions(figure: Figure, found: re.Match[str]) -> Conditions:
    filters, spread = read_choice(found["choice"])
    if found["locks"] is None:
        return Conditions(filters=filters, spread=spread)
    free = _enabled(figure, int(found["free"], 16))
    return Conditions(read_locks(figure, found["locks"]), free, filters, spread)


def _mask(figure: Figure, limbs: frozenset[int]) -> str:
    return f"{sum(1 << place for place, limb in enumerate(figure.movable) if limb in limbs):x}"


def _intensity(text: str) -> float:
    try:
        intensity = float(text)
    except ValueError:
        intensity = -1.0
    if not 0 <= intensity <= 100:
        raise ImpossibleError(f"that address has an intensity of {text}; intensities go from 0 to 100")
    return intensity


def _enabled(figure: Figure, mask: int) -> frozenset[int]:
    if mask >> len(figure.movable):
        raise ImpossibleError(f"that address enables more limbs than the figure {figure.name} has")
    return frozenset(limb for place, limb in enumerate(figure.movable) if mask >> place & 1)


def _varied(figure: Figure, text: str) -> tuple[int, str]:
    limb = int(text[:-1])
    if limb not in figure.movable:
        raise ImpossibleError(f"that address varies a limb that the figure {figure.name} cannot move")
    return limb, _KINDS[text[-1]]
