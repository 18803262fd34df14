"""Models that act: each keeps the orientation it was last given, from statement to statement and scene to scene."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Hashable, Sequence

import numpy as np
from numpy.typing import NDArray

from layfigure.figures.figure import Figure
from layfigure.figures.handedness import MIRRORED
from layfigure.models.articulated import Model
from layfigure.motions.clamping import merged
from layfigure.motions.joints import joint_limbs
from layfigure.motions.keys import PLACE
from layfigure.motions.standard import STANDARD, Curves
from layfigure.scenes.animating import Animate, Track
from layfigure.scenes.picture import Actor, ScenePicture, Shooting
from layfigure.scenes.placing import HOME, Place, placed

Floats = NDArray[np.float64]
Who = Figure | Model
"""Whom a scene can show: a figure, a model, or a graphical object, which is a figure of a root alone."""

MAXIMUM_IMAGES = 1_000_000
_ALIVE = 32  # ANIMATEs of one model that are kept sampled


class Performer:
    """A model in a scene of ``length`` frames: ``angles`` (n, 3) and ``place`` (3,) are how it was last seen.

    The place is where its motions have carried the root, in script coordinates.
    """

    def __init__(self, who: Who, length: int = MAXIMUM_IMAGES, curves: Curves = STANDARD) -> None:
        self.who, self.figure = who, figure_of(who)
        self.angles: Floats = np.zeros((len(self.figure.limbs), 3))
        self.place: Floats = np.zeros(3)
        self._began: Floats = np.zeros(3)
        self._length, self._curves = length, curves
        self._tracks: OrderedDict[Animate, Track] = OrderedDict()
        self._base: Floats = np.zeros(3)
        self._bases: dict[Animate, Floats] = {}
        self._finished: list[Track] = []

    def act(self, animate: Animate, frame: int) -> None:
        """Do what an ANIMATE says on a frame; on frames that it does not show, nothing."""
        if not animate.shows(frame):
            return
        moment = self._track(animate).on(frame)
        self.angles[moment.moved] = moment.angles[moment.moved]
        if moment.place is not None:
            self._go(animate, frame, moment.place)

    def actor(self, place: Place = HOME) -> Actor:
        """Return the model as it stands now, put at a place of the scene."""
        return self.actors(self.angles[None], self.place[None], [place])[0]

    def actors(self, angles: Floats, carried: Floats, places: Sequence[Place]) -> list[Actor]:
        """Return the model as it stood on f frames, angles (f, n, 3) and places (f, 3) of its own, at f places.

        A main link other than the root stays still: it stands where it is put, wherever motions carry the root.
        """
        angles, translations = np.array(angles), carried * MIRRORED
        if isinstance(self.who, Model):
            angles, translations = self.who.standing(angles, translations)
        turns, shifts = np.array([p.matrix for p in places]), np.array([p.shift for p in places])
        angles, translations = placed(self.figure, angles, translations, turns, shifts)
        angles.flags.writeable = translations.flags.writeable = False
        return [Actor(self.figure, one, moved) for one, moved in zip(angles, translations, strict=True)]

    def recast(self, who: Who, length: int) -> Performer:
        """Return a performer of another scene, perhaps of a changed model, in the orientation that this one has.

        Joints are known by their ids. The root starts from where it is put.
        """
        other = Performer(who, length, self._curves)
        if other.figure is self.figure:
            other.angles[:] = self.angles
            return other
        mine = joint_limbs(self.figure)
        for joint, theirs in joint_limbs(other.figure).items():
            if joint in mine:
                other.angles[list(theirs.limbs)] = theirs.spread(mine[joint].read(self.angles))
        return other

    @property
    def tracks(self) -> tuple[Track, ...]:
        """Every ANIMATE that was shown, with its reports."""
        return (*self._finished, *self._tracks.values())

    def _track(self, animate: Animate) -> Track:
        if animate in self._tracks:
            self._tracks.move_to_end(animate)
            return self._tracks[animate]
        track = self._tracks[animate] = Track(self.figure, animate, self._length, self._curves)
        if len(self._tracks) > _ALIVE:
            self._finished.append(self._tracks.popitem(last=False)[1])
        return track

    def _go(self, animate: Animate, frame: int, place: Floats) -> None:
        """Carry the root: a motion that sets in goes on from where the root is, as at the seam of a sum of motions.

        On axes on which neither it nor what came before travels it stands at the place it says
        (:mod:`layfigure.motions.travel`).
        """
        if animate not in self._bases or frame - animate.begin < 1:
            spans = animate.motion.tracks[PLACE]
            first = np.array([float(value) for value in spans[0].first])
            travels = [any(span.first[axis] != span.last[axis] for span in spans) for axis in range(3)]
            moving = np.array(travels) | (self.place != self._began)
            self._base = self._bases[animate] = np.where(moving, self.place - first, self._base)
            self._began = self._base + first
        self.place = self._bases[animate] + place


class Stage:
    """Holds performers by key while a program goes through its scenes frame by frame, and gathers their reports.

    ``begin`` a scene, let performers ``animate`` and be ``shown`` on ascending frames, and ``finish`` with the
    pictures made of the actors; performers keep their orientations for the scenes that follow. A key is whatever the
    program knows a model by, such as a variable's name; the model itself may change.
    """

    def __init__(self, curves: Curves = STANDARD) -> None:
        self._curves = curves
        self._length = MAXIMUM_IMAGES
        self._performers: dict[Hashable, Performer] = {}
        self._gone: list[Performer] = []

    def begin(self, length: int) -> None:
        """Begin a scene of that many frames: no motion goes on, and roots start from where they are put."""
        self._length, self._gone = length, []
        self._performers = {key: performer.recast(performer.who, length) for key, performer in self._performers.items()}

    def performer(self, key: Hashable, who: Who) -> Performer:
        """Return who performs under a key, made now or turned into the model as it is now."""
        known = self._performers.get(key)
        if known is None:
            known = self._performers[key] = Performer(who, self._length, self._curves)
        elif known.who is not who:
            self._gone.append(known)
            known = self._performers[key] = known.recast(who, self._length)
        return known

    def animate(self, key: Hashable, who: Who, animate: Animate, frame: int, place: Place = HOME) -> Actor:
        """Do what an ANIMATE says on a frame, and return the model as it stands then."""
        performer = self.performer(key, who)
        performer.act(animate, frame)
        return performer.actor(place)

    def shown(self, key: Hashable, who: Who, place: Place = HOME) -> Actor:
        """Return a model as it stands, neutral if it never moved."""
        return self.performer(key, who).actor(place)

    def finish(self, number: int, pictures: Sequence[ScenePicture]) -> Shooting:
        """Return the scene with what there is to say about the motions shown in it."""
        tracks = [track for each in (*self._gone, *self._performers.values()) for track in each.tracks]
        seams = tuple(dict.fromkeys(track.seam for track in tracks if track.seam is not None))
        unknown = tuple(dict.fromkeys(joint for track in tracks for joint in track.unknown))
        return Shooting(number, tuple(pictures), merged(track.clamps for track in tracks), seams, unknown)


def figure_of(who: Who) -> Figure:
    """Return the figure that a scene shows for a figure or a model."""
    return who.figure if isinstance(who, Model) else who


def standing(who: Who, place: Place = HOME) -> Actor:
    """Return a figure or a model at rest, put at a place of the scene."""
    return Performer(who).actor(place)
