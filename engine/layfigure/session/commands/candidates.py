"""Commands that choose among candidates: what becomes limb picks, and the switch between techniques."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from layfigure.errors import ImpossibleError
from layfigure.plugins.records import Command
from layfigure.session.commands.arguments import limbs, rectangle
from layfigure.session.describing import listed_limbs
from layfigure.session.words import join_line, no_more, one_of, whole_number
from layfigure.techniques.contract import Best, Grade, LimbPick

if TYPE_CHECKING:
    from layfigure.session.session import Session


def candidate(session: Session, words: tuple[str, ...], index: int = 0) -> int:
    """Return word ``index`` as a 0-based candidate of the present offer.

    Raises:
        ImpossibleError: the technique in use offers no candidates.
        WordError: there is no such candidate.
    """
    return whole_number(words, index, "a candidate", (1, _count(session))) - 1


def _count(session: Session) -> int:
    count = len(session.offer().candidates)
    if not count:
        raise ImpossibleError("there are no candidates to choose from here")
    return count


def _pick(session: Session, words: tuple[str, ...]) -> None:
    number_, chosen = candidate(session, words), limbs(session, words, 1)
    session.tell(_title(session, chosen, number_), LimbPick(number_, chosen))
    _look_at(session, number_, chosen)
    session.say(f"Copied {_listed(session, chosen)} from candidate {number_ + 1}.")


def _vary(session: Session, words: tuple[str, ...]) -> None:
    number_ = candidate(session, words)
    how = one_of(words, 1, "kind of variation", ("swing", "twist"))
    chosen = limbs(session, words, 2)
    session.tell(_title(session, chosen, number_), LimbPick(number_, chosen, how))
    _look_at(session, number_, chosen)
    session.say(f"Copied {_listed(session, chosen)} from candidate {number_ + 1}; it varies a little in {how}.")


def _copy(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    if not session.view.selected:
        raise ImpossibleError("no limb is selected; Tab selects one, Shift-Enter takes the whole candidate")
    chosen = session.view.candidate + 1
    names = [session.document.figure.names[limb] for limb in session.view.selected]
    how = [one_of(words, 0, "kind of variation", ("swing", "twist"))] if words else []
    session.execute(join_line("vary" if how else "pick", [str(chosen), *how, *names]))


def _copy_all(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    session.execute(f"best {session.view.candidate + 1}")


def _best(session: Session, words: tuple[str, ...]) -> None:
    number_ = candidate(session, words)
    no_more(words, 1)
    session.tell(f"take candidate {number_ + 1}", Best(number_))
    _look_at(session, number_, session.view.selected)
    session.say(f"Took the whole of candidate {number_ + 1}.")


def _grade(session: Session, words: tuple[str, ...]) -> tuple[str, ...]:
    record = session.workshop.record(session.document.technique)
    if "grade" not in record.channels:
        raise ImpossibleError(f"the technique {record.title} takes no grades; copy limbs or take a whole candidate")
    if len(words) > 1:
        number_ = candidate(session, words)
        return _give(session, number_, words, 1)
    number_ = _beside(session, 0)
    logged = _give(session, number_, words, 0)
    session.view = replace(session.view, candidate=_beside(session, 1))
    return logged


def _give(session: Session, number_: int, words: tuple[str, ...], index: int) -> tuple[str, ...]:
    """Grade a candidate with the last word, at ``index``; return the words to log."""
    grade = whole_number(words, index, "a grade", (0, 10))
    no_more(words, index + 1)
    session.tell(f"grade candidate {number_ + 1}: {grade}", Grade(number_, grade))
    session.say(f"Candidate {number_ + 1} has {grade} of 10.")
    return (str(number_ + 1), str(grade))


def _choose(session: Session, words: tuple[str, ...]) -> None:
    if words[:1] in (("next",), ("previous",)):
        number_ = _beside(session, 1 if words[0] == "next" else -1)
    else:
        number_ = candidate(session, words)
    no_more(words, 1)
    session.view = replace(session.view, candidate=number_)


def _beside(session: Session, step: int) -> int:
    """Return the candidate ``step`` places after the chosen one; the first follows the last.

    Raises:
        ImpossibleError: the technique in use offers no candidates.
    """
    count = _count(session)
    return (min(session.view.candidate, count - 1) + step) % count


def _pick_in(session: Session, words: tuple[str, ...]) -> None:
    how = one_of(words, 0, "kind of variation", ("plain", "swing", "twist"))
    shown, view, band = rectangle(words[1:])
    chosen = session.stage.limbs_in(shown, view, band)
    if not chosen:
        raise ImpossibleError("no limb lies wholly inside that rectangle")
    names = [session.document.figure.names[limb] for limb in chosen]
    head = [str(shown + 1)] if how == "plain" else [str(shown + 1), how]
    session.execute(join_line("pick" if how == "plain" else "vary", [*head, *names]))


def _use(session: Session, words: tuple[str, ...]) -> None:
    technique = one_of(words, 0, "technique", session.host.techniques)
    no_more(words, 1)
    session.use(technique)


def _address(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 0)
    address = session.offer().address
    if not address:
        raise ImpossibleError("this page has no address")
    session.clipboard_out = address
    session.say(f"Address of this page (copied): {address}")


def _title(session: Session, chosen: tuple[int, ...], number_: int) -> str:
    return f"copy {_listed(session, chosen)} from {number_ + 1}"


def _listed(session: Session, chosen: tuple[int, ...]) -> str:
    return listed_limbs(session.document.figure, chosen)


def _look_at(session: Session, number_: int, chosen: tuple[int, ...]) -> None:
    selected = chosen if len(chosen) == 1 else session.view.selected
    session.view = replace(session.view, candidate=number_, selected=selected)


COMMANDS = (
    Command("pick", "Copy limbs from a candidate", _pick, "CANDIDATE LIMB…", logged=True, chooses=True),
    Command(
        "vary", "Copy limbs and let them vary a little", _vary, "CANDIDATE swing|twist LIMB…", logged=True, chooses=True
    ),
    Command("best", "Take a whole candidate", _best, "CANDIDATE", logged=True, chooses=True),
    Command(
        "grade", "Grade a candidate, or the chosen one and go on", _grade, "[CANDIDATE] 0…10", logged=True, chooses=True
    ),
    Command("choose", "Choose a candidate", _choose, "CANDIDATE|next|previous", passive=True),
    Command("copy", "Copy the selected limbs from the chosen candidate", _copy, "[swing|twist]", chooses=True),
    Command("copy-all", "Take the chosen candidate as a whole", _copy_all, chooses=True),
    Command(
        "pick-in",
        "Copy the limbs inside a rectangle",
        _pick_in,
        "plain|swing|twist CANDIDATE VIEW X Y W H",
        chooses=True,
    ),
    Command("use", "Switch to a technique", _use, "TECHNIQUE", logged=True),
    Command("address", "Show and copy the address of this page", _address),
)
