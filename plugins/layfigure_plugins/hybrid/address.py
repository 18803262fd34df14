"""Page addresses: one word that leads back to the same nine poses, bit for bit.

``hybrid:humanoid:2.1:50-root:10000:1fff:place,leftfoot,-16,-100,-30:POSE`` is page 1 of generation 2 at intensity 50,
the body carried, goals for the limbs of the first mask, the limbs of the second enabled, one lock, round a packed
pose. Locks are separated by ``+``. What was picked follows as the mask of its limbs and a second pose.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from urllib.parse import quote, unquote

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.poses.lock_words import lock_words, read_lock
from layfigure.poses.locks import Lock
from layfigure.poses.packing import pack_pose, unpack_pose
from layfigure_plugins.hybrid.state import PAGES, Generation

_ADDRESS = re.compile(
    r"hybrid:(?P<figure>.+):(?P<number>\d{1,6})\.(?P<page>\d):(?P<intensity>[0-9.e-]{1,24}?)(?P<aim>-aim)?"
    r"(?P<root>-root)?:(?P<chosen>[0-9a-f]{1,64}):(?P<enabled>[0-9a-f]{1,64}):(?P<locks>[^:\s]{0,20000}):"
    r"(?P<pose>[^:\s]+)(?::(?P<settled>[0-9a-f]{1,64}):(?P<picked>[^:\s]+))?"
)


def write_address(figure: Figure, generation: Generation, page: int) -> str:
    """Return the address of page ``page`` (from 0) of a generation."""
    intensity = repr(generation.intensity).removesuffix(".0")
    switches = "-aim" * generation.aim + "-root" * generation.root
    parts = [
        "hybrid",
        figure.name,
        f"{generation.number}.{page + 1}",
        intensity + switches,
        f"{_mask(generation.chosen):x}",
        f"{_mask(generation.enabled):x}",
        "+".join(_lock_text(figure, lock) for lock in generation.locks),
        pack_pose(figure, generation.base),
    ]
    if generation.settled:
        parts += [f"{_mask(generation.settled):x}", pack_pose(figure, generation.picked)]
    return ":".join(parts)


def read_address(figure: Figure, address: str) -> tuple[Generation, int]:
    """Return the generation and page (from 0) that an address leads to.

    Raises:
        ImpossibleError: it is not an address, or one of another figure.
        LayfigureError: its poses or locks are damaged.
    """
    found = _ADDRESS.fullmatch(address)
    if not found:
        raise ImpossibleError("that is not the address of a page of the hybrid technique; copy the whole of it")
    if found["figure"].casefold() != figure.name.casefold():
        raise ImpossibleError(f"that address is of the figure {found['figure']}; open that figure first")
    page = int(found["page"]) - 1
    if not 0 <= page < PAGES:
        raise ImpossibleError(f"that address is of page {page + 1}, but a generation has {PAGES} pages")
    base = unpack_pose(figure, found["pose"])
    generation = Generation(
        base=base,
        number=int(found["number"]),
        intensity=_intensity(found["intensity"]),
        chosen=_limbs(figure, found["chosen"]),
        enabled=_limbs(figure, found["enabled"]) & frozenset(figure.movable),
        locks=tuple(_read_lock(figure, text) for text in found["locks"].split("+") if text),
        aim=found["aim"] is not None,
        root=found["root"] is not None,
        picked=unpack_pose(figure, found["picked"]) if found["picked"] else base,
        settled=_limbs(figure, found["settled"] or "0"),
    )
    return generation, page


def _mask(limbs: Iterable[int]) -> int:
    return sum(1 << limb for limb in limbs)


def _limbs(figure: Figure, mask: str) -> frozenset[int]:
    bits = int(mask, 16)
    if bits >> len(figure.limbs):
        raise ImpossibleError(f"that address names more limbs than the figure {figure.name} has")
    return frozenset(limb for limb in range(len(figure.limbs)) if bits >> limb & 1)


def _lock_text(figure: Figure, lock: Lock) -> str:
    return ",".join(quote(word, safe="") for word in lock_words(figure, lock))


def _read_lock(figure: Figure, text: str) -> Lock:
    return read_lock(figure, [unquote(word) for word in text.split(",")])


def _intensity(text: str) -> float:
    try:
        intensity = float(text)
    except ValueError:
        intensity = -1.0
    if not 0 <= intensity <= 100:
        raise ImpossibleError(f"that address has an intensity of {text}; intensities go from 0 to 100")
    return intensity
