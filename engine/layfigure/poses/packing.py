"""A pose as one short word for logs, addresses and messages: whole micro-degrees, packed, with a check sum."""

from __future__ import annotations

import base64
import binascii
import zlib
from collections.abc import Iterable, Iterator

import numpy as np

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.poses.freedom import existing_angles, pose_of_units, whole_units
from layfigure.poses.pose import Pose

_CHECK_BYTES = 3
_LONGEST_NUMBER = 6  # bytes: 7 bits each hold the zigzag of 1e6 units in millionths


def pack_pose(figure: Figure, pose: Pose) -> str:
    """Return the pose as a word of letters, digits, ``-`` and ``_``; :func:`unpack_pose` gives it back exactly.

    The root's translation and angles, then the angles that exist, in figure order; each as a zigzag varint of
    millionths (small angles take few bytes), then three bytes of a CRC-32 that knows the figure's joints too.

    Raises:
        LayfigureError: the pose cannot belong to the figure.
    """
    translation, angles = whole_units(figure, pose)
    numbers = [*translation.tolist(), *angles[existing_angles(figure)].tolist()]
    payload = b"".join(_varint(number) for number in numbers)
    return base64.urlsafe_b64encode(payload + _check(figure, payload)).decode("ascii").rstrip("=")


def unpack_pose(figure: Figure, token: str) -> Pose:
    """Return the pose that :func:`pack_pose` packed.

    Raises:
        LayfigureError: the word is damaged, cut, or of a figure with other joints.
    """
    exists = existing_angles(figure)
    count = 3 + int(exists.sum())
    packed = _bytes_of(token, count * _LONGEST_NUMBER + _CHECK_BYTES)
    payload, check = packed[:-_CHECK_BYTES], packed[-_CHECK_BYTES:]
    if check != _check(figure, payload):
        raise LayfigureError(f"the packed pose is damaged or not one of the figure {figure.name}; copy the whole of it")
    numbers = list(_numbers(payload))
    if len(numbers) != count:
        raise LayfigureError(f"the packed pose holds {len(numbers)} numbers, but {figure.name} needs {count}")
    angles = np.zeros(exists.shape, dtype=np.int64)
    angles[exists] = numbers[3:]
    pose = pose_of_units(figure, np.array(numbers[:3], dtype=np.int64), angles)
    if pack_pose(figure, pose) != token:
        raise LayfigureError("the packed pose holds angles that no pose has; copy it again from where it came")
    return pose


def _bytes_of(token: str, longest: int) -> bytes:
    if len(token) > (longest * 4 + 2) // 3:
        raise LayfigureError("the packed pose is longer than any pose of this figure; copy it again")
    try:
        return base64.b64decode(token + "=" * (-len(token) % 4), altchars=b"-_", validate=True)
    except (binascii.Error, ValueError):
        raise LayfigureError("that is not a packed pose; it has only letters, digits, - and _") from None


def _check(figure: Figure, payload: bytes) -> bytes:
    joints = ";".join(f"{limb.name.casefold()} {' '.join(dof.kind for dof in limb.dofs)}" for limb in figure.limbs)
    return zlib.crc32(payload, zlib.crc32(joints.encode())).to_bytes(4, "big")[:_CHECK_BYTES]


def _varint(number: int) -> bytes:
    """Return a signed number as 7-bit groups, low ones first, the sign in the lowest bit (zigzag)."""
    rest = (number << 1) ^ (number >> 63)
    groups = bytearray()
    while rest > 0x7F:
        groups.append(rest & 0x7F | 0x80)
        rest >>= 7
    groups.append(rest)
    return bytes(groups)


def _numbers(payload: Iterable[int]) -> Iterator[int]:
    """Yield the numbers of a payload; a last one that is cut short is left out."""
    value, shift = 0, 0
    for byte in payload:
        value |= (byte & 0x7F) << shift
        shift += 7
        if byte < 0x80:
            yield (value >> 1) ^ -(value & 1)
            value, shift = 0, 0
