"""A composed frame and what it shows, as render lists for picking and for drawing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

from layfigure.drawing.joint_kinds import coded_by_kind
from layfigure.drawing.render_list import RenderList
from layfigure.drawing.shots import Colouring, Shot, build_render_list
from layfigure.figures.figure import Figure
from layfigure.poses.pose import Pose
from layfigure.session.frame import Frame
from layfigure.session.ghosts import Scenery, ghost_lists, with_ghosts
from layfigure.session.layout import UNIT, Scale, stretched


@dataclass(frozen=True)
class Picture:
    """A composed frame and what it shows: poses (the working pose first), the shots of them, and the scenery.

    The first ``own`` shots are the working pose's.
    """

    frame: Frame
    figure: Figure
    poses: tuple[Pose, ...]
    shots: tuple[Shot, ...]
    own: int
    colouring: Colouring
    scenery: Scenery

    @cached_property
    def render_list(self) -> RenderList:
        """What all views show, without ghosts: these can be pointed at."""
        return build_render_list(self.figure, self.poses, self.shots, self.colouring)

    def drawn(self, scale: Scale, *, page: bool, kinds: bool) -> tuple[RenderList, ...]:
        """Return what to draw on a surface of so many times the width and height, perhaps without the page.

        ``kinds``: coloured by kinds of joints.
        """
        shots = [replace(shot, rectangle=stretched(shot.rectangle, *scale)) for shot in self.shots]
        haunted = any(self.scenery.ghosts)
        own, rest = (shots[: self.own], shots[self.own :]) if haunted or not page else (shots, [])
        lists = [self._listed(own, scale, kinds=kinds)]
        if haunted:
            lists = [with_ghosts(lists[0], ghost_lists(self.figure, self.scenery, own), kinds=kinds)]
        if page and rest:
            lists.append(self._listed(rest, scale, kinds=kinds))
        return tuple(lists)

    def _listed(self, shots: Sequence[Shot], scale: Scale, *, kinds: bool) -> RenderList:
        if scale == UNIT and len(shots) == len(self.shots):
            listed = self.render_list
        else:
            listed = build_render_list(self.figure, self.poses, shots, self.colouring)
        return coded_by_kind(listed, self.figure) if kinds else listed

    def same_page(self, other: Picture) -> bool:
        """Whether the candidates look the same in both, or what else stands in their place."""
        mine, theirs = self.shots[self.own :], other.shots[other.own :]
        return (
            mine == theirs
            and (self.frame.size, self.frame.theme) == (other.frame.size, other.frame.theme)
            and len(self.poses) == len(other.poses)
            and all(self.poses[shot.pose] is other.poses[shot.pose] for shot in mine)
            and all((self.colouring.styles[shot.pose] == other.colouring.styles[shot.pose]).all() for shot in mine)
            and self.colouring.thin == other.colouring.thin
        )
