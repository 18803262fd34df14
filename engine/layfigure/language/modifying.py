"""Changed instances of values: what stands between angle brackets."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from layfigure.language import syntax, values
from layfigure.language.evaluating import blamed
from layfigure.language.images import Image
from layfigure.models import Model, Shape
from layfigure.motions.motion import Motion

if TYPE_CHECKING:
    from layfigure.language.evaluating import Evaluator

_KNOWN = {
    Shape: "TRANS (x, y, z), ROTATE and SCALE",
    Model: "TRANS JOINTS BY, SCALE MODEL and SCALE EXTREMES; in a scene, once animated, TRANS and ROTATE place it",
    Image: "TRANS (x, y, z) and ROTATE",
    Motion: "SCALE FRAMES and SCALE EXTREMES",
}


def modified(evaluator: Evaluator, node: syntax.Modified) -> object:
    """Return a value with its modifiers applied from left to right.

    Raises:
        SourceError: a modifier is not for such a value, or has no such value itself.
    """
    value = evaluator.value(node.item)
    for modifier in node.modifiers:
        known = next((kind for kind in _KNOWN if isinstance(value, kind)), None)
        change = _CHANGES.get((known, modifier.kind)) if known else None
        if change is None:
            hint = f"; for it there are {_KNOWN[known]}" if known else ""
            raise modifier.place.error(f"{modifier.kind.upper()} is not for {values.kind_of(value)}{hint}")
        _charge(evaluator, value, modifier)
        with blamed(modifier.place):
            value = change(evaluator, value, modifier.value)
    return value


def _charge(evaluator: Evaluator, value: object, modifier: syntax.Modifier) -> None:
    if isinstance(value, Motion):
        evaluator.meter.work("keys", value.key_count, modifier.place)
    elif isinstance(value, Shape):
        evaluator.meter.work("volumes", len(value.volumes), modifier.place)
        evaluator.meter.count("volumes", len(value.volumes), modifier.place)
    elif isinstance(value, Model):
        evaluator.meter.work("links", len(value.nodes), modifier.place)


def _turned(evaluator: Evaluator, value: Shape | Image, node: syntax.Expression) -> Shape | Image:
    """Return a value turned by three angles, about x outermost, as joints are."""
    x, y, z = evaluator.vector(node, 3, "ROTATE")
    return value.rotated("z", z).rotated("y", y).rotated("x", x)


def _scaled(evaluator: Evaluator, value: Shape, node: syntax.Expression) -> Shape:
    factors = evaluator.value(node)
    if isinstance(factors, tuple):
        return value.scaled(*values.vector(factors, 3, "SCALE", node.place))
    return value.scaled(values.number(factors, "SCALE", node.place))


def _axis(axis: str) -> Callable[[Evaluator, Shape | Image, syntax.Expression], Shape | Image]:
    return lambda e, value, node: value.rotated(axis, e.number(node, f"ROTATE {axis.upper()}"))


_CHANGES: dict[tuple[type, str], Callable[..., object]] = {
    **{(kind, f"rotate {axis}"): _axis(axis) for kind in (Shape, Image) for axis in "xyz"},
    (Shape, "trans"): lambda e, value, node: value.translated(*e.vector(node, 3, "TRANS")),
    (Shape, "rotate"): _turned,
    (Shape, "scale"): _scaled,
    (Image, "trans"): lambda e, value, node: value.translated(*e.vector(node, 3, "TRANS")),
    (Image, "rotate"): _turned,
    (Model, "trans joints"): lambda e, value, node: value.trans_joints(e.whole(node, "TRANS JOINTS BY")),
    (Model, "scale model"): lambda e, value, node: value.scale(e.number(node, "SCALE MODEL")),
    (Model, "scale extremes"): lambda e, value, node: value.scale_extremes(e.number(node, "SCALE EXTREMES")),
    (Motion, "scale frames"): lambda e, value, node: value.scale(frames=e.number(node, "SCALE FRAMES")),
    (Motion, "scale extremes"): lambda e, value, node: value.scale(extremes=e.number(node, "SCALE EXTREMES")),
}
