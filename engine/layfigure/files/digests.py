"""Digests of byte strings in their order."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable

SIZE = 16  # bytes of a digest, where nobody says otherwise


def joined(parts: Iterable[bytes], size: int = SIZE) -> bytes:
    """Return ``size`` bytes that stand for byte strings in their order, as for no other list of strings."""
    summed = hashlib.blake2b(digest_size=size)
    for part in parts:
        summed.update(len(part).to_bytes(8, "little"))
        summed.update(part)
    return summed.digest()
