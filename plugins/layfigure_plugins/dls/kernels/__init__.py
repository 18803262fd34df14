"""The compiled half of the solver, and the only place where it meets numba.

``moving`` holds the one entry point; the other modules hold what it calls.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from layfigure.compiled import prepare

prepare()  # the cache folder must be chosen before numba is imported

import numba  # noqa: E402

# No fastmath: what is computed here becomes poses. A division by zero gives what numpy gives, not an exception.
# Without numba's runtime no array is made here and none is counted: the counting costs more than the mathematics.
_OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "_nrt": False}
_ENTRY: dict[str, Any] = {**_OPTIONS, "cache": True}
_INNER: dict[str, Any] = {**_OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def jit(signature: Any = None) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Return the decorator of all kernels here; the entry point names its signature and is cached with all it calls.

    The rest is never called from Python; leaving out its wrappers and cache files makes a cold start shorter.
    """
    return numba.njit(**_INNER) if signature is None else numba.njit(signature, **_ENTRY)


def digest() -> int:
    """Return a number below 2^48 that changes with any kernel's source."""
    found = hashlib.sha256()
    for path in sorted(Path(__file__).parent.glob("*.py")):
        found.update(path.read_bytes())
    return int.from_bytes(found.digest()[:6], "big")


def array(scalar: Any, dimensions: int, readonly: bool = False) -> Any:
    """Return the numba type of a C-contiguous array."""
    return numba.types.Array(scalar, dimensions, "C", readonly=readonly)
