"""One door: what keys and command lines do to the document, its history and its log."""

from dataclasses import dataclass

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.configuration import load_bindings
from layfigure.drawing.render_list import new_target
from layfigure.errors import LayfigureError
from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.host import Host
from layfigure.plugins.records import Overlay, OverlayLine, Renderer, Technique
from layfigure.poses.pose_set import load_poses
from layfigure.session.document import Document
from layfigure.session.events import KeyEvent, PointerEvent
from layfigure.session.figures import open_figure
from layfigure.session.frame import Button, ChoiceBar, Size, SliderBar
from layfigure.session.log import parse_log
from layfigure.session.replay import open_log, play
from layfigure.session.session import Session, SessionOptions
from layfigure.session.words import WordError
from layfigure.techniques.contract import Offer

SIZE = Size(1280, 800)


def press(session, *keys):
    for key in keys:
        session.handle(KeyEvent(key, key if len(key) == 1 else ""))


def replayed(host, session) -> Session:
    log = parse_log("\n".join(session.log), "replay.log")
    again = open_log(host, log, SessionOptions(compiled=False))
    play(again, log)
    return again


def test_the_first_generation_is_there_at_the_start(session):
    assert len(session.offer().candidates) == 9
    assert session.document.pose == session.document.pose.rest(session.document.figure)


def test_keys_choose_a_candidate_walk_to_a_limb_and_copy_it(session):
    press(session, "4", "tab", "tab", "enter")
    assert session.log[-1] == "pick 4 rightleg"
    leg = session.document.figure.index("rightleg")
    assert (session.document.pose.angles[leg] != 0).any()


def test_a_copied_limb_stands_in_all_candidates(session):
    press(session, "4", "tab", "enter")
    limb = session.view.selected[-1]
    wanted = session.document.pose.angles[limb].tolist()
    assert all(pose.angles[limb].tolist() == wanted for pose in session.offer().candidates)


def test_undo_takes_back_one_gesture_and_the_generation(session):
    start = session.document
    press(session, "4", "tab", "enter")
    picked = session.document
    press(session, "m")
    press(session, "ctrl+z")
    assert session.document is picked
    press(session, "u")
    assert session.document is start


def test_turning_pages_is_no_entry_of_history(session):
    press(session, "4", "tab", "enter", "n", "n", "ctrl+z")
    assert not session.history.done


def test_copying_what_is_there_already_is_no_entry_of_history(session):
    press(session, "4", "tab", "enter", "enter")
    assert len(session.history.done) == 1


def test_redo_brings_back_exactly_what_undo_took(session):
    press(session, "4", "tab", "enter", "m")
    last = session.document
    press(session, "u", "u", "ctrl+y", "ctrl+shift+z")
    assert session.document is last


def test_relative_words_are_logged_as_what_they_came_to(session):
    press(session, "-", "-", "+", "t")
    assert session.log[-4:] == ["intensity 95", "intensity 90", "intensity 95", "kind twist"]


def test_an_impossible_command_says_so_and_changes_nothing(session):
    before = session.document, list(session.log)
    press(session, "ctrl+z")
    assert "nothing to undo" in session.status
    assert (session.document, session.log) == before


def test_an_unknown_command_suggests_the_nearest(session):
    with pytest.raises(WordError, match='did you mean "mutate"'):
        session.execute("mutat")


def test_kept_limbs_are_the_same_in_every_candidate_of_the_next_generation(session):
    session.execute("pick 5 spine")
    session.execute("disable spine neck")
    session.execute("mutate")
    spine = session.document.figure.index("spine")
    angles = {tuple(pose.angles[spine]) for pose in session.offer().candidates}
    assert angles == {tuple(session.document.pose.angles[spine])}


def test_initialise_without_a_selection_starts_over_and_with_one_resets_it(session):
    session.execute("pick 5 spine neck")
    session.execute("select spine")
    press(session, "i")
    spine, neck = session.document.figure.index("spine"), session.document.figure.index("neck")
    assert not session.document.pose.angles[spine].any() and session.document.pose.angles[neck].any()
    press(session, "escape", "i")
    assert not session.document.pose.angles.any()
    assert session.offer().title.startswith("Generation 1")


