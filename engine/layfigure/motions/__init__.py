"""Motions: joint angles over exact rational time as immutable values, their algebra, and their application to figures.

Begin with :class:`layfigure.motions.motion.Motion`; docs/motions.md is the tour.
"""
