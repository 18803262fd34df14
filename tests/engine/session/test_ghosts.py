"""Onion skins: which moments are shown, where, and how they are told apart from the figure and from each other."""

from dataclasses import replace

import numpy as np
import pytest

from layfigure.drawing.joint_kinds import coded_as_still, kinds_shown
from layfigure.drawing.render_list import PLAIN, new_target
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Command, Interpolation
from layfigure.session.frame import Size
from layfigure.session.ghosts import Ghosts, ghost_lists, ghosts_of
from layfigure.session.moments import known_curves

SIZE = Size(1280, 800)


@pytest.fixture
def moving(session):
    """A session with keys at frames 0, 10, 20, 30 and 40, the playhead at 20."""
    for frame, angle in enumerate((0, 40, 80, 20, 60)):
        for line in (f"set rightupperarm {angle} 0 0", f"set leftthigh {angle} 0 0", f"key {10 * frame} all"):
            session.execute(line)
    session.execute("frame-at 20")
    session.playback.ticking = True
    return session


def ghosts(session):
    return ghosts_of(session.document, session.view.onion, known_curves(session.host))


def drawn(session):
    target = new_target(SIZE.width, SIZE.height)
    frame = session.frame(SIZE)
    session.draw(frame, target)
    return frame, target.pixels


def poses_at(session, *frames):
    found = []
    here = session.document
    for frame in frames:
        session.execute(f"frame-at {frame}")
        found.append(session.document.pose)
    session.restore(here)
    return found


def test_ghosts_of_keys_are_up_to_two_before_and_two_after(moving):
    moving.execute("onion keys")
    before, after = ghosts(moving)
    assert [*before, *after] == poses_at(moving, 0, 10, 30, 40)
    moving.execute("frame-at 40")
    before, after = ghosts(moving)
    assert len(before) == 2 and not after


def test_ghosts_of_frames_are_so_many_and_twice_as_many_away(moving):
    moving.execute("onion 9")
    before, after = ghosts(moving)
    assert [*before, *after] == poses_at(moving, 2, 11, 29, 38)
    moving.execute("frame-at 10")
    assert [len(side) for side in ghosts(moving)] == [1, 2]


def test_the_same_key_shows_and_hides_them(moving):
    moving.execute("onion")
    assert moving.view.onion == "keys"
    moving.execute("onion")
    assert moving.view.onion == "" and ghosts(moving) == ((), ())


def test_they_are_drawn_in_the_views_of_the_working_pose_and_nowhere_else(moving):
    frame, without = drawn(moving)
    moving.execute("onion keys")
    _, haunted = drawn(moving)
    differs = without != haunted
    for pane in frame.panes:
        x, y, width, height = pane.rectangle
        assert differs[y : y + height, x : x + width].any() == (pane.candidate == -1), pane


def test_those_before_are_cold_and_those_after_are_warm_and_have_joints(moving):
    moving.execute("onion keys")
    (listed,) = (moving.stage.compose(SIZE).drawn((1.0, 1.0), page=False, kinds=False),)
    colours = [tuple(colour) for colour in listed[0].palette.tolist()]
    cold, warm = moving.theme.before, moving.theme.after
    assert cold[2] > cold[0] and warm[0] > warm[2]
    radii = {
        colour: set(np.round(listed[0].radii[listed[0].colours == colours.index(colour)], 3).tolist())
        for colour in (cold, warm)
    }
    assert max(radii[warm]) > 1.5 * max(radii[cold]) > 0


def test_a_click_goes_through_them_to_the_figure(moving):
    frame, _ = drawn(moving)
    pane = next(pane for pane in frame.panes if (pane.candidate, pane.view) == (-1, "main"))
    x, y, width, height = pane.rectangle
    spots = [(x + i, y + j) for j in range(0, height, 9) for i in range(0, width, 9)]
    plain = [moving.stage.limb_at(pane, *spot) for spot in spots]
    moving.execute("onion keys")
    drawn(moving)
    assert [moving.stage.limb_at(pane, *spot) for spot in spots] == plain


