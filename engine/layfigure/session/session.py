"""The session: one door for events and command lines, one document, one history, one log.

A front end calls :meth:`Session.handle`, :meth:`Session.frame` and :meth:`Session.draw`; a script or a replay calls
:meth:`Session.execute`. Both end in the same commands, so every session is a text that replays to the same bits.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

from layfigure.configuration import load_bindings
from layfigure.drawing.render_list import PLAIN, Look, RenderList, Target
from layfigure.drawing.theme import ViewTheme, view_theme
from layfigure.errors import LayfigureError, PluginError
from layfigure.plugins.discovery import Found
from layfigure.plugins.host import Host
from layfigure.plugins.records import Command, Technique
from layfigure.poses.packing import pack_pose
from layfigure.session.bench import Option
from layfigure.session.commands import BUILT_IN
from layfigure.session.controls import control_commands
from layfigure.session.describing import describe_limbs
from layfigure.session.document import Document
from layfigure.session.events import Event
from layfigure.session.figures import reference_to
from layfigure.session.frame import Frame, Size
from layfigure.session.history import Change, History
from layfigure.session.keymap import Binding, KeyTable, Situation, control_bindings, spoken, told_first
from layfigure.session.keymap import hints as hints_of
from layfigure.session.layout import UNIT, Scale
from layfigure.session.log import header
from layfigure.session.modes import Mode, Plain
from layfigure.session.playback import Playback
from layfigure.session.rendering import Renderers
from layfigure.session.routing import route
from layfigure.session.stage import Stage
from layfigure.session.techniques import Workshop
from layfigure.session.view import ViewState
from layfigure.session.words import WordError, join_line, quoted, split_line
from layfigure.suggestions import did_you_mean
from layfigure.techniques.contract import Controls, Offer, PoseSet
from layfigure.techniques.contract import Event as TechniqueEvent


@dataclass(frozen=True)
class SessionOptions:
    """What a session is opened with; see :mod:`layfigure.configuration` for where it comes from."""

    technique: str = "generator"
    renderer: str = "raster"
    theme: str = "dark"
    frontend: str = "headless"
    bindings: tuple[Binding, ...] = ()
    reports: Callable[[str], bool] | None = None  # which keys the front end can report; None: all
    keymap: str = ""  # the name that the bindings were loaded by, so that plug-ins which come later add theirs
    technique_options: dict[str, dict[str, Option]] = field(default_factory=dict)
    folder: Path = Path()
    compiled: bool = True  # whether machine code is ready, so that compiled renderers may draw


class Session:
    """One person's work on one document."""

    def __init__(self, host: Host, document: Document, options: SessionOptions | None = None) -> None:
        self.host = host
        self.options = options or SessionOptions()
        self.workshop = Workshop(host, self.options.technique_options)
        self.workshop.solvers.waits = self.options.compiled
        self.view = ViewState(theme=self.options.theme, renderer=self.options.renderer)
        self.modes: list[Mode] = [Plain()]
        self.status = ""
        self.running = True
        self.revision = 0
        self.clipboard = ""
        self.clipboard_out: str | None = None
        self.clipboard_in: Callable[[], str] | None = None
        self.screenshot_request: Path | None = None
        self.saved_as: Path | None = None
        self.on_logged: Callable[[str], None] = lambda line: None
        self.on_closed: Callable[[bool], None] = lambda interrupted: None
        self._renderers = Renderers(host, self.say, compiled=self.options.compiled)
        self._stage = Stage(self)
        self.playback = Playback(self)
        self._before_preview: Document | None = None
        self._key_table: tuple[tuple[Technique, ...], KeyTable] | None = None
        self._faults_seen = 0
        self._left = False  # whether a technique fell out, and the log does not say yet which one took over
        self.log: list[str] = []
        self.begin(document)
        host.notify("layfigure_session_started", session=self)

    # --- for front ends -----------------------------------------------------------------------------------------

    def handle(self, event: Event) -> None:
        """Take one event from a front end. Mistakes and impossibilities end in the status line, never in an error."""
        try:
            route(self, event)
        except LayfigureError as error:
            self.say(str(error))
        self.revision += 1

    def frame(self, size: Size) -> Frame:
        """Return what to show on a surface of that size."""
        return self._stage.compose(size).frame

    def draw(
        self, frame: Frame, target: Target, *, kinds: bool = False, enlarged: Scale = UNIT, page: bool = True
    ) -> None:
        """Draw the views of the frame composed last into a target, perhaps ``enlarged`` or without the ``page``;
        ``kinds`` codes them for :func:`layfigure.drawing.joint_kinds.kinds_shown`."""
        assert self._stage.picture.frame is frame
        for listed in self._stage.picture.drawn(enlarged, page=page, kinds=kinds):
            self.render(listed, target, PLAIN if kinds else None)

    def render(self, render_list: RenderList, target: Target, look: Look | None = None) -> None:
        """Draw with the chosen renderer, or the next that works, in the view's look or another.

        Raises:
            ImpossibleError: no renderer is in service.
        """
        wanted = self.host.renderers.get(self.view.renderer)
        if wanted is not None and wanted.compiled and not self._renderers.compiled:
            self.workshop.solvers.await_compiled()
        self._renderers.draw(render_list, target, look or self.view.look, preferred=self.view.renderer)

    def begin(self, document: Document) -> None:
        """Start over with a document: no history, a log that says where it begins."""
        self.document = self._opened(document)
        self.history = History()
        self.playback.give_up()
        self.view = replace(self.view, selected=(), hover=None, candidate=0)
        self._left = False
        self.log = header(quoted(reference_to(document.figure)), self.document.technique or "none")

    def kernels_ready(self) -> None:
        """Say that compiled renderers and solvers may be used from now on."""
        self._renderers.compiled = True
        self.workshop.ask_anew()
        self.revision += 1

    def close(self, *, interrupted: bool = False) -> None:
        """End the session: plug-ins are told, the journal is put away, or kept for the next start if ``interrupted``.

        Once is enough, twice does no harm.
        """
        if self.running:
            self.running = False
            self.host.notify("layfigure_session_ending", session=self)
            self.on_closed(interrupted)

    # --- for commands and scripts ---------------------------------------------------------------------------------

    def run(self, text: str) -> None:
        """Run a command line as a person typed or clicked it: a mistake goes to the status line."""
        try:
            self.execute(text)
        except LayfigureError as error:
            self.say(str(error))
        self.revision += 1

    def execute(self, text: str) -> None:
        """Run a command line.

        Raises:
            WordError: a word is wrong; ``index`` says which.
            LayfigureError: it cannot be done; the document is as it was.
        """
        line = split_line(text)
        if line is None:
            return
        command = self.commands().get(line.name)
        if command is None:
            hint = did_you_mean(line.name, self.commands())
            raise WordError(0, f'there is no command "{line.name[:40]}"{hint}')
        self.give_up_preview()
        self.playback.make_way(command)
        self._log_leaving()
        self.status = ""
        if self.host.commands.get(command.id) is command:
            words = self.host.call(command, "running", command.run, self, line.words)
        else:
            words = command.run(self, line.words)
        if command.logged:
            self._log(join_line(line.name, line.words if words is None else words))
        self._log_leaving()
        self._report_faults()

    def commands(self) -> dict[str, Command]:
        """Return every command by name: the house's, the plug-ins', and the controls of the technique in use."""
        mine = {command.id: command for command in control_commands(self.controls())}
        return {**BUILT_IN, **self.host.commands, **mine}

    def controls(self) -> tuple[Controls, ...]:
        """Return the controls of the technique in use."""
        record = self.host.techniques.get(self.document.technique)
        return record.controls if record else ()

    def offer(self) -> Offer:
        """Return what the technique in use shows; a technique that fails is left for another one."""
        if self.document.technique not in self.host.techniques:
            self.document = self._in_service(self.document)
        try:
            return self.workshop.offer(self.document)
        except PluginError as error:
            self._leave_technique(str(error))
            return self.workshop.offer(self.document)

    def tell(self, title: str, event: TechniqueEvent, *, entry: bool = True) -> None:
        """Tell the technique in use something and record the change; without ``entry`` undo passes over it."""
        try:
            told = self.workshop.tell(self.document, event)
        except PluginError as error:
            self._leave_technique(str(error))
            raise
        self.commit(title, told, entry=entry)

    def set_pose(self, title: str, change: PoseSet, *, settled: bool = False) -> None:
        """Give the document a pose that did not come from the technique in use; a ``settled`` one keeps all locks."""
        self.commit(title, self.workshop.set_pose(self.document, change, settled=settled))

    def commit(self, title: str, document: Document, *, entry: bool = True) -> None:
        """Make a document the present one; one call is one entry of history."""
        before, self.document = self.document, document
        if self._before_preview is not None:
            return
        if entry and not document.same_as(before):
            self.history.record(Change(title, before, document))
        self._announce(before)

    def restore(self, document: Document) -> None:
        """Make an older document the present one, as undo and redo do."""
        before, self.document = self.document, self._in_service(document)
        self.view = replace(self.view, hover=None, selected=self._still_there(self.view.selected))
        self._announce(before)

    def preview(self, text: str, *, onward: bool = False) -> None:
        """Show what a command line would do, without history or log, until something is run or given up.

        With ``onward`` it is done from where the last preview stands, as the next step of a drag.
        """
        self.playback.settle()
        before = self._before_preview if onward else None
        if before is None:
            self.give_up_preview()
            before = self.document
        log, self.log = self.log, list(self.log)
        callback, self.on_logged = self.on_logged, lambda line: None
        try:
            self._before_preview = before
            line = split_line(text)
            if line is not None and line.name in self.commands():
                self.commands()[line.name].run(self, line.words)
        finally:
            self.log, self.on_logged = log, callback

    @property
    def previewing(self) -> bool:
        """Whether what is shown is a preview."""
        return self._before_preview is not None

    def settle(self, limb: str) -> None:
        """Make the pose that a drag of a limb's end arrived at one change and one line of the log."""
        pose = self.document.pose
        self.give_up_preview()
        if pose != self.document.pose:
            self.execute(join_line("dragged", [limb, pack_pose(self.document.figure, pose)]))

    def give_up_preview(self) -> None:
        """Go back to the document from before a preview."""
        if self._before_preview is not None:
            self.document, self._before_preview = self._in_service(self._before_preview), None

    def use(self, technique: str) -> None:
        """Switch to another technique; the pose stays exactly as it is."""
        self.commit(f"use {technique}", self.workshop.use(self.document, technique), entry=False)

    def swap_plugin(self, found: Found) -> None:
        """Bring a plug-in in, or a newer form of it, while the session runs; the pose stays exactly as it is.

        Raises:
            PluginError: it fails; everything is as it was before.
        """
        present = dict(self.host.techniques)
        self.host.swap(found)
        other = {name for name, record in present.items() if self.host.techniques.get(name) is not record}
        document = self.workshop.renew(self.document, {name: present[name] for name in other})
        self.history.forget_states(other)
        self._renderers.forget()
        if self.options.keymap:
            self.options = replace(self.options, bindings=load_bindings(self.host, self.options.keymap))
        self._key_table = None
        self.document = self._in_service(document)

    def say(self, sentence: str) -> None:
        """Put a sentence into the status line."""
        self.status = sentence

    # --- what things are called -----------------------------------------------------------------------------------

    @property
    def mode(self) -> Mode:
        """The interface state on top."""
        return self.modes[-1]

    @property
    def channels(self) -> frozenset[str]:
        """The kinds of events that the technique in use understands."""
        record = self.host.techniques.get(self.document.technique)
        return record.channels if record else frozenset()

    @property
    def stage(self) -> Stage:
        """What is shown where."""
        return self._stage

    @property
    def theme(self) -> ViewTheme:
        """Colours behind the figures."""
        return view_theme(self.view.theme)

    @property
    def situation(self) -> Situation:
        """Where a key would be pressed now."""
        channels = self.channels if self.document.motion is None else self.channels | {"motion"}
        return Situation(self.mode.state, self.document.technique, self.options.frontend, channels)

    def key_table(self) -> KeyTable:
        """Return all bindings, the techniques' own first, then the keymaps; made anew when a technique falls out."""
        in_service = tuple(self.host.techniques.values())
        if self._key_table is None or self._key_table[0] != in_service:
            own = [b for t in in_service for b in control_bindings(t.id, t.title, t.controls)]
            told = told_first((*own, *self.options.bindings), self.options.reports)
            self._key_table = in_service, KeyTable(told)
        return self._key_table[1]

    def key_for(self, command: str) -> str:
        """Return the name of the first key for a command line, or an empty string."""
        keys = self.key_table().keys_for(command, replace(self.situation, state="pose"))
        return spoken(keys[0]) if keys else ""

    def hints(self) -> tuple[tuple[str, str], ...]:
        """Return the few keys worth showing in the status line now; what a technique's own keys hide is left out."""
        return hints_of(self.key_table(), self.situation)

    def describe_selection(self) -> tuple[str, ...]:
        """Return lines that say what is selected and how it stands."""
        return describe_limbs(self.playback.shown, self.view.selected)

    # --- inside ---------------------------------------------------------------------------------------------------

    def _opened(self, document: Document, preferred: str = "") -> Document:
        if document.technique:
            return document
        for technique in dict.fromkeys([preferred, self.options.technique, *self.host.techniques]):
            if technique in self.host.techniques:
                try:
                    return self.workshop.use(document, technique)
                except PluginError as error:
                    self.say(str(error))
        return document

    def _in_service(self, document: Document) -> Document:
        """Return a document whose technique is in service and has a state; plug-ins may have gone since it was made."""
        states = {name: state for name, state in document.states.items() if name in self.host.techniques}
        if document.technique in states:
            return document if len(states) == len(document.states) else replace(document, states=states)
        self._left = True
        return self._opened(replace(document, technique="", states=states), document.technique)

    def _leave_technique(self, reason: str) -> None:
        """Go on without a technique that failed: the pose stays, another technique takes over."""
        self.document = self._in_service(self.document)
        self.say(reason)

    def _announce(self, before: Document) -> None:
        if self.document.pose is not before.pose and self.document.pose != before.pose:
            self.host.notify("layfigure_pose_changed", session=self, pose=self.document.pose)

    def _still_there(self, selected: tuple[int, ...]) -> tuple[int, ...]:
        return tuple(limb for limb in selected if limb < len(self.document.figure.limbs))

    def _log_leaving(self) -> None:
        if self._left and self.document.technique:
            self._log(join_line("use", [self.document.technique]))
        self._left = False

    def _log(self, line: str) -> None:
        self.log.append(line)
        self.on_logged(line)

    def _report_faults(self) -> None:
        if len(self.host.faults) > self._faults_seen:
            self._faults_seen = len(self.host.faults)
            self.say(str(self.host.faults[-1]))
