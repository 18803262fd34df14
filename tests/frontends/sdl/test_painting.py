from dataclasses import replace

import numpy as np
import pygame
import pytest

from layfigure.drawing.render_list import Rectangle
from layfigure.session import dialogs
from layfigure.session.frame import (
    Button,
    ChoiceBar,
    HelpOverlay,
    JointBall,
    JointCircle,
    Label,
    Outline,
    PaletteOverlay,
    QuestionOverlay,
    Sign,
    Size,
    SliderBar,
    WorldLine,
)
from layfigure_frontends.sdl import help_page, shapes
from layfigure_frontends.sdl.canvas import Canvas
from layfigure_frontends.sdl.fonts import Face, fitted, text_width, wrapped
from layfigure_frontends.sdl.help_page import HelpLine, columns, help_lines
from layfigure_frontends.sdl.outlines import paint_outline
from layfigure_frontends.sdl.painter import Painting, paint
from layfigure_frontends.sdl.signs import paint_signs
from layfigure_frontends.sdl.widgets import paint_widget
from layfigure_frontends.theme import Theme, load_theme

BOX = Rectangle(60, 50, 150, 44)
LONG = "Something that is much too long for where it stands"
WIDGETS = [
    *(Label(BOX, LONG, role, align) for role in ("title", "text", "small", "status", "warning", "number")
      for align in ("left", "centre", "right")),
    Button(BOX, LONG, "x", "Ctrl-Shift-Z"),
    Button(BOX, LONG, "x", "M", active=True),
    Button(BOX, LONG, "x", enabled=False),
    *(SliderBar(BOX, LONG, "x", value, 0, 100, 5, "-  +", " %") for value in (-10, 0, 55, 100, 300)),
    SliderBar(BOX, "Empty", "x", 3, 3, 3, 1),
    ChoiceBar(BOX, LONG, "x", (("a", LONG), ("b", LONG), ("c", "C")), "b", "T"),
    JointBall(BOX, LONG, "x", (30.0, -150.0, 7.0), (-180.0, -180.0), (180.0, 180.0)),
    JointBall(BOX, LONG, "x", (0.0, 180.0, 0.0), (0.0, 180.0), (0.0, 180.0)),
    JointCircle(BOX, LONG, "x", (-179.0, 0.0, 0.0), 0, -180.0, 180.0),
    JointCircle(BOX, LONG, "x", (0.0, 0.0, 40.0), 2, 40.0, 40.0),
    JointCircle(BOX, LONG, "x", (0.0, 0.0, 0.0), -1),
    JointCircle(BOX, LONG, "x", (0.0, 0.0, 400.0), 2, -720.0, 720.0, -1),
]  # fmt: skip


def canvas_of(size=(300, 160), scale=1.0, theme="dark", pointer=None):
    surface = pygame.Surface(size, 0, 32)
    return Canvas(surface, load_theme(theme), scale, pointer)


def changed(surface, before):
    """The smallest box (left, top, right, bottom) of pixels that differ, or None."""
    ys, xs = np.nonzero(before != pygame.surfarray.array2d(surface).T)
    return (int(xs.min()), int(ys.min()), int(xs.max()) + 1, int(ys.max()) + 1) if len(xs) else None


def pixels(surface):
    return pygame.surfarray.array2d(surface).T


@pytest.mark.parametrize("widget", WIDGETS, ids=lambda widget: f"{type(widget).__name__}-{getattr(widget, 'role', '')}")
@pytest.mark.parametrize("scale", [1.0, 1.5])
def test_every_widget_stays_inside_its_rectangle(widget, scale):
    box = Rectangle(*(round(value * scale) for value in widget.rectangle))
    widget = replace(widget, rectangle=box)
    canvas = canvas_of((500, 200), scale, pointer=(100, 70))
    before = pixels(canvas.surface)
    paint_widget(canvas, widget)
    left, top, right, bottom = changed(canvas.surface, before)
    assert box.x <= left
    assert right <= box.x + box.width
    assert top >= box.y
    assert bottom <= box.y + box.height


@pytest.mark.parametrize("widget", WIDGETS, ids=lambda widget: f"{type(widget).__name__}-{getattr(widget, 'role', '')}")
def test_widgets_that_are_given_too_little_room_do_not_spill(widget):
    small = Rectangle(60, 50, 31, 9)
    canvas = canvas_of()
    before = pixels(canvas.surface)
    paint_widget(canvas, replace(widget, rectangle=small))
    canvas.surface.fill(0, small)
    assert (pixels(canvas.surface) == before).all()


