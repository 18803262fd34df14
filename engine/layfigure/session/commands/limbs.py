"""Commands that select limbs and say which of them may change."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Command
from layfigure.session.commands.arguments import limbs, rectangle, selected
from layfigure.session.describing import spoken_limb
from layfigure.session.words import join_line, no_more, one_of, required

if TYPE_CHECKING:
    from layfigure.session.session import Session


def _select(session: Session, words: tuple[str, ...]) -> None:
    _show(session, limbs(session, words, 0))


def _select_none(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.view = replace(session.view, selected=())


def _step(session: Session, by: int) -> None:
    order = session.document.figure.selectable
    present = session.view.selected
    if not present:
        _show(session, (order[1 if by > 0 and len(order) > 1 else -1],))
    else:
        position = order.index(present[-1]) if present[-1] in order else 0
        _show(session, (order[(position + by) % len(order)],))


def _next(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    _step(session, 1)


def _previous(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    _step(session, -1)


def _parent(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    figure, limb = session.document.figure, selected(session)[-1]
    above = figure.limbs[limb].parent
    while above > 0 and not figure.limbs[above].movable:
        above = figure.limbs[above].parent
    if above < 0:
        raise ImpossibleError("there is no limb above the root")
    _show(session, (above,))


def _child(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    figure, limb = session.document.figure, selected(session)[-1]
    below = sorted(figure.subtree(limb) - {limb})
    movable = [index for index in below if figure.limbs[index].movable]
    if not movable:
        raise ImpossibleError(f"no limb below the {spoken_limb(figure, limb)} can move")
    _show(session, (movable[0],))


def _opposite(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    figure, chosen = session.document.figure, selected(session)
    twins = tuple(figure.limbs[limb].twin for limb in chosen)
    if twins == chosen:
        raise ImpossibleError(f"the {spoken_limb(figure, chosen[-1])} has no mirror twin")
    _show(session, twins)


def _with_selected(session: Session, words: tuple[str, ...]) -> None:
    """Make of the selection command lines that can be logged: each limb's name is the last word of one."""
    name = required(words, 0, "a command")
    names = session.document.figure.names
    for limb in selected(session):
        session.execute(join_line(name, [*words[1:], names[limb]]))


def _toggle(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    chosen = selected(session)
    names = [session.document.figure.names[limb] for limb in chosen]
    verb = "disable" if session.document.enabled.issuperset(chosen) else "enable"
    session.execute(join_line(verb, names))


def _enable(session: Session, words: tuple[str, ...]) -> None:
    chosen = frozenset(limbs(session, words, 0)) & frozenset(session.document.figure.movable)
    session.commit("enable limbs", session.workshop.set_enabled(session.document, session.document.enabled | chosen))
    session.say(f"{_amount(session)} may change.")


def _disable(session: Session, words: tuple[str, ...]) -> None:
    chosen = frozenset(limbs(session, words, 0))
    session.commit("keep limbs", session.workshop.set_enabled(session.document, session.document.enabled - chosen))
    session.say(f"{_amount(session)} may change; the others keep what they have.")


def _enable_in(session: Session, words: tuple[str, ...]) -> None:
    switch = one_of(words, 0, "switch", ("on", "off", "only"))
    names = [session.document.figure.names[limb] for limb in _inside(session, words[1:])]
    session.execute(join_line({"on": "enable", "off": "disable", "only": "enable-only"}[switch], names))


def _enable_only(session: Session, words: tuple[str, ...]) -> None:
    chosen = frozenset(limbs(session, words, 0)) & frozenset(session.document.figure.movable)
    session.commit("enable only", session.workshop.set_enabled(session.document, chosen))
    session.say(f"{_amount(session)} may change; the others keep what they have.")


def _select_in(session: Session, words: tuple[str, ...]) -> None:
    _show(session, _inside(session, words))


def _select_more(session: Session, words: tuple[str, ...]) -> None:
    """Add limbs to the selection, or take out those that are all in it."""
    chosen, present = limbs(session, words, 0), session.view.selected
    kept = tuple(limb for limb in present if limb not in chosen)
    _show(session, kept if set(chosen) <= set(present) else (*kept, *chosen))


def _inside(session: Session, words: tuple[str, ...]) -> tuple[int, ...]:
    chosen = session.stage.limbs_in(*rectangle(words))
    if not chosen:
        raise ImpossibleError("no limb lies wholly inside that rectangle")
    return chosen


def _amount(session: Session) -> str:
    return f"{len(session.document.enabled)} of {len(session.document.figure.movable)} limbs"


def _show(session: Session, chosen: tuple[int, ...]) -> None:
    session.view = replace(session.view, selected=chosen)


COMMANDS = (
    Command("select", "Select limbs", _select, "LIMB…", passive=True),
    Command("select-none", "Select nothing", _select_none, passive=True),
    Command("next-limb", "Select the next limb", _next, passive=True),
    Command("previous-limb", "Select the previous limb", _previous, passive=True),
    Command("parent-limb", "Select the limb above", _parent, passive=True),
    Command("child-limb", "Select the limb below", _child, passive=True),
    Command("opposite-limb", "Select the mirror twin", _opposite, passive=True),
    Command("with-selected", "Run a command for each selected limb, named last", _with_selected, "COMMAND [WORD…]"),
    Command("toggle", "Let the selected limbs change, or keep them", _toggle),
    Command("enable", "Let limbs change", _enable, "LIMB…|all", logged=True),
    Command("disable", "Keep limbs as they are", _disable, "LIMB…|all", logged=True),
    Command("enable-only", "Let only these limbs change", _enable_only, "LIMB…|all", logged=True),
    Command(
        "enable-in", "Enable or keep the limbs inside a rectangle", _enable_in, "on|off|only CANDIDATE VIEW X Y W H"
    ),
    Command("select-in", "Select the limbs inside a rectangle", _select_in, "CANDIDATE VIEW X Y W H", passive=True),
    Command("select-more", "Add limbs to the selection, or take them out", _select_more, "LIMB…", passive=True),
)
