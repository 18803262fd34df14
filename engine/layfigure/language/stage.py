"""The frame of a scene that is being made: its camera, its floor, what stands behind, and who acts."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.language import syntax, values
from layfigure.language.evaluating import Evaluator, blamed
from layfigure.language.images import Image
from layfigure.language.places import Place
from layfigure.language.run import Run
from layfigure.language.syntax import names_in
from layfigure.models import Link, Model, Shape
from layfigure.models.numbers import checked_number
from layfigure.motions.motion import Motion
from layfigure.scenes.animating import Animate
from layfigure.scenes.performing import Performer, standing
from layfigure.scenes.picture import Actor
from layfigure.scenes.placing import HOME
from layfigure.scenes.placing import Place as Spot

if TYPE_CHECKING:
    from layfigure.language.executing import Executor
    from layfigure.language.scope import Scope

Floats = NDArray[np.float64]
Point = tuple[float, float, float]
_NARROWEST = 1e-6
_WORK = 20  # steps that somebody in an image stands for


class Take(NamedTuple):
    """A model in one image: as it stands, and where."""

    performer: Performer
    angles: Floats
    carried: Floats
    spot: Spot


class _Acting(NamedTuple):
    performer: Performer
    animate: Animate | None


@dataclass
class Stage:
    """What statements of a scene change. What VIEW and FLOOR do not say is None."""

    run: Run
    frame: int = 0
    point: Point | None = None
    target: Point | None = None
    width: float | None = None
    floor: float | None = None
    behind: list[Actor] = field(default_factory=list)
    _acting: dict[str, _Acting] = field(default_factory=dict)
    _models: dict[str, Model] = field(default_factory=dict)
    _animates: dict[int, Animate] = field(default_factory=dict)
    _motions: dict[int, tuple[list[object], Motion]] = field(default_factory=dict)

    def view(self, evaluator: Evaluator, node: syntax.View) -> None:
        """Do VIEW POINT, VIEW WIDTH or VIEW TARGET."""
        what = f"VIEW {node.what.upper()}"
        with blamed(node.value.place):
            if node.what == "width":
                self.width = checked_number(evaluator.number(node.value, what), what)
                if self.width < _NARROWEST:
                    raise node.value.place.error(f"{what} must be more than 0, at least {_NARROWEST:f}")
                return
            x, y, z = (checked_number(item, what) for item in evaluator.vector(node.value, 3, what))
        if node.what == "point":
            self.point = (x, y, z)
        else:
            self.target = (x, y, z)

    def stand_behind(self, value: object, place: Place) -> None:
        """Add a graphical object or a model to what stands behind.

        Raises:
            SourceError: it is anything else.
        """
        self.run.meter.step(place, _WORK)
        with blamed(place):
            if isinstance(value, Image):
                self.behind.append(value.performer.actor(value.spot))
            elif isinstance(value, Model):
                self.behind.append(standing(value))
            elif isinstance(value, Shape):
                self.run.meter.work("volumes", 5 * len(value.volumes), place)
                self.behind.append(standing(Model.of_link(Link("object", value))))
            else:
                message = f"BACKGROUND shows graphical objects and models, but this is {values.kind_of(value)}"
                raise place.error(message)

    def animate(self, executor: Executor, node: syntax.Animate) -> None:
        """Do ANIMATE for the present frame: the model's name now stands for its image."""
        evaluator, name = executor.evaluator, node.model.name
        model = executor.scope.model(node.model)
        motion = self._motion(evaluator, node.motion)
        first = evaluator.number(node.first, "FROM") if node.first else 0
        last = evaluator.number(node.last, "TO") if node.last else None
        self.run.meter.step(node.place, _WORK)
        with blamed(node.place):
            animate = self._animate(node, motion, first, last)
            performer = self.run.stage.performer(name, self._same(name, model))
            performer.act(animate, self.frame)
        before = self._acting.get(name)
        shows = animate if animate.shows(self.frame) else before.animate if before else None
        self._acting[name] = _Acting(performer, shows)
        executor.scope.set(node.model, Image(model, performer))

    def acting(self, name: str) -> tuple[Floats, Animate | None, int] | None:
        """Return how a model stands in this frame, what moves it, and the frame; None where it does not act."""
        acting = self._acting.get(name)
        return (acting.performer.angles, acting.animate, self.frame) if acting else None

    def takes(self, scope: Scope) -> list[Take]:
        """Return who stands where now that the frame is done, and make ready for the next."""
        found = []
        for name, (performer, _) in self._acting.items():
            value = scope.find(name)
            spot = value.spot if isinstance(value, Image) else HOME
            found.append(Take(performer, performer.angles.copy(), performer.place.copy(), spot))
        self._acting = {}
        return found

    def _animate(
        self, node: syntax.Animate, motion: Motion, first: values.Number, last: values.Number | None
    ) -> Animate:
        """Return what an ANIMATE says, as the same object while it says the same."""
        known = self._animates.get(id(node))
        if known is None or known.motion is not motion or (known.begin, known.end) != (first, last):
            known = self._animates[id(node)] = Animate(motion, first, last, node.repeat)
        return known

    def _motion(self, evaluator: Evaluator, node: syntax.Expression) -> Motion:
        """Return the motion that an expression is; worked out anew only where a name in it has got another value."""
        read = [evaluator.scope.find(name) for name in sorted(names_in(node))]
        before = self._motions.get(id(node))
        if before is None or any(old is not new for old, new in zip(before[0], read, strict=True)):
            before = self._motions[id(node)] = (read, evaluator.motion(node, "USING"))
            self.run.meter.work("new keys", before[1].key_count, node.place)
        return before[1]

    def _same(self, name: str, model: Model) -> Model:
        """Return a model as the object it was in the frame before, if it did not change: what it does then goes on."""
        known = self._models.get(name)
        if known is None or (known.figure, known.main) != (model.figure, model.main):
            known = self._models[name] = model
        return known
