"""From right-handed space, in which scripts, motions and models speak (Z toward the viewer), to ours and back."""

from __future__ import annotations

import numpy as np

MIRRORED = np.array([1.0, 1.0, -1.0])
"""What points are multiplied with; there and back are the same."""
MIRRORED.flags.writeable = False
