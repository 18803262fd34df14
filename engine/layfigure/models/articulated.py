"""The model: rigid links joined to a tree, one of them the main link, as an immutable value (thesis, chapter 3)."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from layfigure.errors import LayfigureError
from layfigure.figures.figure import Figure
from layfigure.models.assembling import Assembled, assembled, origin_in_limb
from layfigure.models.joints import JointId, product
from layfigure.models.links import ROOT, Link, Node, Nodes
from layfigure.models.numbers import Number, exact_number
from layfigure.models.rerooting import held
from layfigure.models.wrapping import nodes_of
from layfigure.suggestions import did_you_mean

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class LinkOf:
    """One link of a model, to join something to: ``human.link("foot")``."""

    model: Model
    node: int


@dataclass(frozen=True)
class Model:
    """Links joined to a tree, parents first; ``main_node`` is the link that stays still when the model moves.

    ``source`` is the loaded figure it is, scaled or not.
    Two models are equal when they are built alike, whatever they are called. Make one with
    :func:`layfigure.models.joining.model`, :meth:`of_link` or :meth:`of_figure`.
    """

    nodes: Nodes
    main_node: int = 0
    name: str = field(default="", compare=False)
    note: str = field(default="", compare=False)
    source: Figure | None = field(default=None, compare=False, repr=False)

    @staticmethod
    def of_link(link: Link) -> Model:
        """Return the model of one link, to which others can be joined."""
        return Model((Node(link, -1, ROOT, Fraction(1)),), name=link.name)

    @staticmethod
    def of_figure(figure: Figure) -> Model:
        """Return a loaded figure as a model: its limbs are links, its joints keep their parametrisation and limits."""
        model = Model(nodes_of(figure), name=figure.name, source=figure)
        return model._made_of(Assembled(figure, tuple(range(len(figure.limbs)))))

    @property
    def figure(self) -> Figure:
        """The figure this model is, assembled once, in the program's left-handed space; its root never changes."""
        return self._assembled.figure

    @property
    def main(self) -> int:
        """Index of the main link among the figure's limbs."""
        return self._assembled.limbs[self.main_node]

    @property
    def anchor(self) -> tuple[float, float, float]:
        """Where the main link's own origin lies in its limb's coordinates, left-handed."""
        return origin_in_limb(self.nodes[self.main_node])

    def held(self, angles: Floats, translations: Floats) -> tuple[Floats, Floats]:
        """Return angles (..., n, 3) and translations (..., 3) with which the main link stays still.

        Row 0 and the translations that are given place the main link's own origin, as they place the root of a figure
        whose main link is its root; see :func:`layfigure.models.rerooting.held`.
        """
        return held(self.figure, angles, translations, self.main, self.anchor)

    def standing(self, angles: Floats, translations: Floats) -> tuple[Floats, Floats]:
        """Return angles (..., n, 3) and translations (..., 3) of motions as the model stands in them.

        A main link other than the root stays where it is put, wherever motions turn and carry the root.
        """
        if self.main == 0:
            return angles, translations
        angles = np.array(angles)
        angles[..., 0, :] = 0.0
        return self.held(angles, np.zeros_like(translations))

    @property
    def links(self) -> tuple[Link, ...]:
        """The links as they were joined, parents first."""
        return tuple(node.link for node in self.nodes)

    @property
    def main_link(self) -> str:
        """The name of the main link."""
        return self.nodes[self.main_node].link.name

    @property
    def joint_ids(self) -> tuple[str, ...]:
        """The joints' identifiers as motions spell them, in the order of the links they hold."""
        return tuple(str(node.joint.id) for node in self.nodes[1:])

    @property
    def warnings(self) -> tuple[str, ...]:
        """Sentences about what is allowed but seldom meant: joints of one identifier, a main link that several fit."""
        counts = Counter(self.joint_ids)
        twice = [name for name, count in counts.items() if count > 1]
        shared = f"several joints of {self.title} are called {', '.join(twice)} and will move alike" if twice else ""
        return tuple(sentence for sentence in (shared, self.note) if sentence)

    @property
    def title(self) -> str:
        """What sentences call the model."""
        return self.name or self.nodes[0].link.name

    def named(self, name: str) -> Model:
        """Return the model under another name; its figure, if it is assembled already, is the same."""
        return replace(self, name=name)._made_of(self.__dict__.get("_assembled"))

    def copy(self) -> Model:
        """Return the same model of the same figure as another object, so that it can be joined to this one."""
        return replace(self)._made_of(self.__dict__.get("_assembled"))

    def link(self, name: str) -> LinkOf:
        """Return a link, by name, to join something to; where several fit, the first.

        Raises:
            LayfigureError: no link is called so.
        """
        return LinkOf(self, self._fitting(name)[0])

    def with_main(self, *, link: str | None = None, joint: int | str | Fraction | None = None) -> Model:
        """Return the model held by another link: by name, by the joint whose secondary link it is, or the original.

        Only what stays still changes; the figure is the same (FIGURE m MAIN LINK, MAIN JOINT). Where a name fits
        several links the first is taken and :attr:`warnings` says so.

        Raises:
            LayfigureError: both are given, or neither link nor joint is called so.
        """
        if link is not None and joint is not None:
            raise LayfigureError("the main link is named by a link or by a joint, not by both")
        main, note = 0, ""
        if link is not None:
            main, note = self._main_by_link(link)
        if joint is not None:
            main = self._holding(JointId.of(joint))
        return replace(self, main_node=main, note=note)._made_of(self._assembled)

    def trans_joints(self, by: int | Fraction) -> Model:
        """Return a copy whose joints have other identifiers: ``by`` added to each number (TRANS JOINTS BY).

        Raises:
            LayfigureError: ``by`` is no whole number.
        """
        step = exact_number(by, "TRANS JOINTS")
        if step.denominator != 1:
            raise LayfigureError(f"TRANS JOINTS adds a whole number, not {by}")
        first, *rest = self.nodes
        moved = (replace(node, joint=replace(node.joint, id=node.joint.id.translated(int(step)))) for node in rest)
        return replace(self, nodes=(first, *moved), source=None)

    def scale(self, size: Number) -> Model:
        """Return a copy with all lengths multiplied; a negative factor makes the mirror image in x (SCALE MODEL).

        A mirrored joint turns in mirrored senses, so that equal angles look mirrored.

        Raises:
            LayfigureError: the factor is 0.
        """
        factor = exact_number(size, "SCALE MODEL")
        if not factor:
            raise LayfigureError("SCALE MODEL by 0 leaves nothing of a model; choose another factor")
        nodes = (replace(node, size=product(node.size, factor), joint=node.joint.scaled(factor)) for node in self.nodes)
        return replace(self, nodes=tuple(nodes))

    def scale_extremes(self, extremes: Number) -> Model:
        """Return a copy with all limits multiplied; a negative factor mirrors the ranges (SCALE EXTREMES)."""
        factor = exact_number(extremes, "SCALE EXTREMES")
        nodes = (replace(node, joint=node.joint.stretched(factor)) for node in self.nodes)
        return replace(self, nodes=tuple(nodes))

    def coloured(self, colour: str) -> Model:
        """Return a copy with every volume of every link in one colour: a palette's word or ``#rrggbb``.

        Raises:
            LayfigureError: there is no such colour.
        """
        painted = (replace(node.link, shape=node.link.shape.coloured(colour)) for node in self.nodes)
        nodes = tuple(replace(node, link=link) for node, link in zip(self.nodes, painted, strict=True))
        return replace(self, nodes=nodes, source=None)

    @cached_property
    def _assembled(self) -> Assembled:
        return assembled(self.title, self.nodes)

    def _made_of(self, known: Assembled | None) -> Model:
        """Return this model, just made and shown to nobody, with what it would be assembled to, if that is known."""
        if known is not None:
            self.__dict__["_assembled"] = known  # where cached_property looks
        return self

    def _fitting(self, name: str) -> list[int]:
        wanted = name.casefold()
        found = [i for i, node in enumerate(self.nodes) if node.link.name.casefold() == wanted]
        if not found:
            limbs, names = self._assembled.limbs, self.figure.names
            found = [i for i, limb in enumerate(limbs) if names[limb].casefold() == wanted]
        if not found:
            hint = did_you_mean(name, [link.name for link in self.links])
            raise LayfigureError(f'{self.title} has no link "{name}"{hint}')
        return found

    def _main_by_link(self, name: str) -> tuple[int, str]:
        first, *others = self._fitting(name)
        if not others:
            return first, ""
        ids = ", ".join(str(self.nodes[i].joint.id) for i in others)
        taken = f"the first was taken; MAIN JOINT {ids} names another"
        return first, f'{len(others) + 1} links of {self.title} are called "{name}": {taken}'

    def _holding(self, wanted: JointId) -> int:
        """Return the secondary link of a joint: the one it holds, or where the joint is inverted the one holding it."""
        for index, node in enumerate(self.nodes[1:], start=1):
            if node.joint.id == wanted:
                return node.parent if node.joint.inverted else index
        hint = did_you_mean(str(wanted), self.joint_ids)
        known = f"; it has {', '.join(self.joint_ids[:12])}" if self.joint_ids and not hint else hint
        raise LayfigureError(f"{self.title} has no joint {wanted}{known}")
