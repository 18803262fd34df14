"""Shoots scenes: runs a scene's body once for each image, and gathers who stood where, seen how, into pictures."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from layfigure.language import syntax, values
from layfigure.language.evaluating import Evaluator, blamed
from layfigure.language.executing import Executor
from layfigure.language.images import Image
from layfigure.language.places import Place
from layfigure.language.run import Run
from layfigure.models import Link, Model, Shape
from layfigure.motions.clamping import merged
from layfigure.scenes.animating import Animate
from layfigure.scenes.camera import SceneCamera
from layfigure.scenes.performing import Performer
from layfigure.scenes.picture import Actor, ScenePicture, Shooting
from layfigure.scenes.placing import Place as Spot

if TYPE_CHECKING:
    from layfigure.language.scope import Scope

Floats = NDArray[np.float64]
_POINT = (0.0, 0.0, 10.0)  # in front of the scene, where a script says nothing
_WORK = 20  # steps that an actor in an image stands for


class _Acting(NamedTuple):
    """Which ANIMATE moves a model in the present frame, if any does."""

    performer: Performer
    animate: Animate | None


class _Take(NamedTuple):
    """A model in one image: as it stands, and where."""

    performer: Performer
    angles: Floats
    carried: Floats
    spot: Spot


@dataclass
class Stage:
    """A scene being shot: its camera, its floor, what stands behind, and who acts in the present frame."""

    run: Run
    length: int
    frame: int = 0
    point: tuple[float, float, float] = _POINT
    target: tuple[float, float, float] = (0.0, 0.0, 0.0)
    width: float | None = None
    floor: float | None = None
    performers: dict[str, Performer] = field(default_factory=dict)
    behind: list[Actor] = field(default_factory=list)
    _acting: dict[str, _Acting] = field(default_factory=dict)

    def view(self, evaluator: Evaluator, node: syntax.View) -> None:
        """Do VIEW POINT, VIEW WIDTH or VIEW TARGET."""
        with blamed(node.value.place):
            if node.what == "width":
                width = float(evaluator.number(node.value, "VIEW WIDTH"))
                if width <= 0:
                    raise node.value.place.error("VIEW WIDTH must be more than 0")
                self.width = width
                return
            x, y, z = (float(item) for item in evaluator.vector(node.value, 3, f"VIEW {node.what.upper()}"))
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
                self.behind.append(Performer(value).actor())
            elif isinstance(value, Shape):
                self.run.meter.step(place, _WORK * len(value.volumes))
                self.behind.append(Actor.of(Model.of_link(Link("object", value)).figure))
            else:
                message = f"BACKGROUND shows graphical objects and models, but this is {values.kind_of(value)}"
                raise place.error(message)

    def animate(self, executor: Executor, node: syntax.Animate) -> None:
        """Do ANIMATE for the present frame: the model's name now stands for its image."""
        model = executor.scope.model(node.model)
        evaluator = executor.evaluator
        motion = evaluator.motion(node.motion, "USING")
        first = evaluator.number(node.first, "FROM") if node.first else 0
        last = evaluator.number(node.last, "TO") if node.last else None
        self.run.meter.step(node.place, _WORK)
        name = node.model.name
        with blamed(node.place):
            animate = Animate(motion, first, last, node.repeat)
            performer = self._performer(name, model)
            performer.act(animate, self.frame)
        before = self._acting.get(name)
        shows = animate if animate.shows(self.frame) else before.animate if before else None
        self._acting[name] = _Acting(performer, shows)
        executor.scope.set(node.model, Image(model, performer))

    def acting(self, name: str) -> tuple[Floats, Animate | None, int] | None:
        """Return how a model stands in this frame, what moves it, and the frame; None where it does not act."""
        acting = self._acting.get(name)
        return (acting.performer.angles, acting.animate, self.frame) if acting else None

    def takes(self, scope: Scope) -> list[_Take]:
        """Return who stood where when the frame was done, and make ready for the next."""
        found = []
        for name, acting in self._acting.items():
            value, performer = scope.find(name), acting.performer
            spot = value.spot if isinstance(value, Image) else Spot()
            found.append(_Take(performer, performer.angles.copy(), performer.place.copy(), spot))
        self._acting = {}
        return found

    def _performer(self, name: str, model: Model) -> Performer:
        """Return who acts a model: the one that did, unless the model is another now."""
        known = self.performers.get(name)
        who = known.who if known else None
        if known is not None and isinstance(who, Model) and (who.figure, who.main) == (model.figure, model.main):
            return known
        before = known or self.run.performers.get(name)
        new = before.recast(model, self.length) if before else Performer(model, self.length, self.run.curves)
        self.performers[name] = new
        return new


