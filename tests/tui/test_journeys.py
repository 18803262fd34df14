"""Whole jobs in a terminal, by keys alone, and what is left of them."""

import os
import signal
import time

import pytest

from layfigure.motions.motion_file import load_motion
from layfigure.poses.locks import broken
from layfigure.poses.pose_file import load_pose
from layfigure.session.log import load_log
from layfigure_frontends.headless import play_log
from layfigure_frontends.opening import PluginChoice, open_session

pytestmark = pytest.mark.tui


def replayed(terminal, name="job.log"):
    """Save the session's log in the program, and return the session that it leads to without a terminal."""
    terminal.keys(":")
    terminal.shows("│ :")
    terminal.type(f"save-log {name}", "Enter")
    return play_log(PluginChoice(), load_log(terminal.file(name)))


@pytest.mark.parametrize("terminal", [(160, 50), (80, 24)], indirect=True)
def test_a_person_assembles_mutates_undoes_asks_and_saves(terminal):
    terminal.start("--no-restore")
    assert "humanoid" in terminal.text()
    terminal.keys("5", "Tab", "Enter")
    terminal.logged("pick 5 ")
    terminal.keys("3", "b")
    terminal.logged("best 3")
    terminal.keys("m")
    terminal.shows("Generation 2")
    terminal.keys("C-z")
    terminal.shows("Undone: ")
    terminal.keys("C-y")
    terminal.shows("Generation 2")
    terminal.keys("?")
    terminal.shows("Keys that work now")
    terminal.keys("Escape")
    terminal.shows("Technique")
    terminal.keys(":")
    terminal.shows("│ :")
    terminal.type("flip", "Enter")
    terminal.logged("flip")
    terminal.keys("C-s")
    terminal.shows("Saved humanoid")
    _, pose = load_pose(next(terminal.folder.glob("*.pose")))
    assert replayed(terminal).document.pose == pose
    terminal.keys("C-q")
    terminal.shell_works()


def test_a_person_types_angles_and_nudges_joints(terminal):
    terminal.start("--no-restore")
    terminal.keys("F3")
    terminal.logged("use fk")
    terminal.keys("/")
    terminal.type("rightupperarm", "Enter")
    terminal.shows("right upperarm: ")
    terminal.keys("=")
    terminal.shows("│ ")
    terminal.keys(*["BSpace"] * 24)
    terminal.type("10 60 0", "Enter")
    terminal.logged("set rightupperarm 10 60 0")
    terminal.keys("C-Up")
    terminal.logged("set rightupperarm 15 60 0")
    terminal.shows("Flexion 15°")
    assert replayed(terminal).document.pose.angles.max() == pytest.approx(60)


def test_a_person_plants_a_foot_and_moves_a_hand_by_arrows_then_lets_the_hybrid_propose(terminal):
    terminal.start("--no-restore")
    terminal.keys("F4")
    terminal.logged("use ik")
    terminal.keys("/")
    terminal.type("leftfoot", "Enter", "l")
    terminal.logged("lock place leftfoot")
    terminal.keys("/")
    terminal.type("righthand", "Enter", "5")
    terminal.shows("last 5 limbs")
    terminal.keys_until("goal righthand ", "C-Up")  # the solver may still be made ready
    terminal.keys("F5")
    terminal.logged("use hybrid")
    terminal.keys("m")
    waited_for = terminal.shows("Generation", "generation")
    assert waited_for
    terminal.keys("2", "b")
    terminal.logged("best 2")
    document = replayed(terminal).document
    assert document.locks and broken(document.figure, document.pose, document.locks) == ()


def test_the_mouse_picks_a_limb_and_turns_the_view(terminal):
    terminal.start("--no-restore")
    from layfigure.session.events import PointerEvent
    from layfigure.session.frame import Size

    mirror = open_session(PluginChoice(), "", "terminal")
    frame = mirror.frame(Size(160, 100, cells=True))
    pane = next(p for p in frame.panes if p.candidate == 3 and p.view == "main")
    x, y, width, height = pane.rectangle
    spots = [(x + i, y + j) for j in range(0, height, 2) for i in range(width)]
    at = next(s for s in spots if mirror.stage.limb_at(pane, *s))
    mirror.handle(PointerEvent("press", *at, 1))
    mirror.handle(PointerEvent("release", *at, 1))
    cell = f"{at[0] + 1};{at[1] // 2 + 1}"
    terminal.tmux("send-keys", "-l", f"\x1b[<0;{cell}M")
    terminal.tmux("send-keys", "-l", f"\x1b[<0;{cell}m")
    terminal.logged(mirror.log[-1])