def test_nudges_stop_at_the_limit(session):
    session.execute("select leftforearm")
    for _ in range(40):
        press(session, "ctrl+up")
    forearm = session.document.figure.index("leftforearm")
    assert session.document.pose.angles[forearm].tolist() == [160.0, 0.0, 0.0]


def test_mirroring_twice_is_nothing(session):
    session.execute("pick 7 all")
    before = session.document.pose
    press(session, "x")
    assert session.document.pose != before
    press(session, "x")
    assert session.document.pose == before


def test_another_figure_can_be_taken_and_undone(session):
    humanoid = session.document.figure
    session.execute("figure juxo")
    assert session.document.figure.name == "juxo" and len(session.offer().candidates) == 9
    session.execute("undo")
    assert session.document.figure is humanoid


def test_a_slider_dragged_is_one_entry_and_escape_gives_it_up(session):
    bar = next(w for w in session.frame(SIZE).widgets if isinstance(w, SliderBar))
    y = bar.rectangle.y + bar.rectangle.height // 2
    right = bar.rectangle.x + bar.rectangle.width
    before = session.document
    session.handle(PointerEvent("press", right - 20, y, 1))
    for x in (right - 60, right - 100, right - 140):
        session.handle(PointerEvent("move", x, y, 1))
        assert session.offer().values["intensity"] < 100
    session.handle(KeyEvent("escape"))
    assert session.document is before and session.mode.state == "pose"
    session.handle(PointerEvent("press", right - 20, y, 1))
    session.handle(PointerEvent("release", bar.rectangle.x + bar.rectangle.width / 2, y, 1))
    assert session.offer().values["intensity"] == 50
    assert len(session.history.done) == 1 and session.log[-1] == "intensity 50"


def test_clicking_a_choice_takes_it(session):
    bars = [w for w in session.frame(SIZE).widgets if isinstance(w, ChoiceBar)]
    bar = next(bar for bar in bars if bar.command == "kind")
    x, y = bar.rectangle.x + bar.rectangle.width - 5, bar.rectangle.y + bar.rectangle.height - 5
    session.handle(PointerEvent("press", x, y, 1))
    assert session.offer().values["kind"] == "twist"


def test_a_click_on_a_limb_copies_it_and_a_click_beside_chooses_the_candidate(session):
    frame = session.frame(SIZE)
    pane = next(pane for pane in frame.panes if pane.candidate == 4 and pane.view == "main")
    x, y, width, height = pane.rectangle
    points = [(x + i * width / 30, y + j * height / 30) for j in range(1, 30) for i in range(1, 30)]
    on = next(p for p in points if session.stage.limb_at(pane, *p) is not None)
    beside = next(p for p in points if session.stage.limb_at(pane, *p) is None)
    for point in (beside, on):
        session.handle(PointerEvent("press", *point, 1))
        session.handle(PointerEvent("release", *point, 1))
    assert session.view.candidate == 4
    assert session.log[-1].startswith("pick 5 ")


def test_a_rectangle_round_a_candidate_takes_every_limb(session):
    frame = session.frame(SIZE)
    x, y, width, height = next(p for p in frame.panes if p.candidate == 2 and p.view == "main").rectangle
    session.handle(PointerEvent("press", x + 1, y + 1, 1))
    session.handle(PointerEvent("move", x + 50, y + 50, 1))
    assert session.frame(SIZE).outlines[-1].role == "band"
    session.handle(PointerEvent("move", x + width - 1, y + height - 1, 1))
    session.handle(PointerEvent("release", x + width - 1, y + height - 1, 1))
    assert session.log[-1].startswith("pick 3 ") and len(session.log[-1].split()) == 2 + 14


def test_ctrl_drag_turns_the_view_and_leaves_the_document_alone(session):
    frame = session.frame(SIZE)
    before, camera = session.document, session.view.camera
    x, y, width, height = next(p for p in frame.panes if p.candidate == 0 and p.view == "main").rectangle
    session.handle(PointerEvent("press", x + width / 2, y + height / 2, 1, ctrl=True))
    session.handle(PointerEvent("move", x + width / 2 + 40, y + height / 2 + 10, 1, ctrl=True))
    session.handle(PointerEvent("release", x + width / 2 + 40, y + height / 2 + 10, 1, ctrl=True))
    assert session.document is before and session.view.camera != camera
    press(session, "home")
    assert session.view.camera == camera


