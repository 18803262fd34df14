"""What PRINT shows of a value, and of a model's symbol table."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np

from layfigure.files.decimals import plain as decimal
from layfigure.language.images import Image
from layfigure.language.values import PoseOf, kind_of, plain
from layfigure.models import LinkOf, Model, Shape
from layfigure.models.printing import aligned, describe_model, symbol_table
from layfigure.motions.joints import joints_of
from layfigure.motions.keys import DEFAULT
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import written
from layfigure.motions.standard import Curves
from layfigure.poses.pose_file import write_pose
from layfigure.scenes.animating import Animate


def shown(value: object) -> str:
    """Return a value as PRINT shows it: on one line, but models, motions and poses on several."""
    for kinds, show in _SHOWN:
        if isinstance(value, kinds):
            return show(value)
    return kind_of(value)


def symbols(model: Model, acting: tuple[np.ndarray, Animate | None, int] | None, curves: Curves) -> str:
    """Return a model's symbol table; ``acting`` is how it stands, which ANIMATE moves it, and the frame.

    Raises:
        LayfigureError: a key of the motion names an interpolation that ``curves`` does not have.
    """
    if acting is None:
        return symbol_table(model, np.zeros((len(model.figure.limbs), 3)))
    angles, animate, frame = acting
    velocities, accelerations = np.zeros_like(angles), np.zeros_like(angles)
    if animate is not None:
        time = Fraction(frame) - animate.begin
        duration = animate.motion.duration
        if time <= duration or (animate.repeat and duration):
            known = joints_of(model.figure)
            states = animate.motion.states(time % duration if animate.repeat and duration else time, curves)
            for joint, axes in states.items():
                for limb in known.get(joint, ()):
                    velocities[limb] = [float(axis.velocity) for axis in axes]
                    accelerations[limb] = [float(axis.acceleration) for axis in axes]
    return symbol_table(model, angles, velocities, accelerations)


def _motion(motion: Motion) -> str:
    """Return the key frames of a motion as a table."""
    joints = len(motion.tracks)
    head = f"motion of {written(motion.duration)} frames, {joints} joint{'s' * (joints != 1)}, {motion.key_count} keys"
    rows = [("joint", "key", "frame", "position", "interpolation")]
    for joint, spans in motion.tracks.items():
        number = 0
        for span in spans:
            for key in span.keys:
                position = ", ".join(map(written, key.values))
                first = key is span.keys[0]
                rows.append((joint, str(number), written(key.time), position, "" if first else key.how or DEFAULT))
                number += 1
    marks = [f"mark {mark.name} at frame {written(mark.time)}" for mark in motion.marks]
    return "\n".join([head, *aligned(rows), *marks])


def _shape(shape: Shape) -> str:
    low, high = shape.bounds
    corners = " to ".join(f"({', '.join(decimal(float(x)) for x in corner)})" for corner in (low, high))
    kinds = ", ".join(volume.kind for volume in shape.volumes[:8]) + (", ..." if len(shape.volumes) > 8 else "")
    return f"graphical object of {len(shape.volumes)} volumes ({kinds}), from {corners}"


def _link(link: LinkOf) -> str:
    return f"link {link.model.links[link.node].name} of {link.model.title}"


_SHOWN: tuple[tuple[type | tuple[type, ...], Callable[[Any], str]], ...] = (
    (bool, lambda value: str(value).upper()),
    ((int, Fraction), plain),
    (str, str),
    (tuple, lambda value: f"({', '.join(map(plain, value))})"),
    (Motion, _motion),
    (Model, describe_model),
    (Image, lambda value: describe_model(value.model)),
    (Shape, _shape),
    (PoseOf, lambda value: write_pose(value.figure, value.pose).rstrip()),
    (LinkOf, _link),
)