def test_a_resized_terminal_shows_one_view_then_says_that_it_is_too_small(terminal):
    terminal.start("--no-restore")
    terminal.tmux("resize-window", "-x", "80", "-y", "24")
    terminal.shows("humanoid, front")
    terminal.keys("z")
    terminal.shows("humanoid, right")
    terminal.tmux("resize-window", "-x", "39", "-y", "11")
    terminal.shows("posing")
    terminal.tmux("resize-window", "-x", "160", "-y", "50")
    terminal.shows("Technique")
    terminal.keys("C-q")
    terminal.shell_works()


def test_a_stopped_program_gives_the_shell_back_and_goes_on(terminal):
    terminal.start("--no-restore")
    os.kill(terminal.process(), signal.SIGTSTP)
    terminal.shows("Stopped")
    terminal.prompts()
    terminal.type("fg", "Enter")
    terminal.shows("Technique")
    terminal.keys("C-q")
    terminal.shell_works()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_a_signal_ends_it_in_good_order_and_the_work_is_offered_back(terminal, number):
    terminal.start()
    terminal.keys("4", "b")
    terminal.logged("best 4")
    os.kill(terminal.process(), number)
    terminal.shell_works()
    terminal.start()
    terminal.shows("Restore it?")
    terminal.keys("y")
    terminal.shows("Restored 1 steps", "Restored 1 step", "Restored 2 steps")
    terminal.keys("C-q")
    terminal.shell_works()


def test_a_killed_program_leaves_work_and_after_the_next_start_a_sane_terminal(terminal):
    terminal.start()
    terminal.keys("4", "b")
    terminal.logged("best 4")
    os.kill(terminal.process(), signal.SIGKILL)
    time.sleep(0.5)
    terminal.keys("C-c")
    terminal.start()
    terminal.shows("Restore it?")
    terminal.keys("y")
    terminal.shows("Restored")
    terminal.keys("C-q")
    terminal.shell_works()


def test_a_closed_terminal_keeps_the_work_for_the_next_start(terminal):
    terminal.start()
    terminal.keys("4", "b")
    terminal.logged("best 4")
    program = terminal.process()
    terminal.tmux("set-option", "-g", "exit-empty", "off")
    terminal.tmux("kill-session")
    for _ in range(400):
        if not os.path.exists(f"/proc/{program}"):  # noqa: PTH110
            break
        time.sleep(0.02)
    else:
        pytest.fail("the program outlives its terminal")
    from layfigure.session import journal

    (left,) = journal.orphans()
    assert "best 4" in journal.read(left)


@pytest.mark.parametrize("terminal", [(160, 50), (80, 24)], indirect=True)
def test_a_person_opens_plays_stops_keys_and_saves_a_motion(terminal):
    terminal.start("--no-restore")
    terminal.keys("C-o")
    terminal.shows("│ Open:")
    terminal.type("walk", "Enter")
    terminal.logged("motion ")
    terminal.shows("0 / 28")
    terminal.keys("Space")
    terminal.shows("Pause")
    terminal.shows("7 / 28", "12 / 28", "17 / 28", "22 / 28")
    terminal.keys("Escape")
    terminal.shows("Back at frame 0")
    terminal.shows(" 0 / 28")
    terminal.keys("}", ")", ")")
    terminal.logged("frame-at 3")
    terminal.keys("Tab", "C-Up", "K")
    terminal.logged("key 3 ")
    terminal.keys("C-s")
    terminal.shows("Saved humanoid-1.motion")
    saved = load_motion(terminal.file("humanoid-1.motion"))
    assert replayed(terminal).document.motion == saved.motion
    terminal.keys("C-q")
    terminal.shell_works()
