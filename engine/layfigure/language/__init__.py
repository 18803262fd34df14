"""The ``.lay`` script language (animation.md 4)."""
