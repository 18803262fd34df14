"""Does what statements say: one method for each kind."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from layfigure.errors import visible
from layfigure.language import syntax, values
from layfigure.language.drafts import Draft, DraftKey, exact
from layfigure.language.evaluating import Evaluator, blamed
from layfigure.language.images import Image
from layfigure.language.modelling import block_model, rerooted
from layfigure.language.places import Place
from layfigure.language.printing import shown, symbols
from layfigure.language.run import Defined, Run
from layfigure.language.scope import Scope
from layfigure.models import Model
from layfigure.models.numbers import checked_number
from layfigure.motions.keys import DEFAULT, Key
from layfigure.motions.motion import Motion
from layfigure.motions.size import check_value
from layfigure.motions.standard import interpolation

if TYPE_CHECKING:
    from layfigure.language.stage import Stage


class Stopped(Exception):  # noqa: N818 - it is no error
    """STOP: the end of the run."""


class Executor:
    """Runs statements in a scope; in a scene's body ``stage`` is the frame being made. Files lie in ``folder``."""

    def __init__(self, run: Run, scope: Scope, folder: Path, stage: Stage | None = None) -> None:
        self.run = run
        self.scope = scope
        self.folder = folder
        self.stage = stage
        self.evaluator = Evaluator(scope, run.meter, run.curves)

    def block(self, block: syntax.Block) -> None:
        """Run statements one after another.

        Raises:
            SourceError: the first that cannot be done, or that passes a limit.
            Stopped: at STOP.
        """
        for statement in block:
            self.run.meter.step(statement.place)
            _METHODS[type(statement)](self, statement)

    # -- values and names --------------------------------------------------------------------------------------------

    def _assignment(self, node: syntax.Assignment) -> None:
        value = self.evaluator.value(node.value)
        if isinstance(value, Model):
            value = self._model(node, value)
        self.scope.set(node.target, value)

    def _model(self, node: syntax.Assignment, value: Model) -> Model:
        """Return a model under the name it is assigned to; one that only gets another name becomes a copy."""
        if isinstance(node.value, syntax.JointOf | syntax.Modified):
            with blamed(node.place):
                value = value.named(node.target.spelled)
        elif isinstance(node.value, syntax.Variable):
            value = value.copy()
        self._warn_of(value, node.place)
        return value

    def _warn_of(self, value: Model, place: Place) -> None:
        for sentence in value.warnings:
            self.run.warn(place, sentence)

    def _declaration(self, node: syntax.Declaration) -> None:
        for name in node.names:
            self.scope.declare(name, node.kind)

    def _print(self, node: syntax.Print) -> None:
        pieces = [self._symbols(item) if isinstance(item, syntax.Symbols) else self._shown(item) for item in node.items]
        joint = "\n" if any("\n" in piece for piece in pieces) else " "
        self.run.printed.append(self.run.meter.printed(visible(joint.join(pieces)), node.place))

    def _shown(self, node: syntax.Expression) -> str:
        value = self.evaluator.value(node)
        if isinstance(value, Motion):
            self.run.meter.work("keys", value.key_count, node.place)
        with blamed(node.place):
            return shown(value)

    def _symbols(self, node: syntax.Symbols) -> str:
        name = node.target
        model = self.scope.model(name)
        value = self.scope.find(name.name)
        acting = self.stage.acting(name.name) if self.stage and isinstance(value, Image) else None
        with blamed(name.place):
            return symbols(model, acting, self.run.curves)

    def _load(self, node: syntax.Load) -> None:
        from layfigure.language.loading import load

        load(self, node)

    def _save(self, node: syntax.Save) -> None:
        from layfigure.language.saving import saving

        self.run.savings.append(saving(self, node))

    def _stop(self, node: syntax.Stop) -> None:
        raise Stopped

    # -- flow --------------------------------------------------------------------------------------------------------

    def _choice(self, node: syntax.Choice) -> None:
        for condition, block in node.branches:
            if values.truth(self.evaluator.value(condition), "the condition of IF", condition.place):
                self.block(block)
                return
        self.block(node.otherwise)

    def _count(self, node: syntax.Count) -> None:
        value = self.evaluator.number(node.first, "where the loop begins")
        last = self.evaluator.number(node.last, "where the loop ends")
        step = self.evaluator.number(node.step, "the loop's step") if node.step else 1
        if not step:
            assert node.step is not None
            raise node.step.place.error("the step of this loop is 0, so it would never end; give it another")
        while (value <= last) if step > 0 else (value >= last):
            self.run.meter.step(node.place)
            self.scope.set(node.variable, value)
            self.block(node.body)
            value = self.run.meter.number(value + step, node.place)

    def _while(self, node: syntax.While) -> None:
        while values.truth(self.evaluator.value(node.condition), "the condition of WHILE", node.condition.place):
            self.run.meter.step(node.place)
            self.block(node.body)

    # -- models and motions ------------------------------------------------------------------------------------------

    def _model_block(self, node: syntax.ModelBlock) -> None:
        value = block_model(self.evaluator, node)
        self._warn_of(value, node.place)
        self.scope.set(node.name, value)

    def _rerooting(self, node: syntax.Rerooting) -> None:
        value = rerooted(self.evaluator, node.figure)
        self._warn_of(value, node.place)
        self.scope.set(node.figure.model, value)

    def _motion_block(self, node: syntax.MotionBlock) -> None:
        draft = Draft()
        for joint, keys in node.tracks:
            name = self.evaluator.joint(joint.joint)
            if name in draft.keys:
                raise joint.place.error(f"joint {name} stands here for the second time; put its keys together")
            if joint.position is not None or not keys:
                position = self._position(joint.position) if joint.position is not None else (exact(0),) * 3
                draft.set(name, 0, DraftKey(joint.place, Key(exact(0), position)))
            for number, key in enumerate(keys, start=1):
                draft.set(name, number, DraftKey(key.place, self._key(key.frame, key.position, key.how)))
                self.run.meter.keys(draft.count, key.place)
        with blamed(node.place):
            self.scope.set(node.name, draft.motion(self.run.meter))

    def _key_assignment(self, node: syntax.KeyAssignment) -> None:
        draft = self._draft(node.target)
        joint = self.evaluator.joint(node.joint)
        number = self.evaluator.whole(node.number, "the number of a key")
        if number < 0:
            raise node.number.place.error("keys count from 0; key 0 is where the joint starts")
        draft.set(joint, number, DraftKey(node.place, self._key(node.frame, node.position, node.how)))
        self.run.meter.keys(draft.count, node.place)

    def _draft(self, name: syntax.Identifier) -> Draft:
        """Return the keys of the motion that a name stands for; a new one where it has no value."""
        found = self.scope.find(name.name)
        if isinstance(found, Draft):
            return found
        if found is not None and not isinstance(found, Motion):
            message = f'"{name.spelled}" is {values.kind_of(found)}; keys are set in motions'
            raise name.place.error(message)
        draft = Draft.of(found, name.place) if found is not None else Draft()
        self.scope.set(name, draft)
        return draft

    def _key(self, frame: syntax.Expression, position: tuple[syntax.Expression, ...], how: Any) -> Key:
        with blamed(frame.place):
            time = exact(self.evaluator.number(frame, "FRAME"))
        name = DEFAULT
        if how is not None:
            with blamed(how.place):
                name = interpolation(self.run.curves, how.name).id
        return Key(time, self._position(position), name)

    def _position(self, nodes: tuple[syntax.Expression, ...]) -> Any:
        if len(nodes) == 1:
            found = self.evaluator.vector(nodes[0], 3, "POSITION")
        elif len(nodes) == 3:
            found = tuple(self.evaluator.number(node, "each angle of POSITION") for node in nodes)
        else:
            raise nodes[0].place.error(f"POSITION takes x, y, z or a vector, but has {len(nodes)} values")
        with blamed(nodes[0].place):
            position = tuple(exact(value) for value in found)
            for value in position:
                check_value(value, "each number of POSITION")
            return position

    # -- scenes ------------------------------------------------------------------------------------------------------

    def _scene(self, node: syntax.SceneBlock) -> None:
        number = self.evaluator.whole(node.number, "the number of a scene")
        if number in self.run.waiting:
            line = self.run.waiting[number].block.place.line
            raise node.place.error(f"scene {number} was defined in line {line} already; give this one another number")
        self.run.waiting[number] = Defined(node, self.scope.copy(self.run.meter, node.place))

    def _shoot(self, node: syntax.Shoot) -> None:
        from layfigure.language.filming import shoot

        if not self.run.waiting:
            raise node.place.error("there is no scene to shoot; define one with INITIALIZE SCENE before")
        shoot(self)

    def _view(self, node: syntax.View) -> None:
        assert self.stage is not None
        self.stage.view(self.evaluator, node)

    def _floor(self, node: syntax.Floor) -> None:
        assert self.stage is not None
        height = self.evaluator.number(node.height, "FLOOR")
        with blamed(node.height.place):
            self.stage.floor = checked_number(height, "FLOOR")

    def _background(self, node: syntax.Background) -> None:
        assert self.stage is not None
        for item in node.objects:
            self.stage.stand_behind(self.evaluator.value(item), item.place)

    def _animate(self, node: syntax.Animate) -> None:
        assert self.stage is not None
        self.stage.animate(self, node)


_METHODS: dict[type[syntax.Statement], Callable[[Executor, Any], None]] = {
    syntax.Assignment: Executor._assignment,
    syntax.KeyAssignment: Executor._key_assignment,
    syntax.Declaration: Executor._declaration,
    syntax.Print: Executor._print,
    syntax.Load: Executor._load,
    syntax.Save: Executor._save,
    syntax.Stop: Executor._stop,
    syntax.Rerooting: Executor._rerooting,
    syntax.View: Executor._view,
    syntax.Floor: Executor._floor,
    syntax.Background: Executor._background,
    syntax.Animate: Executor._animate,
    syntax.Shoot: Executor._shoot,
    syntax.Choice: Executor._choice,
    syntax.Count: Executor._count,
    syntax.While: Executor._while,
    syntax.ModelBlock: Executor._model_block,
    syntax.MotionBlock: Executor._motion_block,
    syntax.SceneBlock: Executor._scene,
}
