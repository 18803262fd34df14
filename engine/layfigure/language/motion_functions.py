"""x"""
from layfigure.language.functions import Function
MOTION_FUNCTIONS: dict[str, Function] = {}
