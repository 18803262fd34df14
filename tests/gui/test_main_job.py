"""The main job in a real window: the keys, clicks and drags of a person, and what comes of them."""

import numpy as np
import pytest
from PIL import Image

pytestmark = pytest.mark.gui

SCREENS = [(1280, 800, 1.0), (1920, 1080, 1.0), (1920, 1080, 2.0)]
NAMES = {"indirect": True, "ids": lambda screen: "x".join(f"{number:g}" for number in screen)}


def colours(picture: np.ndarray) -> int:
    """How many different colours a picture has."""
    return len(np.unique(picture.reshape(-1, 3), axis=0))


def share_changed(before: np.ndarray, after: np.ndarray) -> float:
    """The share of pixels that differ."""
    return float((before != after).any(axis=-1).mean())


@pytest.mark.parametrize("display", SCREENS, **NAMES)
def test_the_window_opens_on_nine_different_figures_and_one_to_work_on(desk, mirror):
    desk.start("--no-restore")
    picture = desk.picture("start")
    places = mirror()
    for candidate in range(-1, 9):
        for view in ("main", "right", "top"):
            assert colours(picture[places.pane(candidate, view)]) > 20, (candidate, view)
    first = picture[places.pane(0)]
    others = [picture[places.pane(candidate)] for candidate in range(1, 9)]
    inner = [
        share_changed(first[40:-4, 4:-4], other[40 : first.shape[0] - 4, 4 : first.shape[1] - 4]) for other in others
    ]
    assert min(inner) > 0.005


@pytest.mark.parametrize("display", SCREENS[:2], **NAMES)
def test_a_person_assembles_mutates_pages_undoes_turns_asks_and_saves(desk, mirror):
    desk.start("--no-restore")
    places = mirror()
    page, seed = places.pane(4), places.pane(-1)

    standing = desk.picture()
    desk.keys("m")
    assert desk.log()[-1].startswith("mutate")
    mutated = desk.picture("mutated")
    assert share_changed(standing, mutated) > 0.01

    x, y = places.limb_point(3, "leftforearm")
    desk.click(x, y)
    assert desk.log()[-1].split() == ["pick", "4", "leftforearm"]
    picked = desk.picture("picked")
    assert share_changed(mutated[page], picked[page]) > 0.001, "a pick reaches all candidates"

    rows, columns = places.pane(6)
    before = desk.log()
    upper = rows.start + (rows.stop - rows.start) * 11 // 20
    desk.drag((columns.start + 3, upper), (columns.stop - 3, rows.stop - 3))
    assert len(desk.log()) == len(before) + 1
    assert desk.log()[-1].startswith("pick")
    boxed = desk.picture("rectangle")
    assert share_changed(picked[seed], boxed[seed]) > 0.005

    desk.keys("n")
    second = desk.picture("second-page")
    assert share_changed(boxed[page], second[page]) > 0.001
    desk.keys("f")
    assert share_changed(boxed[page], desk.picture()[page]) == 0

    desk.keys("ctrl+z")
    while share_changed(picked[seed], desk.picture()[seed]) > 0 and desk.log().count("undo") < 4:
        desk.keys("ctrl+z")
    assert share_changed(picked[seed], desk.picture()[seed]) == 0

    straight = desk.picture()
    rows, columns = places.pane(-1)
    corner = (columns.start + 12, rows.stop - 12)
    desk.drag(corner, (corner[0] + 80, corner[1] - 60), modifier="ctrl")
    turned = desk.picture("turned")
    assert share_changed(straight[page], turned[page]) > 0.01
    assert share_changed(straight[places.pane(0, "right")], turned[places.pane(0, "right")]) == 0
    desk.keys("Home")
    assert share_changed(straight[page], desk.picture()[page]) == 0

    desk.keys("question")
    helped = desk.picture("help")
    assert share_changed(straight, helped) > 0.5
    desk.keys("Escape")
    assert share_changed(straight[page], desk.picture()[page]) == 0

    desk.keys("colon")
    desk.type("flip")
    desk.picture("palette")
    desk.keys("Return")
    assert desk.log()[-1].startswith("flip")

    desk.keys("ctrl+s")
    assert (desk.folder / "humanoid-1.pose").read_text().count("\n") > 10
    with Image.open(desk.folder / "humanoid-1.png") as sheet:
        assert colours(np.asarray(sheet.convert("RGB"))) > 50
    desk.keys("F12")
    desk.file("window-*.png")
    assert desk.close() == 0
