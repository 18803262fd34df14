"""The ``.lay`` script language (animation.md 4): :func:`run_script` takes a file to scenes that can be drawn."""

from layfigure.language.limits import Limits
from layfigure.language.programme import Programme, run_script

__all__ = ["Limits", "Programme", "run_script"]
