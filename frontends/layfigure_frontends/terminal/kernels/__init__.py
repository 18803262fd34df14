"""The compiled half of the terminal's encoders, and the only place of the front ends where they meet numba.

Each module is one entry point with all it calls: numba notices a change in the file of the cached function only.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from layfigure.compiled import prepare

prepare()  # the cache folder must be chosen before numba is imported

import numba  # noqa: E402

_OPTIONS: dict[str, Any] = {"nogil": True, "error_model": "numpy"}
_ENTRY: dict[str, Any] = {**_OPTIONS, "cache": True}
_INNER: dict[str, Any] = {**_OPTIONS, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}


def entry(signature: Any) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """Return the decorator of an entry point, which is cached with all it calls."""
    return numba.njit(signature, **_ENTRY)


def inner(function: Callable[..., Any]) -> Callable[..., Any]:
    """Decorate what is never called from Python: it has no wrappers, so that a cold start is shorter.

    It is compiled anew for each way its arguments are typed, and a literal is a type: write ``int64(0)``.
    """
    return numba.njit(**_INNER)(function)


def read_only(scalar: Any, dimensions: int) -> Any:
    """Return the numba type of a C-contiguous array that is not written; arrays that may be written fit it too."""
    return numba.types.Array(scalar, dimensions, "C", readonly=True)
