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


def steps(host: Host, also: Iterable[Step] = ()) -> Iterator[Step]:
    """Yield what makes every kernel ready, as (title, work), in order; what fails is set aside with its plug-in.

    What draws comes before what poses: a window that shows solids may be used while solvers still compile.
    ``also`` is what a front end has of its own, wanted soonest.
    """
    yield "the engine", compiled.load
    yield from also
    records: list[Renderer | Solver] = [*host.renderers.values(), *host.solvers.values()]
    for record in records:
        if record.warm is not None:
            yield record.title, _warm(host, record)
    yield "a note that all is ready", compiled.mark_warm


def _warm(host: Host, record: Renderer | Solver) -> Callable[[], object]:
    def work() -> None:
        assert record.warm is not None
        with suppress(PluginError):
            host.call(record, "warming", record.warm)

    return work


class Warming:
    """Compiles in another process where the cache is cold, then loads in a thread; the window goes on meanwhile."""

    def __init__(self, host: Host, done: Callable[[str], None], also: Iterable[Step] = ()) -> None:
        """``done(fault)`` is called in the thread, with an empty text or a sentence that says what went wrong."""
        self._host = host
        self._done = done
        self._also = tuple(also)
        self._compiler: subprocess.Popen[bytes] | None = None
        self._stopped = threading.Event()
        self._thread = threading.Thread(target=self._work, name="warming", daemon=True)

    def start(self) -> None:
        """Begin; returns at once."""
        self._thread.start()

    def stop(self) -> None:
        """Give up; a compiler that still runs is ended."""
        self._stopped.set()
        if self._compiler is not None and self._compiler.poll() is None:
            self._compiler.terminate()
            self._compiler.wait()

    def join(self, seconds: float) -> bool:
        """Wait for the end of the work; return whether it came in time."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def _work(self) -> None:
        fault = ""
        try:
            if not compiled.is_warm():
                self._compile()
            for _, work in steps(self._host, self._also):
                if self._stopped.is_set():
                    return
                work()
        except (LayfigureError, OSError, ImportError, RuntimeError) as error:
            fault = f"The fast drawing code cannot be made ready ({error}); figures are drawn as sticks."
        if not self._stopped.is_set():
            self._done(fault)

    def _compile(self) -> None:
        """Fill the cache in a process of its own: compiling in a thread would hold the interpreter lock."""
        compiled.prepare()
        only = () if self._also else ("--window",)
        command = [sys.executable, "-m", "layfigure_frontends", "warm", "--quiet", *only]
        quiet = subprocess.DEVNULL
        self._compiler = subprocess.Popen(command, stdin=quiet, stdout=quiet, stderr=quiet)
        if self._stopped.is_set():
            self._compiler.terminate()
        self._compiler.wait()
