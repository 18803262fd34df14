"""Layfigure: poses articulated figures by letting a person choose among candidates.

The engine has no window. ``import layfigure`` is light: numpy and numba load with the first thing that needs them.
"""

__version__ = "0.1.0"