def test_typing_a_command_in_the_palette_runs_it(session):
    press(session, ":", *"mutate", "enter")
    assert session.log[-1] == "mutate" and session.mode.state == "pose"


def test_a_mistyped_command_stays_in_the_palette_with_its_reason(session):
    press(session, ":", *"pick")
    session.handle(KeyEvent("space", " "))
    press(session, "x", "enter")
    overlay = session.frame(SIZE).overlay
    assert overlay is not None and "not a number" in overlay.message


def test_help_shows_every_key_that_works_now(session):
    press(session, "?")
    overlay = session.frame(SIZE).overlay
    rows = {keys: title for _, section in overlay.sections for keys, title in section}
    assert rows["M"] == "Mutate" and rows["1 … 9"] == "Choose a candidate"
    press(session, "escape")
    assert session.frame(SIZE).overlay is None


def test_help_lists_what_has_several_keys_once(session):
    press(session, "?")
    titles = [title for _, section in session.frame(SIZE).overlay.sections for _, title in section]
    assert titles.count("Mirror the pose") == 1
    rows = {title: keys for _, section in session.frame(SIZE).overlay.sections for keys, title in section}
    assert rows["Mirror the pose"] == "X  Ctrl-M"


def test_the_log_replays_to_the_same_document(session, host):
    press(
        session,
        "3",
        "tab",
        "enter",
        "n",
        "6",
        "tab",
        "enter",
        "m",
        "-",
        "-",
        "2",
        "enter",
        "u",
        "ctrl+y",
        "x",
        "t",
        "m",
    )
    again = replayed(host, session)
    assert again.document.pose == session.document.pose
    assert again.offer() == session.offer()


KEYS = ["1", "5", "9", "tab", "shift+tab", "[", "]", "\\", "enter", "b", "y", "shift+y", "m", "n", "shift+n", "f",
        "t", "-", "+", "e", "shift+e", "i", "x", "u", "shift+u", "ctrl+left", "ctrl+up", ".", "escape",
        "|", "c", "p", "shift+p", "shift+i"]  # fmt: skip


@settings(max_examples=25, deadline=None)
@given(keys=st.lists(st.sampled_from(KEYS), max_size=25))
def test_any_keys_undo_to_the_start_and_replay_to_the_same(keys):
    host = Host.discover()
    options = SessionOptions(frontend="sdl", bindings=load_bindings(host, "layfigure"), compiled=False)
    session = Session(host, Document.new(open_figure(host, "humanoid")), options)
    start = session.document
    press(session, *keys)
    pose = session.document.pose
    again = replayed(host, session)
    assert again.document.same_as(session.document) or again.document.pose == pose
    steps = len(session.history.done)
    for _ in range(steps):
        session.run("undo")
    assert session.document.pose == start.pose and session.document.enabled == start.enabled
    for _ in range(steps):
        session.run("redo")
    assert session.document.pose == pose


# --- plug-ins that misbehave ---------------------------------------------------------------------------------------


@dataclass
class Faulty:
    """A technique that does as it should until it is told not to."""

    figure: object
    fail_in: str

    def start(self, setting):
        return setting.pose

    def ask(self, state):
        self._maybe("ask")
        return Offer((state,) * 4)

    def tell(self, state, event):
        self._maybe("tell")
        return state

    def recommend(self, state):
        return "not a pose" if self.fail_in == "recommend" else state

    def _maybe(self, where):
        if self.fail_in == where:
            raise KeyError("lost")


@pytest.mark.parametrize("where", ["ask", "tell", "recommend"])
def test_a_technique_that_fails_is_left_and_the_pose_stays(where):
    host = Host.discover()
    record = Technique("faulty", "Faulty", lambda bench: Faulty(bench.figure, where), frozenset({"limb_pick"}))
    host.register(bringing(layfigure_techniques=[record]), "stranger")
    session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions(compiled=False))
    session.run("pick 5 spine")
    pose = session.document.pose
    session.run("use faulty")
    session.run("pick 1 spine")
    assert session.frame(SIZE).panes
    assert session.document.technique == "generator" and session.document.pose == pose
    assert "stranger" in str(host.faults[0])
    session.run("mutate")
    assert session.offer().title.startswith("Generation")


