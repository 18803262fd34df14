"""Keeps technique objects for the figure in work and passes events to them under the host's guard."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any

from layfigure.errors import ImpossibleError
from layfigure.figures.figure import Figure
from layfigure.plugins.host import Host
from layfigure.plugins.records import Technique
from layfigure.poses.locks import Lock, anew
from layfigure.poses.pose import Pose
from layfigure.session.answers import is_committed, is_pose_of, misfit
from layfigure.session.bench import FigureBench, Option, Solvers
from layfigure.session.document import Document
from layfigure.session.lock_keeping import changed_limbs, within_locks
from layfigure.session.symmetry import symmetric_echo, symmetric_edit
from layfigure.suggestions import did_you_mean
from layfigure.techniques.contract import EnabledSet, Event, LocksSet, Offer, PoseSet, Setting, TechniqueObject


@dataclass
class Workshop:
    """The techniques of one session. Documents go in and come out; nothing about the pose is kept here.

    ``options`` holds the user's settings by technique id.
    """

    host: Host
    options: Mapping[str, Mapping[str, Option]] = field(default_factory=dict)
    solvers: Solvers = field(init=False)
    _objects: dict[tuple[str, int], tuple[Figure, TechniqueObject[Any]]] = field(default_factory=dict)
    _offer: tuple[str, Any, Offer] | None = None

    def __post_init__(self) -> None:
        self.solvers = Solvers(self.host)

    def record(self, technique: str) -> Technique:
        """Return the record of a technique by id.

        Raises:
            ImpossibleError: no such technique is in service.
        """
        try:
            return self.host.techniques[technique]
        except KeyError:
            known = ", ".join(self.host.techniques) or "none"
            hint = did_you_mean(technique, self.host.techniques)
            raise ImpossibleError(f'there is no technique "{technique}"; in service: {known}{hint}') from None

    def use(self, document: Document, technique: str) -> Document:
        """Return the document with a technique in use; its earlier state is resumed, the pose stays as it is."""
        worker, record = self._object(document.figure, technique), self.record(technique)
        if technique not in document.states:
            setting = Setting(document.pose, document.enabled, document.fresh, document.locks)
            state = self.host.call(record, "starting", worker.start, setting)
        else:
            state = document.states[technique]
            state = self.host.call(record, "telling", worker.tell, state, EnabledSet(document.enabled))
            with suppress(ImpossibleError):
                state = self.host.call(record, "telling", worker.tell, state, LocksSet(document.locks))
            if self._recommended(document, technique, state) != document.pose:
                state = self.host.call(record, "telling", worker.tell, state, PoseSet(document.pose, document.fresh))
        moved = document.with_state(technique, state, document.pose)
        return replace(moved, technique=technique)

    def renew(self, document: Document, former: Mapping[str, Technique]) -> Document:
        """Forget every object made by plug-ins, and hand the states of ``former`` techniques on to their successors.

        A state that the successor cannot read, or that stands at another pose, is dropped.
        """
        dumped = {name: self._dumped(document, former[name]) for name in former if name in document.states}
        self._objects.clear()
        self._offer = None
        self.solvers = Solvers(self.host)
        states = {name: state for name, state in document.states.items() if name not in former}
        for name in set(dumped) & set(self.host.techniques):
            try:
                worker = self._object(document.figure, name)
                state = worker.load(dumped[name])
                if name != document.technique or worker.recommend(state) == document.pose:
                    states[name] = state
            except Exception:  # what another form of the plug-in wrote down may be beyond this one; that is no fault
                continue
        return replace(document, states=MappingProxyType(states))

    def _dumped(self, document: Document, former: Technique) -> Mapping[str, Any]:
        """Return a state as plain data; nothing where the technique that is leaving cannot say it any more."""
        try:
            return self._object(document.figure, former.id).dump(document.states[former.id])
        except Exception:  # it has left already: its faults are nobody's concern now
            return {}

    def tell(self, document: Document, event: Event) -> Document:
        """Return the document after the technique in use heard an event; its recommendation is the new pose.

        Raises:
            ImpossibleError: the event makes no sense now, or the locks do not allow what it asks.
        """
        told = self._told(document, event)
        echo = symmetric_echo(document, event, told)
        return self._netted(document, self._told(told, echo) if echo is not None else told)

    def set_pose(self, document: Document, change: PoseSet, *, settled: bool = False) -> Document:
        """Return the document with a pose that did not come from the technique in use.

        An edit of some limbs has to keep the locks; where the whole pose is another one they are anchored anew.

        Raises:
            ImpossibleError: the locks do not allow the edit.
        """
        if change.limbs is None:
            locks = anew(document.figure, change.pose, document.locks)
            document = self.set_locks(document, locks) if locks != document.locks else document
        else:
            change = change if settled else symmetric_edit(document, change)
            pose = within_locks(self.solvers, document, change.pose, settled=settled)
            followed = changed_limbs(change.pose, pose)
            change = replace(change, pose=pose, limbs=(*(change.limbs or ()), *sorted(followed)))
        moved = replace(document, pose=change.pose, fresh=change.fresh)
        told = self._told(moved, change) if moved.technique else moved
        return replace(told, pose=change.pose, fresh=change.fresh)

    def set_enabled(self, document: Document, enabled: frozenset[int]) -> Document:
        """Return the document with another set of limbs that may change."""
        moved = replace(document, enabled=enabled)
        return self._told(moved, EnabledSet(enabled)) if moved.technique else moved

    def set_locks(self, document: Document, locks: tuple[Lock, ...]) -> Document:
        """Return the document with other locks; a technique that pays no heed to them need not understand."""
        moved = replace(document, locks=locks)
        try:
            return self._told(moved, LocksSet(locks)) if moved.technique else moved
        except ImpossibleError:
            return moved

    def _told(self, document: Document, event: Event) -> Document:
        technique = document.technique
        worker, record = self._object(document.figure, technique), self.record(technique)
        state = self.host.call(record, "telling", worker.tell, document.states[technique], event)
        return document.with_state(technique, state, self._recommended(document, technique, state))

    def _netted(self, before: Document, told: Document) -> Document:
        """Return the document with its pose within its locks, whether the technique heeds them or not."""
        pose = within_locks(self.solvers, before, told.pose)
        if pose == told.pose:
            return told
        limbs = tuple(sorted(changed_limbs(told.pose, pose)))
        return replace(self._told(told, PoseSet(pose, limbs=limbs)), pose=pose, fresh=False)

    def offer(self, document: Document) -> Offer:
        """Return what the technique in use shows; the last offer is kept until the state is another."""
        technique = document.technique
        if not technique:
            return Offer(note="no technique is in service")
        state = document.states[technique]
        if self._offer is not None and self._offer[0] == technique and self._offer[1] is state:
            return self._offer[2]
        worker, record = self._object(document.figure, technique), self.record(technique)
        try:
            offer = self.host.call(record, "asking", worker.ask, state)
        except ImpossibleError as error:  # such as a solver that has been set aside
            offer = Offer(note=str(error))
        wrong = misfit(offer)
        if wrong:
            raise self.host.refuse(record, "asking", wrong)
        for pose in offer.candidates:
            self._check(document.figure, record, pose)
        self._offer = (technique, state, offer)
        return offer

    def ask_anew(self) -> None:
        """Forget the last offer: services have come that were missing when it was made."""
        self._offer = None

    def variants(self, document: Document, count: int, intensity: float) -> tuple[Pose, ...]:
        """Return up to ``count`` small variations of the pose, as the technique in use makes them.

        Raises:
            ImpossibleError: it makes none.
        """
        vary = self.offer(document).variants
        if vary is None:
            raise ImpossibleError("the technique in use makes no variants of a pose; switch to one that does")
        record = self.record(document.technique)
        poses = tuple(self.host.call(record, "varying", vary, count, intensity))
        for pose in poses:
            self._check(document.figure, record, pose)
        return poses

    def _recommended(self, document: Document, technique: str, state: Any) -> Pose:
        worker, record = self._object(document.figure, technique), self.record(technique)
        pose = self.host.call(record, "recommending", worker.recommend, state)
        self._check(document.figure, record, pose, committed=True)
        return pose

    def _check(self, figure: Figure, record: Technique, pose: object, *, committed: bool = False) -> None:
        sentence = f"it gave something else than a finite pose of {len(figure.limbs)} limbs"
        if is_pose_of(pose, figure):
            if not committed or is_committed(pose):
                return
            sentence = "it stands at a pose with angles that no file can hold; make poses by Pose.of"
        raise self.host.refuse(record, "checking a pose", sentence)

    def _object(self, figure: Figure, technique: str) -> TechniqueObject[Any]:
        key = (technique, id(figure))
        if key not in self._objects:
            record = self.record(technique)
            bench = FigureBench(figure, self.options.get(technique, {}), self.solvers)
            self._objects[key] = (figure, self.host.call(record, "making", record.make, bench))
        return self._objects[key][1]
