"""Shoots scenes: runs a scene's body once for each image, and gathers who stood where, seen how, into pictures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from layfigure.language import syntax
from layfigure.language.evaluating import blamed
from layfigure.language.executing import Executor
from layfigure.language.stage import Stage, Take
from layfigure.scenes.framing import Seen, framed
from layfigure.scenes.picture import Actor, ScenePicture, Shooting

_JUMP = 1.0  # degrees that a repeated motion may jump before it is told


class _Picture(NamedTuple):
    """What is known of a picture before the models in it are placed; the camera is that of its first image."""

    behind: tuple[Actor, ...]
    takes: tuple[Take, ...]
    seen: Seen
    floor: float | None


def shoot(executor: Executor) -> None:
    """Shoot every scene that waits, in ascending order of their numbers.

    Raises:
        SourceError: a statement of a scene cannot be done, or a limit is passed.
    """
    run = executor.run
    for number in sorted(run.waiting):
        defined = run.waiting.pop(number)
        inside = Executor(run, defined.scope, executor.folder, Stage(run))
        run.shot.append(_shooting(inside, number, defined.block))


def _shooting(executor: Executor, number: int, block: syntax.SceneBlock) -> Shooting:
    run, stage = executor.run, executor.stage
    assert stage is not None
    executor.block(block.initial)
    length = _at_least_one(executor, block.length, "LENGTH")
    together = _at_least_one(executor, block.same_frame, "SAMEFRAME") if block.same_frame else 1
    run.meter.count("pictures", -(-length // together), block.length.place)
    run.stage.begin(length)
    standing = tuple(stage.behind)
    shots = []
    for first in range(0, length, together):
        shots.append(_picture(executor, block, range(first, min(first + together, length)), standing))
    with blamed(block.place):
        shooting = run.stage.finish(number, _placed(shots, run.aspect))
    _warn(executor, shooting, block)
    return shooting


def _at_least_one(executor: Executor, node: syntax.Expression, what: str) -> int:
    value = executor.evaluator.whole(node, what)
    if value < 1:
        raise node.place.error(f"{what} must be 1 or more, but is {value}")
    return value


def _picture(executor: Executor, block: syntax.SceneBlock, frames: range, standing: tuple[Actor, ...]) -> _Picture:
    """Return one picture, which may hold several images."""
    stage = executor.stage
    assert stage is not None
    behind, takes, seen = list(standing), [], None
    for frame in frames:
        stage.frame, stage.behind = frame, []
        executor.scope.set(syntax.Identifier(block.place, "frame", "FRAME"), frame)
        executor.block(block.body)
        seen = seen or Seen(stage.point, stage.target, stage.width)
        behind += stage.behind
        takes += stage.takes(executor.scope)
    executor.run.meter.count("actors", len(behind) + len(takes), block.place)
    assert seen is not None
    return _Picture(tuple(behind), tuple(takes), seen, stage.floor)


def _placed(shots: list[_Picture], aspect: float) -> list[ScenePicture]:
    """Return the pictures; where the script does not say what is seen, everything is."""
    actors = _actors([take for shot in shots for take in shot.takes])
    shown = [(*shot.behind, *(next(actors) for _ in shot.takes)) for shot in shots]
    cameras = framed([shot.seen for shot in shots], shown, aspect)
    return [ScenePicture(who, camera, shot.floor) for who, camera, shot in zip(shown, cameras, shots, strict=True)]


def _actors(takes: list[Take]) -> Iterator[Actor]:
    """Yield the actors of takes in their order; those of one model are placed all at once."""
    by_performer: dict[int, list[int]] = {}
    for index, take in enumerate(takes):
        by_performer.setdefault(id(take.performer), []).append(index)
    placed: dict[int, Actor] = {}
    for indices in by_performer.values():
        chosen = [takes[index] for index in indices]
        angles, carried = np.stack([take.angles for take in chosen]), np.stack([take.carried for take in chosen])
        actors = chosen[0].performer.actors(angles, carried, [take.spot for take in chosen])
        placed.update(zip(indices, actors, strict=True))
    yield from (placed[index] for index in range(len(takes)))


def _warn(executor: Executor, shooting: Shooting, block: syntax.SceneBlock) -> None:
    """Note what is allowed but seldom meant."""
    run, place, name = executor.run, block.place, f"scene {shooting.number}"
    if shooting.clamps:
        run.warn(place, f"{name}: joint limits {shooting.clamps}")
    for seam in shooting.seams:
        if seam.jump > _JUMP:
            run.warn(place, f"{name}: a repeated motion jumps where it begins anew: {seam}")
    if shooting.unknown:
        names = ", ".join(shooting.unknown[:12])
        run.warn(place, f"{name}: motions move {names}, for which the model has no joint")
