"""Sorts the joints of a model, given in any order, into a tree: what holds each, which part is the root."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from layfigure.errors import LayfigureError
from layfigure.models.articulated import Model
from layfigure.models.links import Link, Turned
from layfigure.models.parts import Joining, Part, as_model, is_called, model_of, node_of, root_of, title_of


class Holder(NamedTuple):
    """Where a primary link was introduced: the statement whose secondary it belongs to, and its node in there."""

    statement: int
    node: int


def holder_of(statements: Sequence[Joining], parts: Sequence[Turned], number: int) -> Holder | None:
    """Return what introduces the primary link of a statement, or None where it is the root."""
    primary = statements[number].primary
    if isinstance(primary, Link):
        _refuse_own_secondary(statements[number])
        return _link_holder(statements, parts, number, primary)
    held = model_of(primary)
    fitting = [i for i, other in enumerate(statements) if i != number and model_of(other.secondary) is held]
    if len(fitting) > 1:
        raise _ambiguous(statements, number, fitting)
    if not fitting:
        return None
    return Holder(fitting[0], parts[fitting[0]].places[node_of(primary)])


def _link_holder(statements: Sequence[Joining], parts: Sequence[Turned], number: int, link: Link) -> Holder | None:
    named = [i for i, other in enumerate(statements) if i != number and is_called(other.secondary, link.name)]
    if len(named) > 1:
        raise _ambiguous(statements, number, named)
    if named:
        if not _is_same(statements[named[0]].secondary, link):
            raise LayfigureError(f'two different links are called "{link.name}"; give each its own name')
        return Holder(named[0], 0)
    inside = [
        Holder(i, place)
        for i, part in enumerate(parts)
        if i != number and not isinstance(statements[i].secondary, Link)
        for place, node in enumerate(part.nodes)
        if is_called(node.link, link.name) and node.link.shape == link.shape
    ]
    if len(inside) > 1:
        raise _ambiguous(statements, number, [holder.statement for holder in inside])
    return inside[0] if inside else None


def root_of_all(statements: Sequence[Joining], holders: Sequence[Holder | None]) -> Model:
    """Return the one part that nothing holds, as a model."""
    roots: list[Link | Model] = []
    for statement, holder in zip(statements, holders, strict=True):
        part = root_of(statement.primary)
        if holder is None and not any(_is_same(part, root) for root in roots):
            roots.append(part)
    if not roots:
        raise LayfigureError(f"{_listed(statements)} run in a circle; in a model one link must be held by no other")
    if len(roots) > 1:
        titles = [title_of(root) for root in roots]
        if len(set(titles)) < len(titles):
            raise LayfigureError(f'two different links are called "{titles[0]}"; give each its own name')
        parts = f"{', '.join(titles[:-1])} and {titles[-1]}"
        raise LayfigureError(f"{parts} are not joined to each other; a model is one piece")
    return as_model(roots[0])


def in_order(statements: Sequence[Joining], holders: Sequence[Holder | None]) -> list[int]:
    """Return the statements' numbers so that each comes after what introduces its primary link, else as given."""
    placed: dict[int, None] = {}
    waiting = list(range(len(statements)))
    while waiting:
        ready = [i for i in waiting if (holder := holders[i]) is None or holder.statement in placed]
        if not ready:
            circle = _listed([statements[i] for i in waiting])
            raise LayfigureError(f"{circle} run in a circle; in a model one link must be held by no other")
        placed.update(dict.fromkeys(ready))
        waiting = [i for i in waiting if i not in placed]
    return list(placed)


def _is_same(part: Part, other: Link | Model) -> bool:
    """Whether two parts are one: the same model, or links alike in name and shape."""
    if isinstance(part, Link) and isinstance(other, Link):
        return is_called(part, other.name) and part.named(other.name) == other
    return part is other


def _refuse_own_secondary(statement: Joining) -> None:
    link = statement.primary
    if isinstance(link, Link) and is_called(statement.secondary, link.name):
        advice = f"give the second its own name, in a script {link.name}2 :- {link.name}"
        raise LayfigureError(f"joint {statement.joint.id} joins the link {link.name} to itself; {advice}")


def _ambiguous(statements: Sequence[Joining], number: int, fitting: Sequence[int]) -> LayfigureError:
    title, joint_id = title_of(statements[number].primary), statements[number].joint.id
    others = _listed([statements[i] for i in dict.fromkeys(fitting)])
    return LayfigureError(
        f'joint {joint_id} begins at "{title}", but there are several (see {others}); give each its own name'
    )


def _listed(statements: Sequence[Joining]) -> str:
    ids = [str(statement.joint.id) for statement in statements[:8]]
    if len(ids) == 1:
        return f"joint {ids[0]}"
    return f"joints {', '.join(ids[:-1])} and {ids[-1]}"