def test_a_renderer_that_fails_is_replaced_by_one_that_works():
    host = Host.discover()

    class Broken:
        def draw(self, render_list, target, look):
            raise MemoryError("no paint")

    record = Renderer("broken", "Broken", Broken)
    host.register(bringing(layfigure_renderers=[record]), "stranger")
    options = SessionOptions(renderer="broken", compiled=False)
    session = Session(host, Document.new(open_figure(host, "humanoid")), options)
    target = new_target(SIZE.width, SIZE.height)
    session.draw(session.frame(SIZE), target)
    assert len(set(target.pixels[::7, ::7].ravel().tolist())) > 20
    assert "stranger" in session.status and "broken" not in host.renderers


def bringing(**hooks):
    """A plug-in object with hooks that return what is given."""
    methods = {name: hookimpl(_returning(records), specname=name) for name, records in hooks.items()}
    return type("Plugin", (), {name: staticmethod(method) for name, method in methods.items()})()


def _returning(records):
    return lambda: records


def test_an_overlay_draws_over_the_working_pose_when_switched_on():
    host = Host.discover()
    axis = OverlayLine((0, -50, 0), (0, 50, 0), (0, 255, 0))
    host.register(bringing(layfigure_overlays=[Overlay("axis", "Axis", lambda figure, pose: [axis])]), "stranger")
    session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions(compiled=False))
    assert session.frame(SIZE).lines == ()
    session.execute("overlay axis")
    front = session.frame(SIZE).lines[0]
    assert front.x1 == front.x2 and front.y1 > front.y2 and len(session.frame(SIZE).lines) == 3


def test_no_technique_at_all_still_shows_the_pose():
    session = Session(Host(), Document.new(open_figure(Host(), "humanoid")), SessionOptions(compiled=False))
    assert len(session.frame(SIZE).panes) == 3
    with pytest.raises(LayfigureError, match="no renderer"):
        session.draw(session.frame(SIZE), new_target(SIZE.width, SIZE.height))


def test_breathing_saves_the_pose_and_small_variants_as_a_set(session, tmp_path):
    session.execute(f"breathe {tmp_path / 'life'} 3 6")
    figure, poses = load_poses(tmp_path / "life.poses")
    assert figure is session.document.figure or figure.name == session.document.figure.name
    assert poses[0] == session.document.pose and len(set(poses)) == 4
    assert not any(line.startswith("breathe") for line in session.log)
    session.execute("pick 4 rightleg")
    session.execute(f"open {tmp_path / 'life.poses'}")
    assert session.document.pose == poses[0]


@pytest.mark.parametrize("line", ["breathe", "breathe x 0", "breathe x 1.5", "breathe x 2 101", "breathe x 2 3 4"])
def test_breathing_that_makes_no_sense_is_refused(session, line):
    with pytest.raises(LayfigureError):
        session.execute(line)


def test_a_technique_without_variants_cannot_breathe(host, tmp_path):
    @dataclass(frozen=True)
    class Still:
        def start(self, setting):
            return setting.pose

        def ask(self, state):
            return Offer()

        def tell(self, state, event):
            return state

        def recommend(self, state):
            return state

    class Plugin:
        @hookimpl
        def layfigure_techniques(self):
            return [Technique("still", "Still", lambda bench: Still(), frozenset())]

    host.register(Plugin(), "still")
    session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions("still", compiled=False))
    with pytest.raises(LayfigureError, match="makes no variants"):
        session.execute(f"breathe {tmp_path / 'life'}")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("height", "toggled"), [(1000, True), (800, True), (760, False)])
def test_toggles_give_way_to_buttons_where_the_window_is_low(session, height, toggled):
    texts = [widget.text for widget in session.frame(Size(1280, height)).widgets if isinstance(widget, Button)]
    assert {"Mutate", "Next page", "Undo", "Redo", "Initialise"} <= set(texts)
    assert ("Floor" in texts) == toggled


def test_a_pressed_filter_leaves_its_mark_on_the_page_and_in_the_log(session):
    before = session.offer().candidates
    session.execute("balanced")
    assert session.log[-1] == "balanced on"
    assert session.offer().candidates != before and "off balance" in session.offer().note
    session.execute("balanced off")
    assert session.offer().candidates == before


def test_a_technique_is_asked_again_once_the_kernels_are_there(session):
    first = session.offer()
    assert session.offer() is first
    session.kernels_ready()
    assert session.offer() is not first and session.offer() == first
