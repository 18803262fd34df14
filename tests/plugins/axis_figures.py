"""Figures whose joints turn about x, y and z, for the tests of what poses them."""

from functools import cache

import numpy as np

from layfigure.figures.figure import Figure
from layfigure.figures.library import read_figure

PUPPET = """trunk {
  handed right
  0 0 0  0 24 0
  cube -6 0 -3  6 0 -3  -6 24 -3  -6 0 3 0x8c6633
  mirror right left joint -7 22 0 upperarm {
    axis x
    0 0 0  0 -12 0
    xdof -120 60
    ydof -70 70
    zdof -30 110
    cylinder 0 0 0  0 -12 0 1.5 0x8c6633
    joint 0 -12 0 forearm {
      0 0 0  0 -10 0
      xdof -140 0
      joint 0 -10 0 hand { 0 0 0  0 -5 1  xdof -60 60  zdof -25 35 }
    }
  }
  mirror right left joint -4 0 0 thigh {
    axis x
    0 0 0  0 -16 0
    xdof -100 40
    zdof -20 60
    joint 0 -16 0 shin {
      0 0 0  0 -16 0
      xdof 0 140
      joint 0 -16 0 foot { axis -z flexionaxis x 0 0 0  0 -1 6  flexiondof -30 30 pivotdof -10 10 }
    }
  }
  joint 0 24 0 head { 0 0 0  0 8 0  xdof -30 40  ydof -80 80 }
  joint 0 12 4 crank { 0 0 0  0 6 0  zdof 0 720  joint 0 6 0 handle { 0 0 0  0 0 4  zdof -180 180 } }
}"""

CHAIN = """base {
  0 0 0  0 6 0
  joint 0 6 0 first {
    0 0 0  0 10 2
    xdof -90 90
    ydof -180 180
    zdof -80 100
    joint 0 10 2 second {
      0 0 0  1 9 0
      xdof -120 20
      ydof -40 60
      zdof -60 60
      joint 1 9 0 third { 0 0 0  0 8 1  xdof -100 100  ydof -30 30  zdof -90 90 }
    }
  }
}"""


AXIS_FIGURES = {"puppet": PUPPET, "chain": CHAIN}
"""The puppet has joints of every kind; the chain has three that turn about x, y and z each."""


@cache
def axis_figure(name: str) -> Figure:
    """Return one of :data:`AXIS_FIGURES`."""
    return read_figure(name, AXIS_FIGURES[name], f"{name}.fig")


def beyond_limits(figure: Figure, angles: np.ndarray) -> float:
    """Return how far the worst of some joint angles (..., n, 3) is outside its limits, in degrees; the root is free."""
    low, high = figure.arrays.limits[1:, :, 0], figure.arrays.limits[1:, :, 1]
    inner = angles[..., 1:, :]
    return float(np.maximum(low - inner, inner - high).max())
