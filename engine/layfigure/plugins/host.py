"""The host: finds plug-ins, collects their records, and calls them one at a time so that one fault stays one fault.

This is the only module that touches pluggy. Built-ins come through the same entry points (group ``layfigure``) as a
stranger's plug-in; nothing here names them.
"""

from __future__ import annotations

import os
import traceback
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import pluggy

from layfigure.errors import FileError, LayfigureError, PluginError
from layfigure.plugins import hookspecs
from layfigure.plugins.discovery import Found, Selection, find_plugins
from layfigure.plugins.records import (
    Command,
    Exchange,
    FigureSource,
    Interpolation,
    Keymap,
    Overlay,
    Record,
    Renderer,
    Solver,
    Technique,
)

T = TypeVar("T")
R = TypeVar("R", Technique, Renderer, Solver, Command, Keymap, Overlay, FigureSource, Interpolation)


@dataclass(frozen=True)
class Fault:
    """A plug-in that failed: whose, doing what, and one sentence; ``detail`` is the traceback for its author."""

    plugin: str
    doing: str
    sentence: str
    detail: str = ""

    def __str__(self) -> str:
        return f"plug-in {self.plugin} was set aside: {self.doing}: {self.sentence}"


class Host:
    """Holds the plug-ins of one program run and guards every call to them.

    Mappings are from record id to record, sorted by id. ``faults`` grows; a plug-in with a fault is not called again.
    Where ``strict`` is true, or with ``LAYFIGURE_STRICT=1`` in the environment, faults are raised instead, for
    plug-in authors.
    """

    def __init__(self, *, strict: bool = False) -> None:
        self.strict = strict
        self.faults: list[Fault] = []
        self.techniques: dict[str, Technique] = {}
        self.renderers: dict[str, Renderer] = {}
        self.solvers: dict[str, Solver] = {}
        self.commands: dict[str, Command] = {}
        self.keymaps: dict[str, Keymap] = {}
        self.overlays: dict[str, Overlay] = {}
        self.figures: dict[str, FigureSource] = {}
        self.interpolations: dict[str, Interpolation] = {}
        self._owners: dict[tuple[type, str], str] = {}
        self._origins: dict[str, str] = {}
        self._relay = pluggy.PluginManager("layfigure")
        self._relay.add_hookspecs(hookspecs)

    @classmethod
    def discover(cls, selection: Selection | None = None) -> Host:
        """Return a host with every plug-in that the selection lets in: entry points, a folder, single files."""
        host = cls()
        for found in find_plugins(selection or Selection()):
            host.admit(found)
        return host

    @property
    def plugins(self) -> tuple[str, ...]:
        """Names of the plug-ins in service, sorted."""
        return tuple(sorted(name for name, _ in self._relay.list_name_plugin()))

    def admit(self, found: Found) -> None:
        """Load one found plug-in and collect its records; a failure becomes a fault."""
        try:
            plugin = found.load()
        except Exception as error:  # an import can raise anything, SystemExit is the author's own wish
            self._fault(found.name, "importing it", error)
            return
        self._origins[found.name] = found.origin
        self.register(plugin, found.name)

    def swap(self, found: Found) -> None:
        """Load a plug-in while the program runs; it takes the place of what the same file brought before.

        Raises:
            PluginError: it fails, or claims what belongs to another plug-in; everything is as it was before.
        """
        trial = Host(strict=self.strict)
        trial.admit(found)
        if trial.faults:
            raise PluginError(f"{found.origin}: {trial.faults[0].doing}: {trial.faults[0].sentence}")
        self._check_claims(found, trial)
        self._set_aside(found.name)
        plugin = trial._relay.get_plugin(found.name)
        assert plugin is not None
        self._relay.register(plugin, found.name)
        self._origins[found.name] = found.origin
        for (_, kind, mine), (_, _, brought) in zip(self._shelves(), trial._shelves(), strict=True):
            mine.update(brought)
            self._owners.update({(kind, identifier): found.name for identifier in brought})
            _sort(mine)

    def records_of(self, plugin: str) -> tuple[Record, ...]:
        """Return the records in service that a plug-in handed over."""
        return tuple(
            record for *_, records in self._shelves() for record in records.values() if self.owner(record) == plugin
        )

    def register(self, plugin: object, name: str) -> None:
        """Put a plug-in (a module or an object with hook implementations) into service under a name."""
        try:
            self._relay.register(plugin, name)
            self._relay.check_pending()
        except Exception as error:  # ValueError for a name taken twice, PluginValidationError for a wrong hook
            if self._relay.get_plugin(name) is plugin:
                self._relay.unregister(plugin)
            self._fault(name, "registering it", error)
            return
        self._collect(plugin, name)

    def owner(self, record: Record) -> str:
        """Return the name of the plug-in that handed over a record."""
        return self._owners.get((type(record), record.id), "layfigure")

    def call(self, record: Record, doing: str, function: Callable[..., T], *args: Any) -> T:
        """Call a function of a plug-in's record under guard.

        Raises:
            LayfigureError: as the plug-in raised it (a user's mistake, nothing is set aside).
            PluginError: the plug-in failed and was set aside; the sentence says who and doing what.
        """
        try:
            return function(*args)
        except LayfigureError:
            raise
        except Exception as error:
            fault = self._fault(self.owner(record), f"{doing} of {record.id}", error)
            self._set_aside(fault.plugin)
            raise PluginError(str(fault)) from error

    def refuse(self, record: Record, doing: str, sentence: str) -> PluginError:
        """Set a plug-in aside that answered against its contract; return the error to raise."""
        fault = self._fault(self.owner(record), f"{doing} of {record.id}", PluginError(sentence))
        self._set_aside(fault.plugin)
        return PluginError(str(fault))

    def notify(self, hook: str, **arguments: object) -> None:
        """Tell every plug-in something, one at a time; the faulty are set aside, the rest still hear it."""
        for name, plugin in self._relay.list_name_plugin():
            if plugin is not None:
                self._ask_one(plugin, name, hook, arguments)

    def first(self, hook: str, **arguments: object) -> Exchange | bool | None:
        """Return the first answer that is not None, asking plug-ins one at a time in order of registration.

        Raises:
            FileError: as a plug-in raised it (a file that cannot be read or written, nothing is set aside).
        """
        for name, plugin in self._relay.list_name_plugin():
            answer = self._ask_one(plugin, name, hook, arguments) if plugin is not None else None
            if answer is not None:
                return answer  # type: ignore[no-any-return]
        return None

    def _shelves(self) -> tuple[tuple[str, type[Any], dict[str, Any]], ...]:
        """Return where the records of each collecting hook stand."""
        return (
            ("layfigure_techniques", Technique, self.techniques),
            ("layfigure_renderers", Renderer, self.renderers),
            ("layfigure_solvers", Solver, self.solvers),
            ("layfigure_commands", Command, self.commands),
            ("layfigure_keys", Keymap, self.keymaps),
            ("layfigure_overlays", Overlay, self.overlays),
            ("layfigure_figures", FigureSource, self.figures),
            ("layfigure_interpolations", Interpolation, self.interpolations),
        )

    def _collect(self, plugin: object, name: str) -> None:
        for hook, kind, records in self._shelves():
            self._take(plugin, name, hook, (kind, records))

    def _check_claims(self, found: Found, trial: Host) -> None:
        """Refuse a plug-in whose name or record ids belong to one that came from elsewhere."""
        before = self._origins.get(found.name, "")
        if found.name in self.plugins and not _same_file(before, found.origin):
            raise PluginError(f'{found.origin}: a plug-in "{found.name}" is in service already; rename the file')
        for (_, kind, mine), (_, _, brought) in zip(self._shelves(), trial._shelves(), strict=True):
            for identifier in brought:
                owner = self.owner(mine[identifier]) if identifier in mine else found.name
                if owner != found.name:
                    raise PluginError(f'{found.origin}: {kind.__name__.lower()} "{identifier}" belongs to {owner}')

    def _take(self, plugin: object, name: str, hook: str, place: tuple[type[R], dict[str, R]]) -> None:
        """Put the records that one plug-in hands over for one hook into their mapping."""
        kind, records = place
        answer = self._ask_one(plugin, name, hook, {})
        try:
            offered = list(answer if answer is not None else ())
        except TypeError as error:
            self._fault(name, f"collecting {kind.__name__.lower()} records", error)
            return
        for record in offered:
            if not isinstance(record, kind):
                wrong = PluginError(f"it handed over a {type(record).__name__} where a {kind.__name__} belongs")
                self._fault(name, f"collecting {kind.__name__.lower()} records", wrong)
                continue
            taken = self._owners.setdefault((kind, record.id), name)
            if record.id in records:
                clash = PluginError(f'{kind.__name__.lower()} "{record.id}" belongs to {taken} already; rename one')
                self._fault(name, f"adding {record.id}", clash)
                continue
            records[record.id] = record
        _sort(records)

    def _ask_one(self, plugin: object, name: str, hook: str, arguments: Mapping[str, object]) -> Any:
        """Call one plug-in's implementation of one hook; pluggy loses a whole call when one of many raises."""
        others = [other for _, other in self._relay.list_name_plugin() if other is not None and other is not plugin]
        caller = self._relay.subset_hook_caller(hook, remove_plugins=others)
        try:
            answer = caller(**arguments)
        except FileError:
            raise
        except Exception as error:
            self._fault(name, f"calling {hook}", error)
            self._set_aside(name)
            return None
        if isinstance(answer, list) and not hook.endswith(("_read", "_write")):
            return answer[0] if answer else None
        return answer

    def _fault(self, plugin: str, doing: str, error: BaseException) -> Fault:
        if self.strict or os.environ.get("LAYFIGURE_STRICT") == "1":
            raise error
        sentence = " ".join(str(error).split()) or type(error).__name__
        if not isinstance(error, LayfigureError):
            sentence = f"{type(error).__name__}: {sentence}"
        fault = Fault(plugin, doing, sentence[:300], "".join(traceback.format_exception(error)))
        self.faults.append(fault)
        return fault

    def _set_aside(self, name: str) -> None:
        plugin = self._relay.get_plugin(name)
        if plugin is not None:
            self._relay.unregister(plugin)
        for _, kind, records in self._shelves():
            for identifier in [i for i, record in records.items() if self.owner(record) == name]:
                del records[identifier]
                self._owners.pop((kind, identifier), None)


def _same_file(one: str, other: str) -> bool:
    return bool(one) and Path(one).resolve() == Path(other).resolve()


def _sort(records: dict[str, R]) -> None:
    ordered = sorted(records.items())
    records.clear()
    records.update(ordered)
