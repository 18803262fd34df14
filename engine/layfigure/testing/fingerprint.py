"""Fingerprints: whether a value is, to the last bit, what it was."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping, Sequence, Set

import numpy as np

from layfigure.poses.pose import Pose
from layfigure.techniques.contract import Offer

_DEEPEST = 12


def fingerprint(value: object) -> bytes:
    """Return bytes that differ where two values differ: records, mappings, sequences, sets, arrays, plain values.

    Of other objects only what they are is seen, not what is in them; functions are passed over.
    """
    return b"\0".join(_parts(value, 0))


def _parts(value: object, depth: int) -> Iterator[bytes]:
    if depth > _DEEPEST:
        return
    match value:
        case np.ndarray():
            yield f"{value.dtype.str} {value.shape}".encode() + value.tobytes()
        case Mapping():
            yield b"mapping"
            for key in sorted(value, key=repr):
                yield repr(key).encode()
                yield from _parts(value[key], depth + 1)
        case str() | bytes() | int() | float() | None:
            yield f"{type(value).__name__} {value!r}".encode()
        case Set():
            yield b"set"
            yield from sorted(fingerprint(item) for item in value)
        case Sequence():
            yield b"sequence"
            for item in value:
                yield from _parts(item, depth + 1)
        case _:
            yield from _parts_of_object(value, depth)


def _parts_of_object(value: object, depth: int) -> Iterator[bytes]:
    yield type(value).__qualname__.encode()
    if dataclasses.is_dataclass(value):
        for field in dataclasses.fields(value):
            yield field.name.encode()
            yield from _parts(getattr(value, field.name), depth + 1)


def pose_print(pose: Pose) -> bytes:
    """Return the bits of a pose."""
    return pose.angles.tobytes() + pose.translation.tobytes()


def lasting_print(offer: Offer) -> bytes:
    """Return the bits of what an offer shows and a state is stored for: not its note, and not its marks."""
    return fingerprint((offer.candidates, offer.title, offer.values, offer.address, offer.badges))


def offer_print(offer: Offer) -> bytes:
    """Return the bits of everything that an offer shows, marks and cones included."""
    return fingerprint((lasting_print(offer), offer.note, tuple(offer.marks()), tuple(offer.cones())))