def shoot(executor: Executor) -> None:
    """Shoot every scene that waits, in ascending order of their numbers.

    Raises:
        SourceError: a statement of a scene cannot be done, or a limit is passed.
    """
    run = executor.run
    for number in sorted(run.waiting):
        defined = run.waiting.pop(number)
        inside = Executor(run, defined.scope, executor.folder)
        run.shot.append(_Shot(inside, number, defined.block).shooting())


class _Shot:
    """One scene being shot."""

    def __init__(self, executor: Executor, number: int, block: syntax.SceneBlock) -> None:
        self._executor = executor
        self._number = number
        self._block = block

    def shooting(self) -> Shooting:
        """Return the scene's pictures.

        Raises:
            SourceError: a statement of it cannot be done, or a limit is passed.
        """
        block, evaluator = self._block, self._executor.evaluator
        stage = self._executor.stage = Stage(self._executor.run, 0)
        self._executor.block(block.initial)
        stage.length = self._at_least_one(evaluator, block.length, "LENGTH")
        together = self._at_least_one(evaluator, block.same_frame, "SAMEFRAME") if block.same_frame else 1
        pictures = -(-stage.length // together)
        self._executor.run.meter.count("pictures", pictures, block.length.place)
        standing = tuple(stage.behind)
        shots = [self._picture(stage, first, together, standing) for first in range(0, stage.length, together)]
        self._executor.run.performers.update(stage.performers)
        return self._finished(stage, shots)

    def _at_least_one(self, evaluator: Evaluator, node: syntax.Expression, what: str) -> int:
        value = evaluator.whole(node, what)
        if value < 1:
            raise node.place.error(f"{what} must be 1 or more, but is {value}")
        return value

    def _picture(self, stage: Stage, first: int, together: int, standing: tuple[Actor, ...]) -> _Picture:
        """Return one picture, of up to ``together`` images."""
        behind: list[Actor] = list(standing)
        takes: list[_Take] = []
        word = syntax.Identifier(self._block.place, "frame", "FRAME")
        for frame in range(first, min(first + together, stage.length)):
            stage.frame, stage.behind = frame, []
            self._executor.scope.set(word, frame)
            self._executor.block(self._block.body)
            behind += stage.behind
            takes += stage.takes(self._executor.scope)
        self._executor.run.meter.count("actors", len(behind) + len(takes), self._block.place)
        return _Picture(tuple(behind), tuple(takes), stage.point, stage.target, stage.width, stage.floor)

    def _finished(self, stage: Stage, shots: list[_Picture]) -> Shooting:
        actors = _actors([take for shot in shots for take in shot.takes])
        pictures = []
        for shot in shots:
            shown = (*shot.behind, *(next(actors) for _ in shot.takes))
            with blamed(self._block.place):
                camera = SceneCamera(shot.point, shot.width or 10.0, shot.target)
            pictures.append(ScenePicture(shown, camera, shot.floor))
        return self._reported(Shooting(self._number, tuple(pictures)), stage)

    def _reported(self, shooting: Shooting, stage: Stage) -> Shooting:
        """Return the scene with what there is to say about it, and warn of what is seldom meant."""
        from dataclasses import replace

        tracks = [track for performer in stage.performers.values() for track in performer.tracks]
        clamps = merged(track.clamps for track in tracks)
        seams = tuple(seam for track in tracks if (seam := track.seam) is not None)
        unknown = tuple(sorted({joint for track in tracks for joint in track.unknown}))
        run, place = self._executor.run, self._block.place
        if clamps:
            run.warn(place, f"scene {self._number}: joint limits {clamps}")
        if unknown:
            run.warn(place, f"scene {self._number}: motions move {', '.join(unknown[:12])}, which the model has no joint for")
        return replace(shooting, clamps=clamps, seams=seams, unknown=unknown)


class _Picture(NamedTuple):
    """What is known of a picture before the models in it are placed."""

    behind: tuple[Actor, ...]
    takes: tuple[_Take, ...]
    point: tuple[float, float, float]
    target: tuple[float, float, float]
    width: float | None
    floor: float | None


def _actors(takes: list[_Take]):  # type: ignore[no-untyped-def]
    """Yield the actors of takes in their order, each model's placed all at once."""
    by_performer: dict[int, list[int]] = {}
    for index, take in enumerate(takes):
        by_performer.setdefault(id(take.performer), []).append(index)
    placed: list[Actor | None] = [None] * len(takes)
    for indices in by_performer.values():
        chosen = [takes[index] for index in indices]
        angles = np.stack([take.angles for take in chosen])
        carried = np.stack([take.carried for take in chosen])
        actors = chosen[0].performer.actors(angles, carried, [take.spot for take in chosen])
        for index, actor in zip(indices, actors, strict=True):
            placed[index] = actor
    return iter(placed)
