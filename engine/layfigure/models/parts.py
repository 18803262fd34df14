"""What a JOINT statement joins: links, models, and links of models."""

from __future__ import annotations

from dataclasses import dataclass

from layfigure.models.articulated import LinkOf, Model
from layfigure.models.joints import Joint
from layfigure.models.links import Link, Turned, turned_over

Part = Link | Model | LinkOf


@dataclass(frozen=True)
class Joining:
    """One JOINT statement: a joint, the link or model that holds and the one that is held and copied."""

    joint: Joint
    primary: Part
    secondary: Part


def model_of(part: Part) -> Model | None:
    """Return the model that a part is or belongs to, None for a link alone."""
    if isinstance(part, LinkOf):
        return part.model
    return part if isinstance(part, Model) else None


def root_of(part: Part) -> Link | Model:
    """Return the whole that a part is or belongs to."""
    return part.model if isinstance(part, LinkOf) else part


def as_model(part: Part) -> Model:
    """Return the whole that a part belongs to as a model, a link alone being one of one link."""
    whole = root_of(part)
    return Model.of_link(whole) if isinstance(whole, Link) else whole


def node_of(part: Part) -> int:
    """Return the node that is joined: the link named, or the main link."""
    return part.node if isinstance(part, LinkOf) else as_model(part).main_node


def hung_up(part: Part) -> Turned:
    """Return a part's tree hung up by the link that is joined."""
    return turned_over(as_model(part).nodes, node_of(part))


def is_called(part: Part, name: str) -> bool:
    """Whether a part is a link alone of that name."""
    return isinstance(part, Link) and part.name.casefold() == name.casefold()


def title_of(part: Part) -> str:
    """Return what sentences call a part."""
    whole = root_of(part)
    return whole.name if isinstance(whole, Link) else whole.title