def test_a_slider_shows_its_value_by_how_far_the_accent_reaches():
    def reach(value):
        canvas = canvas_of()
        paint_widget(canvas, SliderBar(BOX, "", "x", value, 0, 100, 1))
        accent = canvas.surface.map_rgb(canvas.theme.accent)
        return int(np.nonzero(pixels(canvas.surface) == accent)[1].max())

    assert reach(20) < reach(50) < reach(90)
    assert abs(reach(50) - (BOX.x + BOX.width // 2)) <= 8


def test_a_circles_hand_goes_the_way_of_its_sense():
    def hand(sense):
        canvas = canvas_of((300, 200))
        box = Rectangle(60, 20, 150, 150)
        paint_widget(canvas, JointCircle(box, "", "x", (0.0, 0.0, 60.0), 2, -90.0, 720.0, sense))
        accent = canvas.surface.map_rgb(canvas.theme.accent)
        return float(np.nonzero(pixels(canvas.surface) == accent)[1].mean()) - (box.x + box.width / 2)

    assert hand(1) > 20 and hand(-1) < -20


def test_the_chosen_option_is_filled_with_the_accent():
    canvas = canvas_of()
    paint_widget(canvas, ChoiceBar(BOX, "", "x", (("a", "A"), ("b", "B")), "b"))
    accent = canvas.surface.map_rgb(canvas.theme.accent)
    columns_ = np.nonzero(pixels(canvas.surface) == accent)[1]
    assert columns_.min() >= BOX.x + BOX.width // 2


def test_a_button_answers_to_the_pointer_unless_it_is_switched_off():
    def picture(button, pointer):
        canvas = canvas_of(pointer=pointer)
        paint_widget(canvas, button)
        return pixels(canvas.surface)

    live, dead = Button(BOX, "Go", "x"), Button(BOX, "Go", "x", enabled=False)
    assert (picture(live, (70, 60)) != picture(live, None)).any()
    assert (picture(dead, (70, 60)) == picture(dead, None)).all()


@pytest.mark.parametrize("role", ["chosen", "hover", "band", "focus", "pane"])
def test_every_outline_shows_and_leaves_the_middle_visible(role):
    canvas = canvas_of()
    canvas.surface.fill((90, 90, 90))
    before = pixels(canvas.surface)
    paint_outline(canvas, Outline(BOX, role))
    left, top, right, bottom = changed(canvas.surface, before)
    assert (left, top) <= (BOX.x, BOX.y)
    assert (right, bottom) >= (BOX.x + BOX.width, BOX.y + BOX.height)
    assert canvas.surface.get_at((BOX.x + 70, BOX.y + 20))[:3] != canvas.theme.accent


def test_an_empty_rubber_band_does_no_harm():
    canvas = canvas_of()
    paint_outline(canvas, Outline(Rectangle(20, 20, 0, 0), "band"))
    paint_outline(canvas, Outline(Rectangle(20, 20, 1, 3), "band"))


@pytest.mark.parametrize(
    "size", [Size(1280, 800), Size(1920, 1080), Size(1728, 972, 2.0), Size(640, 400), Size(320, 240)]
)
@pytest.mark.parametrize("theme", ["dark", "light", "high-contrast"])
def test_whole_frames_paint_at_every_size_and_in_every_theme(session, frame_of, size, theme):
    surface = pygame.Surface((size.width, size.height), 0, 32)
    paint(surface, frame_of(size, theme=theme), Painting(session.draw, (400, 300)))
    assert len(np.unique(pixels(surface))) > 20


def test_the_views_are_drawn_straight_into_the_surface(session, frame_of):
    size = Size(1280, 800)
    surface = pygame.Surface((1280, 800), 0, 32)
    frame = frame_of(size, widgets=(), outlines=())
    paint(surface, frame, Painting(session.draw))
    box = frame.panes[0].rectangle
    assert surface.get_at((box.x + box.width // 2, box.y + box.height // 2))[:3] == (0x23, 0x27, 0x2E)
    assert not surface.get_locked()


def test_a_surface_with_its_colours_in_another_order_shows_the_same(session, frame_of):
    size = Size(640, 400)
    usual = pygame.Surface((640, 400), 0, 32)
    other = pygame.Surface((640, 400), 0, 32, (0xFF, 0xFF00, 0xFF0000, 0))
    for surface in (usual, other):
        paint(surface, frame_of(size), Painting(session.draw))
    assert pygame.image.tobytes(usual, "RGB") == pygame.image.tobytes(other, "RGB")


def test_lines_of_plugins_are_drawn(session, frame_of):
    size = Size(640, 400)
    surface = pygame.Surface((640, 400), 0, 32)
    lines = (WorldLine(50, 50, 350, 50, Rectangle(0, 0, 300, 300), (255, 0, 0)),)
    paint(surface, frame_of(size, widgets=(), panes=(), outlines=(), lines=lines), Painting(session.draw))
    assert surface.get_at((150, 50))[0] > 200
    assert surface.get_at((330, 50)) == surface.get_at((330, 150)), "a line ends where its view ends"


@pytest.mark.parametrize("scale", [1.0, 2.0])
def test_every_role_has_a_sign_of_its_own_shape_and_stays_in_its_view(session, frame_of, scale):
    shapes_seen = set()
    for role in ("goal", "pin", "orientation", "band", "hold", "joint", "guide"):
        surface = pygame.Surface((200, 200), 0, 32)
        signs = (Sign(60, 60, role, Rectangle(0, 0, 100, 100)), Sign(150, 150, role, Rectangle(0, 0, 100, 100)))
        paint_signs(Canvas(surface, load_theme("dark"), scale), frame_of(Size(200, 200), signs=signs))
        left, top, right, bottom = changed(surface, np.zeros((200, 200)))
        assert 40 <= left < 60 < right <= 80 and 40 <= top < 60 < bottom <= 80
        shapes_seen.add((pixels(surface) != 0).tobytes())
    assert len(shapes_seen) == 7


def test_a_joint_ball_shows_where_the_joint_stands_and_what_is_allowed():
    canvas = canvas_of((200, 200))
    box = Rectangle(20, 20, 160, 160)
    paint_widget(canvas, JointBall(box, "Ball", "set x", (90.0, 0.0, 0.0), (0.0, -60.0), (120.0, 60.0)))
    up = round(100 - 64 * np.sin(np.radians(45)))
    assert canvas.surface.get_at((100, up))[:3] == canvas.theme.accent
    assert canvas.surface.get_at((110, 90))[:3] == canvas.theme.accent_quiet
    assert canvas.surface.get_at((110, 130))[:3] == canvas.theme.raised


def test_a_long_status_is_cut_and_the_hints_that_do_not_fit_are_left_out(session, frame_of):
    size = Size(640, 400)
    surface = pygame.Surface((640, 400), 0, 32)
    hints = tuple((f"F{number}", "does something") for number in range(1, 13))
    paint(surface, frame_of(size, status=LONG * 4, hints=hints), Painting(session.draw))
    panel = surface.map_rgb(load_theme("dark").panel)
    assert (pixels(surface)[372:398, 636:] == panel).all()


@pytest.mark.parametrize("size", [Size(1280, 800), Size(1728, 972, 2.0), Size(640, 400)])
@pytest.mark.parametrize("chosen", [0, 14])
def test_palette_rows_are_visible_and_the_chosen_one_stands_out(session, frame_of, size, chosen):
    rows = tuple((f"command-{number}", f"Command {number}", "Ctrl-Z") for number in range(15))
    surface = pygame.Surface((size.width, size.height), 0, 32)
    overlay = PaletteOverlay(":", "com", rows, chosen)
    paint(surface, frame_of(size, overlay=overlay), Painting(session.draw))
    place = dialogs.palette(size, len(rows), chosen)
    quiet = surface.map_rgb(load_theme("dark").accent_quiet)
    shown = pixels(surface)
    for index, row in enumerate(place.rows, start=place.first):
        cut = shown[row.y : row.y + row.height, row.x : row.x + row.width]
        assert len(np.unique(cut)) > 20
        assert (cut == quiet).any() == (index == chosen)
        assert row.y + row.height < size.height


def test_an_empty_palette_says_that_nothing_matches(session, frame_of):
    surface = pygame.Surface((1280, 800), 0, 32)
    paint(surface, frame_of(Size(1280, 800), overlay=PaletteOverlay(":", LONG * 5, (), 0)), Painting(session.draw))
    box = dialogs.palette(Size(1280, 800), 0, 0).box
    assert len(np.unique(pixels(surface)[box.y + 60 : box.y + box.height - 4, box.x + 8 : box.x + 300])) > 10


def test_question_answers_are_painted_where_clicks_are_heard(session, frame_of):
    size = Size(1280, 800)
    surface = pygame.Surface((1280, 800), 0, 32)
    overlay = QuestionOverlay(LONG * 6, (("Restore", "Y", "restore"), ("Later", "N", "cancel")))
    paint(surface, frame_of(size, overlay=overlay), Painting(session.draw))
    first, second = dialogs.question(size, 2).answers
    theme = load_theme("dark")
    assert surface.get_at((first.x + 8, first.y + 8))[:3] == theme.accent
    assert surface.get_at((second.x + 8, second.y + 8))[:3] == theme.raised


SECTIONS = tuple((f"Section {n}", tuple((f"Ctrl-{k}", f"Does {n}{k}") for k in "ABCDEFGH")) for n in range(6))


@pytest.mark.parametrize("size", [Size(1280, 800), Size(1920, 1080), Size(1728, 972, 2.0), Size(640, 400)])
@pytest.mark.parametrize("scroll", [0, 10, 1000])
def test_the_help_page_keeps_inside_the_window_above_the_status_bar(session, frame_of, size, scroll):
    surface = pygame.Surface((size.width, size.height), 0, 32)
    paint(surface, frame_of(size, overlay=HelpOverlay("Keys", SECTIONS, scroll)), Painting(session.draw))
    assert (pixels(surface) == surface.map_rgb(load_theme("dark").accent)).any()


def test_help_columns_keep_every_line_and_never_end_with_a_title():
    lines = help_lines(HelpOverlay("Keys", SECTIONS))
    assert sum(1 for line in lines if line.keys) == 48
    for length in range(5, 30):
        parts = columns(lines, 100, length)
        kept = [line for part in parts for line in part if line != HelpLine()]
        assert kept == [line for line in lines if line != HelpLine()]
        assert all(part[-1].keys for part in parts)
        assert all(len(part) <= length for part in parts)


@pytest.mark.parametrize("height", range(300, 1000, 50))
def test_more_is_promised_exactly_where_lines_are_hidden(session, frame_of, monkeypatch, height):
    shown, promised = [], []
    monkeypatch.setattr(help_page, "_paint_column", lambda canvas, part, box, caps: shown.extend(part))
    monkeypatch.setattr(help_page, "_paint_more", lambda canvas, box: promised.append(True))
    overlay = HelpOverlay("Keys", SECTIONS)
    paint(pygame.Surface((1280, height), 0, 32), frame_of(Size(1280, height), overlay=overlay), Painting(session.draw))
    hidden = {line.text for line in help_lines(overlay)} - {line.text for line in shown} - {""}
    assert bool(promised) == bool(hidden)


@pytest.mark.parametrize("keys", [True, False])
def test_amounts_are_written_and_not_drawn_as_keys(session, frame_of, keys):
    surface = pygame.Surface((1280, 800), 0, 32)
    overlay = HelpOverlay("Compared", SECTIONS, keys=keys)
    paint(surface, frame_of(Size(1280, 800), overlay=overlay), Painting(session.draw))
    cap = surface.map_rgb(load_theme("dark").key)
    assert bool((pixels(surface)[200:1080, 60:700] == cap).any()) == keys


def test_a_text_is_cut_only_where_it_must_be():
    assert fitted(Face.REGULAR, 13, "Short", 200) == "Short"
    cut = fitted(Face.REGULAR, 13, LONG, 100)
    assert cut.endswith("…")
    assert text_width(Face.REGULAR, 13, cut) <= 100
    assert fitted(Face.REGULAR, 13, LONG, 3) == ""


def test_a_sentence_is_broken_into_lines_that_fit():
    lines = wrapped(Face.REGULAR, 13, LONG, 120)
    assert " ".join(lines) == LONG
    assert all(text_width(Face.REGULAR, 13, line) <= 120 for line in lines)


def test_round_boxes_are_smooth_at_their_corners():
    surface = pygame.Surface((60, 60), 0, 32)
    shapes.rounded(surface, Rectangle(10, 10, 40, 40), 12, (255, 255, 255))
    greys = {surface.get_at((x, y))[0] for x in range(10, 22) for y in range(10, 22)}
    assert len(greys) >= 8
    assert surface.get_at((10, 10))[0] == 0
    assert surface.get_at((30, 10))[0] == 255


def _luminance(colour):
    linear = [c / 255 / 12.92 if c <= 10 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in colour]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def _contrast(one, other):
    high, low = sorted([_luminance(one), _luminance(other)], reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize(("name", "least"), [("dark", 4.5), ("light", 4.5), ("high-contrast", 7.0)])
def test_text_can_be_read_in_every_theme(name, least):
    theme: Theme = load_theme(name)
    for ground in (theme.window, theme.panel, theme.raised):
        assert _contrast(theme.text, ground) >= least
        assert _contrast(theme.muted, ground) >= least
    assert _contrast(theme.on_accent, theme.accent) >= least
    assert _contrast(theme.key_text, theme.key) >= least
    assert _contrast(theme.warning, theme.panel) >= least
    assert _contrast(theme.text, theme.accent_quiet) >= least
