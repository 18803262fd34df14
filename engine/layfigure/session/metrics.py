"""How large the parts of a surface are: in pixels of a window, or in a terminal's half-block pixels.

A character cell is one half-block pixel wide and two high, so a line of text is two pixels high there; figures keep
their shape, because half-block pixels are about square.
"""

from __future__ import annotations

from dataclasses import dataclass

from layfigure.session.frame import Size


@dataclass(frozen=True)
class Metrics:
    """Sizes in layout units. ``*_x`` runs across, ``*_y`` down; what is named alone is a height unless said otherwise.

    ``grain`` is what heights and tops are multiples of; ``full`` (width, height) is the least surface that shows three
    views of every candidate, ``least`` the least that shows anything. The column at the right takes ``column_share`` of
    the width, between ``column_least`` and ``column_most``; of its height the working pose may take ``poser_share``
    however little the ``panel`` then has, at a shape of width / ``poser_shape``; it makes room for a time line where
    the panel would have less than ``panel_whole``, all its rows. ``views_least`` is the width at which a pose
    is shown from three sides. ``tolerance`` and ``slack`` are distances of the pointer: beside a limb, and between a
    click and a drag.
    """

    grain: int = 1
    margin_x: int = 12
    margin_y: int = 12
    gap_x: int = 8
    gap_y: int = 8
    status: int = 34
    panel: int = 276
    panel_whole: int = 490
    column_share: float = 0.235
    column_least: int = 290
    column_most: int = 460
    poser_share: float = 0.25
    poser_shape: float = 1.4
    full: tuple[int, int] = (0, 0)
    least: tuple[int, int] = (0, 0)
    views_least: int = 0
    views_line: int = 2
    card_gap: int = 8
    tolerance: float = 5.0
    slack: float = 4.0
    # headings and labels over the views
    heading: int = 26
    title: int = 20
    number_x: int = 26
    number_y: int = 26
    badge_left: int = 30
    badge_right: int = 6
    name_x: int = 6
    name_y: int = 4
    name: int = 16
    name_least: int = 60
    names_least: int = 200
    # the panel
    limb: int = 18
    limb_gap: int = 2
    limb_after: int = 4
    caption: int = 22
    slider: int = 44
    choice: int = 48
    dial: int = 150  # 0: a slider for each degree of freedom stands for the dials
    button: int = 32
    toggle: int = 28
    button_least: int = 0  # a button's least width; fewer stand side by side where it would be less
    across: int = 3
    toggles_across: int = 4
    overflow: bool = True  # whether what has no room is there all the same, hidden by the status bar
    # the time line: its strip, lower on a surface lower than ``low``, and from left to right a button and a text
    time_line: int = 44
    time_line_low: int = 26
    low: int = 560
    time_button: int = 92
    time_text: int = 108
    time_text_low: int = 64
    time_number: int = 56  # the least room for a number on it, across
    # dialogs
    padding_x: int = 24
    padding_y: int = 24
    edge_x: int = 8
    edge_y: int = 8
    row: int = 36
    palette_width: int = 620
    palette_line: int = 56
    question_width: int = 500
    question_text: int = 72  # three lines
    answer: int = 36


PIXELS = Metrics()
CELLS = Metrics(
    grain=2,
    margin_x=1,
    margin_y=0,
    gap_x=1,
    gap_y=0,
    status=2,
    panel=40,
    panel_whole=0,
    column_share=0.25,
    column_least=24,
    column_most=60,
    poser_share=0.5,
    poser_shape=1.0,
    full=(150, 92),
    least=(40, 24),
    views_least=34,
    views_line=1,
    card_gap=2,
    tolerance=1.2,
    slack=0.9,
    heading=2,
    title=2,
    number_x=3,
    number_y=2,
    badge_left=4,
    badge_right=0,
    name_x=0,
    name_y=0,
    name=2,
    name_least=9,
    names_least=34,
    limb=2,
    limb_gap=0,
    limb_after=0,
    caption=2,
    slider=2,
    choice=4,
    dial=0,
    button=2,
    toggle=2,
    button_least=13,
    across=3,
    toggles_across=3,
    overflow=False,
    time_line=2,
    time_line_low=2,
    low=0,
    time_button=13,
    time_text=11,
    time_text_low=11,
    time_number=8,
    padding_x=3,
    padding_y=2,
    edge_x=2,
    edge_y=2,
    row=2,
    palette_width=76,
    palette_line=2,
    question_width=60,
    question_text=6,
    answer=2,
)


def metrics(size: Size) -> Metrics:
    """Return what sizes the parts of a surface have."""
    return CELLS if size.cells else PIXELS


def too_small(size: Size) -> bool:
    """Whether a surface is too small to pose on."""
    least = metrics(size).least
    return size.width < least[0] or size.height < least[1]
