"""The functions of motions, models and objects: everything beyond the algebra of 1986 that a script can say."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING

from layfigure.language.arithmetic import rounded
from layfigure.language.functions import Arguments, Function
from layfigure.language.values import plain
from layfigure.models import LinkOf, Model, Shape
from layfigure.motions.building import from_poses
from layfigure.motions.keys import PLACE, ROOT_JOINT
from layfigure.motions.mirroring import mask, mirror
from layfigure.motions.motion import Motion
from layfigure.motions.numbers import RATE
from layfigure.motions.seams import seam_between
from layfigure.motions.standard import interpolation

if TYPE_CHECKING:
    from layfigure.language.values import Number


def _baked(a: Arguments, *motions: Motion) -> None:
    """Count the keys of a result that has one for every frame and joint, before the work is done."""
    frames = max(math.ceil(motion.duration) for motion in motions) + 1
    keys = frames * len({joint for motion in motions for joint in motion.tracks})
    a.meter.keys(keys, a.place)
    a.meter.work("new keys", keys, a.place)


def _crossfade(a: Arguments) -> Motion:
    from layfigure.motions.blending import crossfade

    left, right, frames = a.motion(0), a.motion(1), a.number(2)
    _baked(a, left, right)
    return a.result(crossfade(left, right, frames, a.evaluator.curves))


def _blend(a: Arguments) -> Motion:
    from layfigure.motions.blending import blend

    if len(a) % 2:
        raise a.place.error("blend takes motions each with its weight: blend(walk, 0.7, run, 0.3)")
    parts = [(a.motion(index), a.number(index + 1)) for index in range(0, len(a), 2)]
    _baked(a, *(motion for motion, _ in parts))
    return a.result(blend(*parts, curves=a.evaluator.curves))


def _additive(a: Arguments) -> Motion:
    from layfigure.motions.blending import additive

    base, layer = a.motion(0), a.motion(1)
    _baked(a, base, layer)
    return a.result(additive(base, layer, a.number(2) if len(a) > 2 else 1, curves=a.evaluator.curves))


def _noise(a: Arguments) -> Motion:
    from layfigure.motions.noise import PERIOD, noise

    motion, amplitude, seed = a.motion(0), a.number(1), a.whole(2)
    period = a.number(3) if len(a) > 3 else PERIOD
    if period > 0:
        keys = (math.ceil(motion.duration / period) + 2) * len(motion.tracks)
        a.meter.keys(keys, a.place)
        a.meter.work("new keys", keys, a.place)
    joints = [joint for joint in motion.tracks if joint not in (PLACE, ROOT_JOINT)]
    return a.result(noise(joints, motion.duration, amplitude, seed, period))


def _warp(a: Arguments) -> Motion:
    from layfigure.motions.warping import warp

    motion, ease = a.motion(0), interpolation(a.evaluator.curves, a.word(1).casefold())
    _baked(a, motion)
    return a.result(warp(motion, ease, a.evaluator.curves))


def _slowed(a: Arguments) -> Motion:
    from layfigure.motions.rates import within_rates

    motion, velocity = a.motion(0), a.number(1)
    acceleration = a.number(2) if len(a) > 2 else None
    a.meter.work("new keys", 20 * motion.key_count, a.place)
    return a.result(within_rates(motion, velocity, acceleration, curves=a.evaluator.curves))


def _slerp(a: Arguments) -> Motion:
    """slerp(motion, model): the shortest turns from key to key; what leaves limits is clamped where it is shown."""
    from layfigure.motions.slerp import slerp

    motion, figure = a.motion(0), a.model(1).figure
    _baked(a, motion)
    return a.result(slerp(motion, figure))


def _strip(a: Arguments) -> Motion:
    return a.motion(0).strip(*(a.joint(index) for index in range(1, len(a))))


def _without(a: Arguments) -> Motion:
    return a.motion(0).without(*(a.joint(index) for index in range(1, len(a))))


def _masked(a: Arguments) -> Motion:
    """mask(motion, model, part, ...): only the joints of a side, a limb, or a limb and all below it (``"arm+"``)."""
    parts = [a.word(index) for index in range(2, len(a))]
    return a.motion(0).strip(mask(a.model(1).figure, *parts))


def _synchronize(a: Arguments) -> Motion:
    from layfigure.motions.motion import synchronize

    return a.result(synchronize(*(a.motion(index) for index in range(len(a)))))


def _at(a: Arguments) -> tuple[Number, ...]:
    """at(motion, frame, joint): where a joint stands, exactly; (0, 0, 0) where it is silent."""
    joint, motion = a.joint(2), a.motion(0)
    if joint not in motion.tracks:
        raise a.at(2).error(
            f"this motion does not move joint {joint}; it moves {', '.join(motion.joints[:12]) or 'none'}"
        )
    states = motion.strip(joint).states(a.number(1), a.evaluator.curves)
    if joint not in states:
        return (0, 0, 0)
    return tuple(a.meter.number(Fraction(axis.value), a.place) for axis in states[joint])


def _through(a: Arguments) -> Motion:
    """through(frame, pose, frame, pose, ...): the motion through poses of one figure."""
    if len(a) % 2:
        raise a.place.error("through takes frames each with its pose: through(0, standing, 12, sitting)")
    rows = [(a.number(index), a.pose(index + 1)) for index in range(0, len(a), 2)]
    figure = rows[0][1].figure
    for index, (_, pose) in enumerate(rows):
        if pose.figure.name != figure.name or len(pose.figure.limbs) != len(figure.limbs):
            names = f"{figure.name} and {pose.figure.name}"
            raise a.at(2 * index + 1).error(f"these poses are of two figures, {names}; a motion leads through one's")
    a.meter.work("new keys", len(rows) * len(figure.limbs), a.place)
    return a.result(from_poses(figure, [(frame, pose.pose) for frame, pose in rows]))


def _link(a: Arguments) -> LinkOf:
    return a.model(0).link(a.word(1))


def _coloured(a: Arguments) -> Shape | Model:
    """coloured(object, colour): a graphical object in one colour, or a model of which every link is."""
    painted = a.shape_or_model(0).coloured(a.word(1))
    shapes = [link.shape for link in painted.links] if isinstance(painted, Model) else [painted]
    a.meter.count("volumes", sum(len(shape.volumes) for shape in shapes), a.place)
    return painted


def _fit(a: Arguments) -> Motion:
    return a.motion(0).fit(a.number(1), a.number(2) if len(a) > 2 else RATE)


def _mark(a: Arguments) -> Motion:
    motion, time = a.motion(0), a.number(1)
    if not 0 <= time <= motion.duration:
        raise a.at(1).error(f"a mark lies in its motion, from frame 0 to {plain(motion.duration)}")
    return motion.marked(time, a.word(2))


def _jump(a: Arguments) -> Number:
    """jump(motion): by how many degrees joints jump where the motion is repeated."""
    motion = a.motion(0)
    return rounded(seam_between(motion, motion, curves=a.evaluator.curves).jump, a.place)


MOTION_FUNCTIONS: dict[str, Function] = {
    "reverse": Function("reverse(motion)", 1, 1, lambda a: a.motion(0).reverse()),
    "speed": Function("speed(motion, factor)", 2, 2, lambda a: a.motion(0).speed(a.number(1))),
    "fit": Function("fit(motion, seconds [, rate])", 2, 3, _fit),
    "hold": Function("hold(motion, frames)", 2, 2, lambda a: a.motion(0).hold(a.number(1))),
    "silence": Function("silence(frames)", 1, 1, lambda a: Motion.silence(a.number(0))),
    "crossfade": Function("crossfade(motion, motion, frames)", 3, 3, _crossfade),
    "blend": Function("blend(motion, weight, ...)", 2, None, _blend),
    "additive": Function("additive(motion, layer [, weight])", 2, 3, _additive),
    "noise": Function("noise(motion, degrees, seed [, period])", 3, 4, _noise),
    "warp": Function("warp(motion, interpolation)", 2, 2, _warp),
    "slowed": Function("slowed(motion, velocity [, acceleration])", 2, 3, _slowed),
    "slerp": Function("slerp(motion, model)", 2, 2, _slerp),
    "mirror": Function("mirror(motion, model)", 2, 2, lambda a: mirror(a.motion(0), a.model(1).figure)),
    "clamp": Function("clamp(motion, model)", 2, 2, lambda a: a.motion(0).clamped(a.model(1).figure)[0]),
    "mask": Function("mask(motion, model, part, ...)", 3, None, _masked),
    "strip": Function("strip(motion, joint, ...)", 2, None, _strip),
    "without": Function("without(motion, joint, ...)", 2, None, _without),
    "synchronize": Function("synchronize(motion, ...)", 1, None, _synchronize),
    "mark": Function("mark(motion, frame, name)", 3, 3, _mark),
    "through": Function("through(frame, pose, ...)", 2, None, _through),
    "duration": Function("duration(motion)", 1, 1, lambda a: a.meter.number(a.motion(0).duration, a.place)),
    "at": Function("at(motion, frame, joint)", 3, 3, _at),
    "jump": Function("jump(motion)", 1, 1, _jump),
    "link": Function("link(model, name)", 2, 2, _link),
    "coloured": Function("coloured(object, colour)", 2, 2, _coloured),
}
