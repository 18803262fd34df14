"""How the engine's kernels are compiled: without fastmath, because poses may depend on every bit."""

from __future__ import annotations

from typing import Any

import numba
from numba import types

_OPTIONS: dict[str, Any] = {"cache": True, "nogil": True, "error_model": "numpy"}

jit = numba.njit(**_OPTIONS)
inlined = numba.njit(inline="always", **_OPTIONS)


def compiled(result: Any, *arguments: Any) -> Any:
    """Return the decorator of a kernel that Python calls, compiled for exactly these types.

    A full signature means that no call ever meets a variant that is still to be compiled.
    """
    return numba.njit(result(*arguments), **_OPTIONS)


def read(dtype: Any, dimensions: int) -> Any:
    """Return the type of an array that a kernel reads; writeable ones fit too."""
    return types.Array(dtype, dimensions, "C", readonly=True)


def written(dtype: Any, dimensions: int) -> Any:
    """Return the type of an array that a kernel writes."""
    return types.Array(dtype, dimensions, "C")
