"""What candidates must fulfil beside being mutations: locks, filters, and how a page picks its nine."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from layfigure.poses.locks import JointLock, Lock, locked_joints

LIMITS, FLOOR, TOUCHING, BALANCE = "limits", "floor", "touching", "balance"
FILTERS = {"within-limits": LIMITS, "above-floor": FLOOR, "no-touching": TOUCHING, "balanced": BALANCE}
"""The toggles of the panel, and what addresses call them."""

ORDERED, APART = "ordered", "apart"


@dataclass(frozen=True)
class Conditions:
    """What holds for every page of a generation. The plain ones are the thesis's: none.

    ``locks`` is empty where no limb's end is locked (locked joints do not vary to begin with), ``free`` are the limbs
    that may turn to keep locks. ``filters`` are some of :data:`FILTERS`'s values; ``spread`` is "ordered",
    or "apart" for nine that look different.
    """

    locks: tuple[Lock, ...] = ()
    free: frozenset[int] = frozenset()
    filters: frozenset[str] = frozenset()
    spread: str = ORDERED

    @property
    def plain(self) -> bool:
        """Whether a page is simply the next nine of the order."""
        return not self.locks and self.spread == ORDERED and not self.tests

    @property
    def tests(self) -> frozenset[str]:
        """The filters that candidates are tested by; limits are kept by the alternatives themselves."""
        return self.filters - {LIMITS}

    def locked(self, locks: Iterable[Lock], enabled: frozenset[int]) -> Conditions:
        """Return these conditions under other locks, with ``enabled`` the limbs that may change."""
        held = tuple(locks)
        if all(isinstance(lock, JointLock) for lock in held):
            return replace(self, locks=(), free=frozenset())
        return replace(self, locks=held, free=enabled - locked_joints(held))

    def filtered(self, name: str, on: bool) -> Conditions:
        """Return these conditions with one of the panel's toggles switched."""
        word = frozenset({FILTERS[name]})
        return replace(self, filters=self.filters | word if on else self.filters - word)


PLAIN = Conditions()
