"""Gets machine code ready beside a running front end, which stays usable with renderers that need none."""

from __future__ import annotations

import subprocess
import sys
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from typing import TYPE_CHECKING

from layfigure import compiled
from layfigure.errors import LayfigureError, PluginError
from layfigure.plugins.records import Renderer, Solver

if TYPE_CHECKING:
    from layfigure.plugins.host import Host


Step = tuple[str, Callable[[], object]]
PARTS = ("drawing", "posing")
OWN = "terminal"  # the part of a front end that has machine code of its own


def steps(host: Host, part: str = "", own: Iterable[Step] = ()) -> Iterator[Step]:
    """Yield what makes every kernel ready, or those of one of the :data:`PARTS`, as (title, work), in order.

    ``own`` are a front end's, the part :data:`OWN`.

    What fails is set aside with its plug-in. What draws comes first: a window that shows solids may be used while the
    rest still compiles. The engine comes last, because its being loaded says that solvers are, too.
    """
    if part in ("", OWN):
        yield from own
    if part in ("", "drawing"):
        yield from _warmed(host, host.renderers.values())
    if part in ("", "posing"):
        yield from _warmed(host, host.solvers.values())
        yield "the engine", compiled.load
    if not part:
        yield "a note that all is ready", compiled.mark_warm


def _warmed(host: Host, records: Iterable[Renderer | Solver]) -> Iterator[Step]:
    for record in list(records):
        if record.warm is not None:
            yield record.title, _warm(host, record)


def _warm(host: Host, record: Renderer | Solver) -> Callable[[], object]:
    def work() -> None:
        assert record.warm is not None
        with suppress(PluginError):
            host.call(record, "warming", record.warm)

    return work


class Warming:
    """Compiles in other processes where the cache is cold, then loads in a thread; the window goes on meanwhile."""

    def __init__(self, host: Host, done: Callable[[str], None], own: Iterable[Step] = ()) -> None:
        """``own`` are the front end's own steps, taken first.

        ``done(fault)`` is called in the thread once what draws is ready and again once all is.

        It gets an empty text, or a sentence that says what went wrong.
        """
        self._host = host
        self._done = done
        self._own = tuple(own)
        self._parts = (*([OWN] if self._own else []), *PARTS)
        self._compilers: dict[str, subprocess.Popen[bytes]] = {}
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._work, name="warming", daemon=True)

    def start(self) -> None:
        """Begin; returns at once."""
        self._thread.start()

    def stop(self) -> None:
        """Give up; compilers that still run are ended."""
        self._stopped.set()
        for compiler in list(self._compilers.values()):
            if compiler.poll() is None:
                compiler.terminate()
                compiler.wait()

    def join(self, seconds: float) -> bool:
        """Wait for the end of the work; return whether it came in time."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def _work(self) -> None:
        fault = ""
        try:
            if not compiled.is_warm():
                self._begin_compiling()
            for part in self._parts:
                if not self._make_ready(part):
                    return
                if part == PARTS[0]:
                    self._done("")
            compiled.mark_warm()
        except (LayfigureError, OSError, ImportError, RuntimeError) as error:
            fault = f"The fast code cannot be made ready ({error}); figures may be drawn as sticks."
        if not self._stopped.is_set():
            self._done(fault)

    def _make_ready(self, part: str) -> bool:
        """Load a part, once its compiler is done; return whether to go on."""
        if part in self._compilers:
            self._compilers[part].wait()
        for _, work in steps(self._host, part, self._own):
            if self._stopped.is_set():
                return False
            work()
        return not self._stopped.is_set()

    def _begin_compiling(self) -> None:
        """Fill the cache in processes of their own, side by side: a thread would hold the interpreter lock."""
        compiled.prepare()
        quiet = subprocess.DEVNULL
        for part in self._parts:
            command = [sys.executable, "-m", "layfigure_frontends", "warm", "--quiet", "--only", part]
            self._compilers[part] = subprocess.Popen(
                command, stdin=quiet, stdout=quiet, stderr=quiet, process_group=0
            )  # in a group of their own, so that Ctrl-C at a prompt does not end them
        if self._stopped.is_set():
            self.stop()
