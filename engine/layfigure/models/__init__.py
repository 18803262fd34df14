"""Models: rigid links joined to trees, built in Python as in the script language, in script coordinates."""

from layfigure.models.articulated import LinkOf, Model
from layfigure.models.joining import joint, model
from layfigure.models.links import Link
from layfigure.models.parts import Joining
from layfigure.models.shapes import Shape, box, cone, cube, cylinder, sphere

__all__ = ["Joining", "Link", "LinkOf", "Model", "Shape", "box", "cone", "cube", "cylinder", "joint", "model", "sphere"]
