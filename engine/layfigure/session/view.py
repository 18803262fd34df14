"""What is looked at and pointed at: it steers the picture, never the document, and undo leaves it alone."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from layfigure.drawing.camera import Camera
from layfigure.drawing.render_list import RECOMMENDED, Look

if TYPE_CHECKING:
    from layfigure.session.document import Document


@dataclass(frozen=True)
class ViewState:
    """The camera of the main views, the selection, and what the pointer is over.

    ``candidate`` is the 0-based candidate keys act on; ``selected`` the selected limbs, the last being the one that
    keys walk from; ``hover`` is (candidate, limb) under the pointer, candidate -1 being the working pose; ``overlays``
    are the plug-ins' overlays that are shown. ``anchor`` is the world point that the cameras stay with, so that a root
    that is carried is seen to move; ``skeleton`` says whether the skeleton is shown in the candidates' place;
    ``shown`` is the view of every pose (``main``, ``right``, ``top``) where the surface has no room for three.

    ``passing`` is what stands in the document's place while a motion plays or its time line is dragged along; nothing
    of it is recorded. It plays if ``playing``, ``speed`` times as fast as it should, from its end on from its beginning
    if ``loop``. ``onion`` says which moments are shown as ghosts: those of ``keys``, those so many frames away, or
    (empty) none.
    """

    camera: Camera = field(default_factory=Camera)
    candidate: int = 0
    selected: tuple[int, ...] = ()
    hover: tuple[int, int] | None = None
    renderer: str = ""
    look: Look = RECOMMENDED
    theme: str = "dark"
    overlays: frozenset[str] = frozenset()
    anchor: tuple[float, float, float] = (0.0, 0.0, 0.0)
    skeleton: bool = False
    shown: str = "main"
    passing: Document | None = None
    playing: bool = False
    loop: bool = True
    speed: float = 1.0
    onion: str = ""