def test_while_it_plays_there_are_none(moving):
    moving.execute("onion keys")
    moving.execute("play")
    moving.playback.tick(0.0)
    picture = moving.stage.compose(SIZE)
    assert not any(picture.scenery.ghosts)


def test_where_colours_are_few_they_look_like_limbs_that_cannot_move(moving):
    def kinds():
        frame, target = moving.frame(SIZE), new_target(SIZE.width, SIZE.height)
        moving.draw(frame, target, kinds=True)
        return kinds_shown(target.pixels)

    before = kinds()
    moving.execute("onion keys")
    after = kinds()
    new = after[(before == 0) & (after != 0)]
    assert len(new) > 50 and (new == 1).mean() > 0.95


@pytest.mark.parametrize("size", [SIZE, Size(160, 100, cells=True), Size(80, 48, cells=True)])
def test_without_colours_too_those_before_are_broken_and_those_after_whole(moving, size):
    moving.execute("onion keys")
    moving.kernels_ready()
    picture = (moving.frame(size), moving.stage.picture)[1]
    pose = moving.document.pose
    alike = replace(picture.scenery, ghosts=Ghosts((pose,), (pose,)))
    before, after = ghost_lists(picture.figure, alike, picture.shots[: picture.own])
    assert moving.status == "Ghosts of the keys before (cold, broken) and after (warm, whole)."
    for limb in map(picture.figure.index, ("spine", "leftthigh", "rightforearm")):
        rods = [listed.points[(listed.parts == limb) & (listed.radii > 0)][0, :2] for listed in (before, after)]
        lengths = [np.linalg.norm(end - begin) for begin, end in rods]
        assert lengths[0] == pytest.approx(lengths[1] / 2, rel=1e-3)
        np.testing.assert_allclose(rods[0].mean(axis=0), rods[1].mean(axis=0), atol=1e-2)
    assert min(before.radii[before.radii > 0].min(), after.radii[after.radii > 0].min()) > 0.5
    lit = []
    for listed in (before, after):
        target = new_target(size.width, size.height)
        moving.render(coded_as_still(replace(listed, backgrounds=np.zeros_like(listed.backgrounds))), target, PLAIN)
        lit.append(np.count_nonzero(kinds_shown(target.pixels)))
    assert 0 < lit[0] < 0.8 * lit[1]


class Hopping:
    """A plug-in with a way from key to key, and a command that fails."""

    @hookimpl
    def layfigure_interpolations(self):
        return [Interpolation("hopping", "In hops", ease=lambda share: share)]

    @hookimpl
    def layfigure_commands(self):
        return [Command("stumble", "Fail", lambda session, words: 1 / 0)]


def test_where_a_way_from_key_to_key_has_fallen_out_the_frame_says_why_there_are_no_ghosts(moving):
    moving.host.register(Hopping(), "hopping")
    moving.execute("interpolation hopping 30 all")
    moving.execute("onion keys")
    moving.status = ""
    assert moving.frame(SIZE).status == "" and all(moving.stage.picture.scenery.ghosts)
    moving.run("stumble")
    assert "ZeroDivisionError" in moving.frame(SIZE).status
    moving.execute("onion 5")
    moving.status = ""
    assert moving.frame(SIZE).status.startswith('there is no interpolation "hopping"')
    assert not any(moving.stage.picture.scenery.ghosts) and moving.status == ""
    moving.execute("onion off")
    moving.status = ""
    assert moving.frame(SIZE).status == ""


def test_the_page_can_be_left_out_of_a_drawing(moving):
    frame, whole = drawn(moving)
    target = new_target(SIZE.width, SIZE.height)
    moving.draw(frame, target, page=False)
    moving.render(moving.stage.picture.render_list, new_target(SIZE.width, SIZE.height), PLAIN)
    for pane in frame.panes:
        x, y, width, height = pane.rectangle
        part = (slice(y, y + height), slice(x, x + width))
        assert np.array_equal(whole[part], target.pixels[part]) == (pane.candidate == -1)
