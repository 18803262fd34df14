"""Commands that say things in words: the pose, a candidate, where a limb ends, and what there is to name."""

from __future__ import annotations

from typing import TYPE_CHECKING

from layfigure.plugins.records import Command
from layfigure.session.commands.arguments import limbs
from layfigure.session.commands.candidates import candidate
from layfigure.session.commands.interface import shown_commands
from layfigure.session.describing import freedom
from layfigure.session.frame import HelpOverlay
from layfigure.session.modes import HelpMode, help_page
from layfigure.session.telling_motion import key_rows
from layfigure.session.words import no_more, one_of
from layfigure.wording.anatomy import anatomy
from layfigure.wording.changes import change_words
from layfigure.wording.places import place_words
from layfigure.wording.poses import describe_pose, sentences
from layfigure.wording.statement import Statement

if TYPE_CHECKING:
    from layfigure.session.session import Session

Rows = tuple[tuple[str, str], ...]


def _describe(session: Session, words: tuple[str, ...]) -> None:
    no_more(words, 1)
    document = session.document
    if not words:
        _show_statements(session, document.figure.name.capitalize(), describe_pose(document.figure, document.pose))
        return
    number_ = candidate(session, words)
    pose = session.offer().candidates[number_]
    changed = change_words(document.figure, document.pose, pose, roughly=True) or "nearly the same"
    statements = (*describe_pose(document.figure, pose), Statement("compared with your pose,", (changed,)))
    _show_statements(session, f"Candidate {number_ + 1}", statements)


def candidate_words(session: Session, number_: int) -> str:
    """Return in one line what candidate ``number_`` (0-based) does and what sets it apart from the pose."""
    document, pose = session.document, session.offer().candidates[number_]
    found = change_words(document.figure, document.pose, pose, roughly=True)
    if found and anatomy(document.figure) is not None:
        found = f"{', '.join(describe_pose(document.figure, pose)[0].clauses)}; {found}"
    return found or ("as your pose is" if pose == document.pose else "nearly as your pose is")


def _show_statements(session: Session, title: str, statements: tuple[Statement, ...]) -> None:
    said = sentences(statements)
    _show(session, HelpOverlay(title, _sections(statements), keys=False, spoken=said))
    session.say(" ".join(said))


def _sections(statements: tuple[Statement, ...]) -> tuple[tuple[str, Rows], ...]:
    """Return statements as the sections of a page, a row for each clause; a row needs something where amounts stand."""
    sections: dict[str, Rows] = {}
    for each in statements:
        title = each.subject.rstrip(",").capitalize() or "The whole body"
        rows = tuple((" ", part) for clause in each.clauses for part in clause.split("; "))
        sections[title] = (*sections.get(title, ()), *rows)
    return tuple(sections.items())


def _show(session: Session, page: HelpOverlay) -> None:
    session.modes.append(HelpMode(page))


def _where(session: Session, words: tuple[str, ...]) -> None:
    (limb,) = limbs(session, words[:1], 0)
    no_more(words, 1)
    session.say(place_words(session.document.figure, session.document.pose, limb))


def _list(session: Session, words: tuple[str, ...]) -> None:
    what = one_of(words, 0, "list", (*_LISTS, "keys"))
    no_more(words, 1)
    if what == "keys":
        titles = {name: command.title for name, command in session.commands().items()}
        _show(session, help_page(session.key_table(), session.situation, titles))
        return
    rows = _LISTS[what](session)
    spoken = tuple(f"{key}: {text}." for key, text in rows)
    _show(session, HelpOverlay(what.capitalize(), ((what.capitalize(), rows),), keys=False, spoken=spoken))


def _limb_rows(session: Session) -> Rows:
    document = session.document
    figure, rows = document.figure, []
    for limb in figure.selectable:
        joint, angles = figure.limbs[limb], document.pose.angles[limb]
        stands = [f"{kind} {angles[i]:.4g}" for i, kind in enumerate(joint.kinds) if angles[i]]
        kept = "" if not limb or limb in document.enabled else "; kept"
        can = "turns and carries the whole" if not limb else freedom(joint)
        rows.append((joint.name, f"{can}; {', '.join(stands) if stands else 'at rest'}{kept}"))
    return tuple(rows)


def _candidate_rows(session: Session) -> Rows:
    count = len(session.offer().candidates)
    candidate(session, ("1",))  # says so where there are none
    return tuple((f"Candidate {index + 1}", candidate_words(session, index)) for index in range(count))


def _technique_rows(session: Session) -> Rows:
    used = session.document.technique
    records = session.host.techniques.items()
    return tuple((key, f"{record.title}{', in use' if key == used else ''}") for key, record in records)


def _command_rows(session: Session) -> Rows:
    commands = sorted(shown_commands(session).items())
    return tuple((f"{name} {command.usage}".strip(), command.title) for name, command in commands)


def _motion_rows(session: Session) -> Rows:
    return tuple(key_rows(session.document))


_LISTS = {
    "limbs": _limb_rows,
    "candidates": _candidate_rows,
    "techniques": _technique_rows,
    "motion": _motion_rows,
    "commands": _command_rows,
}

COMMANDS = (
    Command("describe", "Say the pose or a candidate in words", _describe, "[CANDIDATE]"),
    Command("where", "Say where the end of a limb is", _where, "LIMB"),
    Command("list", "List what there is to name", _list, "limbs|candidates|techniques|motion|commands|keys"),
)
