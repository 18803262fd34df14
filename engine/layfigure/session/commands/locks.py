"""Commands that lock ends and joints, and release them (posing.md 8)."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Command
from layfigure.poses.lock_words import lock_words, plain, read_lock
from layfigure.poses.locks import KINDS, Lock, broken, kind_of, lock_at, with_lock
from layfigure.session.commands.candidates import limbs, one_limb
from layfigure.session.describing import spoken_limb
from layfigure.session.words import WordError, join_line, no_more, number, one_of, required

if TYPE_CHECKING:
    from layfigure.session.session import Session

_SAID = {
    "place": "stays in its place",
    "orientation": "keeps its orientation",
    "band": "is held by a rubber band",
    "hold": "keeps its offset",
    "joint": "keeps its joint's angles",
}


def _lock(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    kind = one_of(words, 0, "kind of lock", KINDS)
    limb = one_limb(session, words, 1)
    at = 2
    other = 0
    if kind == "hold":
        other = one_limb(session, words, 2)
        at = 3
        if other == limb:
            raise WordError(3, "a limb cannot keep its offset from itself; name another one")
    figure = session.document.figure
    if len(words) > at and kind != "joint":
        values = [plain(number(words, index, "a number of the lock's place")) for index in range(at, at + 3)]
        no_more(words, at + 3)
        lock = read_lock(figure, [*words[:at], *values])
    else:
        no_more(words, at)
        lock = lock_at(figure, session.document.pose, kind, limb, other)
    _set_locks(session, f"lock {figure.names[limb]}", with_lock(session.document.locks, lock))
    met = not broken(figure, session.document.pose, (lock,))
    said = _SAID[kind] if met else "is not there yet; the next change brings it there, or is refused"
    session.say(f"The {spoken_limb(figure, limb)} {said}.")
    return lock_words(figure, lock)


def _release(session: Session, words: tuple[str, ...]) -> None:
    required(words, 0, "a limb's name or all")
    locks = session.document.locks
    if words == ("all",):
        left: tuple[Lock, ...] = ()
    elif words[0] in KINDS:
        chosen = limbs(session, words, 1)
        left = tuple(lock for lock in locks if lock.limb not in chosen or kind_of(lock) != words[0])
    else:
        chosen = limbs(session, words, 0)
        left = tuple(lock for lock in locks if lock.limb not in chosen)
    if left == locks:
        raise ImpossibleError("nothing is locked there")
    _set_locks(session, "release", left)
    session.say(f"Released; {len(left)} locks are left." if left else "Released; nothing is locked any more.")


def _toggle(session: Session, words: tuple[str, ...]) -> None:
    kind = one_of(words, 0, "kind of lock", [each for each in KINDS if each != "hold"])
    no_more(words, 1)
    chosen = _selected(session)
    names = [session.document.figure.names[limb] for limb in chosen]
    has = {lock.limb for lock in session.document.locks if kind_of(lock) == kind}
    if has.issuperset(chosen):
        session.execute(join_line("release", [kind, *names]))
        return
    for limb, name in zip(chosen, names, strict=True):
        if limb not in has:
            session.execute(join_line("lock", [kind, name]))


def _hold(session: Session, words: tuple[str, ...]) -> None:
    """Keep the offset of the limbs selected: the last one follows the one before it, or one that is named."""
    names = session.document.figure.names
    chosen = _selected(session)
    other = one_limb(session, words, 0) if words else chosen[-2] if len(chosen) > 1 else -1
    no_more(words, 1)
    if other < 0:
        raise ImpossibleError("select two limbs, or name the other one: hold LIMB")
    session.execute(join_line("lock", ["hold", names[chosen[-1]], names[other]]))


def _selected(session: Session) -> tuple[int, ...]:
    if not session.view.selected:
        raise ImpossibleError("no limb is selected; Tab selects one")
    return session.view.selected


def _set_locks(session: Session, title: str, locks: tuple[Lock, ...]) -> None:
    session.commit(title, session.workshop.set_locks(session.document, locks))


COMMANDS = (
    Command(
        "lock",
        "Lock the end or the joint of a limb",
        _lock,
        "place|orientation|band|hold|joint LIMB [OTHER] [X Y Z]",
        True,
    ),
    Command("release", "Release what is locked", _release, "[KIND] LIMB…|all", logged=True),
    Command("toggle-lock", "Lock the selected limbs, or release them", _toggle, "place|orientation|band|joint"),
    Command("hold", "Keep the offset of the selected limb from another", _hold, "[LIMB]"),
)
