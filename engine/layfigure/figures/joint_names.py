"""What joints are called: one rule for figures, models, motions and scripts, so that each can name what others made."""

from __future__ import annotations

import re

from layfigure.errors import LayfigureError

_WORD = re.compile(r"[\w.+-]{1,80}")
_WHOLE = re.compile(r"[-+]?[0-9]{1,40}", re.ASCII)


def joint_name(joint: object) -> str:
    """Return the name of a joint as it is compared: folded, a whole number without leading zeros or a plus sign.

    ``5``, ``"5"`` and ``"05"`` are the same. TRANS JOINTS makes names such as ``elbow+10``.

    Raises:
        LayfigureError: it is neither a whole number nor one word.
    """
    name = str(joint).strip().casefold()
    if _WHOLE.fullmatch(name):
        return str(int(name))
    if not _WORD.fullmatch(name):
        raise LayfigureError(
            f"{str(joint)[:40]!r} is no joint; joints are called by a whole number or one short word "
            "of letters, digits, . _ + and -"
        )
    return name
