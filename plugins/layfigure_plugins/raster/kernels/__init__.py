"""The compiled half of the raster renderer, and the only place where it meets numba.

Each module is one entry point with all it calls: numba notices a change in the file of the cached function only.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from layfigure.compiled import prepare

prepare()  # the cache folder must be chosen before numba is imported

import numba  # noqa: E402

# All of fastmath but "no NaNs, no infinities": the guards against bad input must stay.
_RELAXED = {"nsz", "arcp", "contract", "afn", "reassoc"}


_OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy", "fastmath": _RELAXED}
_ENTRY: dict[str, Any] = {**_OPTIONS, "cache": True}
_INNER: dict[str, Any] = {**_OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def jit(signature: Any = None) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Return the decorator of all kernels here; they draw and never feed a pose, so the maths may be relaxed.

    An entry point names its signature and is cached with all it calls; the rest is never called from Python, and
    leaving out its wrappers and cache files makes a cold start shorter.
    """
    return numba.njit(**_INNER) if signature is None else numba.njit(signature, **_ENTRY)


def read_only(scalar: Any, dimensions: int) -> Any:
    """Return the numba type of a C-contiguous array that is not written; arrays that may be written fit it too."""
    return numba.types.Array(scalar, dimensions, "C", readonly=True)
