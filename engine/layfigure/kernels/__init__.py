"""The engine's machine code, the only place here that imports numba; import it through ``layfigure.compiled.load``.

Kernels take arrays and numbers, and are compiled when their module is imported, or come from the cache. numba looks for
changes only in the file a kernel stands in, so no kernel calls another file's.
"""

from layfigure.kernels.picking import pick
from layfigure.kernels.placing import build_views, forward, forward_batch, forward_tips

__all__ = ["build_views", "forward", "forward_batch", "forward_tips", "pick"]
