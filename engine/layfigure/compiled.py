"""Machine code: where it is kept, whether it is ready, and how to get it. Importing this module does not import numba.

Compiling all kernels takes seconds, loading them from the cache a fraction of one. A front end that wants to show
something at once therefore does::

    compiled.prepare()                  # before anything imports numba
    if not compiled.is_warm():          # first start: compile elsewhere, a thread would hold the interpreter lock
        subprocess.run([sys.executable, "-m", "layfigure_frontends", "warm"])
    compiled.load()                     # in a thread, after the subprocess; then make the compiled renderers

and draws with a renderer that is not ``compiled`` until :func:`loaded` is true. Everything in the engine that has a
compiled form asks :func:`loaded` at each call and works in numpy until then.
"""

from __future__ import annotations

import atexit
import hashlib
import importlib.metadata
import importlib.util
import os
import platform
import shutil
import sys
import tempfile
import threading
from collections.abc import Iterator
from pathlib import Path

import layfigure
from layfigure import places

_VARIABLE = "NUMBA_CACHE_DIR"


class _Progress:
    """Whether this process has loaded the engine's kernels."""

    loaded = False
    lock = threading.Lock()


def prepare() -> Path:
    """Point numba at the user's cache folder and return it; call before numba is imported.

    A folder that ``NUMBA_CACHE_DIR`` names already is kept. Where the user's cache cannot be written, a temporary
    folder serves; child processes inherit it, and it goes when this process ends.
    """
    named = os.environ.get(_VARIABLE)
    if named:
        return Path(named)
    folder = _writable(places.cache() / "numba") or _temporary()
    os.environ[_VARIABLE] = str(folder)
    return folder


def is_warm() -> bool:
    """Return whether the cache holds every kernel for this very combination of code, libraries and machine."""
    try:
        return _stamp().is_file()
    except OSError:
        return False


def mark_warm() -> None:
    """Note that every kernel is compiled; call once the engine's and all renderers' kernels have been loaded."""
    stamp = _stamp()
    try:
        stamp.parent.mkdir(parents=True, exist_ok=True)
        stamp.touch()
    except OSError:
        return  # the next start finds a cold cache and compiles again


def loaded() -> bool:
    """Return whether the engine's kernels can be called in this process without waiting."""
    return _Progress.loaded


def load() -> None:
    """Load the engine's kernels, compiling those that the cache lacks; returns at once when that is done already."""
    with _Progress.lock:
        if _Progress.loaded:
            return
        prepare()
        importlib.import_module("layfigure.kernels")

        _Progress.loaded = True


def _writable(folder: Path) -> Path | None:
    """Return the folder, made, if files can be created in it."""
    if not folder.is_absolute():  # no home folder is known, so "~" was left as it stood
        return None
    try:
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()
    except OSError:
        return None
    return folder


def _temporary() -> Path:
    """Return a fresh private folder: cached machine code in a folder others can write would run as the user."""
    folder = Path(tempfile.mkdtemp(prefix="layfigure-numba-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def _stamp() -> Path:
    return prepare() / f"layfigure-warm-{_combination()}"


def _combination() -> str:
    """Return a digest of all that decides whether cached machine code may be used again.

    numba's own key has the processor's name, which costs an import of llvmlite to ask; the host's name stands for it.
    """
    facts = [
        layfigure.__version__,
        sys.version,
        platform.machine(),
        platform.node(),
        *(importlib.metadata.version(name) for name in ("numba", "llvmlite", "numpy")),
        *(os.environ.get(name, "") for name in ("NUMBA_CPU_NAME", "NUMBA_CPU_FEATURES")),
    ]
    digest = hashlib.sha256("\0".join(facts).encode())
    for path in _kernel_sources():
        digest.update(b"\0" + str(path).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:24]


def _kernel_sources() -> Iterator[Path]:
    """Yield the kernels modules of the engine and of every package that declares a plug-in."""
    plugins = importlib.metadata.entry_points(group="layfigure")
    packages = {"layfigure", *(entry.value.partition(":")[0].partition(".")[0] for entry in plugins)}
    for package in sorted(packages):
        spec = importlib.util.find_spec(package)
        for folder in spec.submodule_search_locations or [] if spec else []:
            yield from sorted({*Path(folder).rglob("kernels.py"), *Path(folder).rglob("kernels/*.py")})
