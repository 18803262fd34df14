"""The laws of techniques, as one call for a test: :func:`check_technique`."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.figures.library import figure_names, load_figure
from layfigure.plugins.host import Host
from layfigure.plugins.records import Technique
from layfigure.poses.locks import JointLock
from layfigure.poses.pose import Pose
from layfigure.techniques.contract import LocksSet, Setting
from layfigure.testing.scenes import legal_pose
from layfigure.testing.subject import Subject
from layfigure.testing.technique_laws import check_controls, check_declaration, check_storage, check_unknown_events
from layfigure.testing.walk import Walk

_STEPS = 12  # random events of each walk


def check_technique(
    record: Technique,
    figures: Sequence[Figure | str] = (),
    seed: int = 0,
    *,
    host: Host | None = None,
    keeps_limits: bool = True,
) -> None:
    """Check the laws that every technique has to obey, on some figures (all the shipped ones unless given).

    Asking and telling are pure; a set pose is kept to the last bit; limbs that may not change and locked joints do not
    change whatever is told; controls work over their range and refuse anything else; a dumped state is loaded as it
    was; events of all kinds, sense and nonsense, never give numbers that are not finite. Limits are kept, unless a
    toggle "limits" of the technique is off, or ``keeps_limits=False`` says that it leaves them on purpose. ``host`` has
    the solvers that it asks for.

    Raises:
        AssertionError: a law is broken; the sentence says which, on which figure, by which event.
    """
    check_declaration(record)
    for figure in figures or figure_names():
        loaded = load_figure(figure) if isinstance(figure, str) else figure
        subject = Subject(record, loaded, host or Host(strict=True))
        chance = np.random.default_rng([seed, zlib.crc32(loaded.name.encode())])
        for law in (_check_from_rest, _check_from_a_pose, _check_under_locks):
            law(subject, chance, keeps_limits)
        _check_alone(subject, chance)


def _check_from_rest(subject: Subject, chance: np.random.Generator, keeps_limits: bool) -> None:
    """A fresh figure of which every limb may change."""
    figure = subject.figure
    setting = Setting(Pose.rest(figure), frozenset(figure.movable), fresh=True)
    Walk(subject, setting, chance, keeps_limits).go(_STEPS)


def _check_from_a_pose(subject: Subject, chance: np.random.Generator, keeps_limits: bool) -> None:
    """Somebody else's pose, of which about half the limbs may change."""
    setting = _midway(subject.figure, chance)
    Walk(subject, setting, chance, keeps_limits).go(_STEPS)


def _check_under_locks(subject: Subject, chance: np.random.Generator, keeps_limits: bool) -> None:
    """Some joints are locked from the start, for techniques that pay heed to locks."""
    figure = subject.figure
    chosen = chance.choice(figure.movable, min(2, len(figure.movable)), replace=False)
    locks = tuple(JointLock(int(limb)) for limb in sorted(chosen))
    plain = Setting(legal_pose(figure, chance, 0.5), frozenset(figure.movable), fresh=False)
    if subject.tell(subject.start(plain), LocksSet(locks)).refusal:
        return
    Walk(subject, Setting(plain.pose, plain.enabled, plain.fresh, locks), chance, keeps_limits).go(_STEPS)


def _check_alone(subject: Subject, chance: np.random.Generator) -> None:
    """The laws that need no walk: controls one by one, unknown events, dump and load."""
    setting = _midway(subject.figure, chance)
    laws: tuple[Callable[[Subject, Setting], None], ...] = (check_controls, check_unknown_events, check_storage)
    for law in laws:
        law(subject, setting)


def _midway(figure: Figure, chance: np.random.Generator) -> Setting:
    enabled = frozenset(limb for limb in figure.movable if chance.random() < 0.6) or frozenset(figure.movable[:1])
    return Setting(legal_pose(figure, chance, 0.5), enabled, fresh=False)
