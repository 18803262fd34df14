"""The line prompt fed by a pipe of commands: what it prints where, its status, and what it leaves behind."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from PIL import Image

from layfigure.session import journal

COMMAND = [sys.executable, "-m", "layfigure_frontends"]


def plain(lines, folder, *words):
    text = "".join(f"{line}\n" for line in lines) if not isinstance(lines, bytes) else lines
    data = text if isinstance(text, bytes) else text.encode()
    command = [*COMMAND, "--plain", *words]
    done = subprocess.run(command, cwd=folder, input=data, capture_output=True, check=False, timeout=180)
    return done.returncode, done.stdout.decode(), done.stderr.decode()


def test_each_command_is_answered_by_its_status_and_by_how_the_pose_changed(tmp_path):
    lines = ["set rightforearm 90", "undo", "pick 4 lefthand", "where lefthand", "select neck", "view left", "mutate"]
    status, out, errors = plain(lines, tmp_path)
    assert (status, errors) == (0, "")
    assert out.splitlines() == [
        "Right forearm: bent 90 degrees more.",
        "Undone: set rightforearm.",
        "Right forearm: straightened 90 degrees.",
        "Copied left hand from candidate 4.",
        "Left hand: bent 22.5 degrees back.",
        "Left hand ends at the height of the hips, 25 left, 19 down, 5 back from the root; x 25, y -19.1, z 4.6.",
        "Neck: flexion, pivot and twist; flexion 0 degrees pivot 0 degrees twist 0 degrees.",
        "Done.",
        "Generation 2, page 1 of 3.",
    ]


def test_a_motion_is_gone_through_and_keyed_in_words(tmp_path):
    lines = ["open squat", "frame-at 6", "next-key", "set neck 20 0 0", "key", "key-remove", "list motion", "play",
             "save mine", "open mine.motion"]  # fmt: skip
    status, out, errors = plain(lines, tmp_path)
    said = out.splitlines()
    assert said[0].startswith("Opened squat: a motion of ")
    assert any(line.startswith("Frame 6 of ") and "keys beside it: " in line for line in said)
    assert any(line.startswith("Frame ") and ", a key of " in line for line in said)
    assert any(line.startswith("Key of all joints at frame ") for line in said)
    assert any(line.startswith("Removed the key of all joints at frame ") for line in said)
    rows = [line for line in said[said.index("Motion:") + 1 :] if line.startswith("Frame ")]
    assert len(rows) >= 2 and rows[0].startswith("Frame 0: all joints")
    assert "Saved mine.motion." in said and said[-2].startswith("Opened mine.motion")
    assert status == 0 and errors.startswith("Nothing plays here; frame-at, step and next-key go through the motion.")


def test_describe_and_candidates_are_said_in_sentences(tmp_path):
    status, out, _ = plain(["set spine -20 0 0", "describe", "candidates", "describe 3"], tmp_path)
    lines = out.splitlines()
    assert status == 0 and lines[1:4] == ["Humanoid:", "Standing upright.", "Leaning 20 degrees forward."]
    told = [line for line in lines if line.startswith("Candidate ") and ":" in line[:13]]
    assert [line[:12] for line in told] == [*(f"Candidate {n}:" for n in range(1, 10)), "Candidate 3:"]
    assert lines[-1].startswith("Compared with your pose, ")


def test_commands_can_be_shortened_and_limbs_named_in_two_words(tmp_path):
    status, out, errors = plain(["SET right forearm 45", "cand", "und", "exit", "describe"], tmp_path)
    assert (status, errors) == (0, "")
    assert "Right forearm: straightened 45 degrees." in out and "Humanoid:" not in out
    status, _, errors = plain(["p 3 neck"], tmp_path)
    assert status == 0 and errors.startswith('"p" can mean ') and "paste" in errors and "pick-in" not in errors


@pytest.mark.parametrize(
    ("line", "phrase"),
    [
        ("pock 3 neck", 'did you mean "pick"'),
        ("pick 3 nek", 'did you mean "neck"'),
        ("pick 99 neck", "from 1 to 9"),
        ('save "a b', "quote"),
        ("goal neck 1 2 3", ""),
        ("screenshot", "no window"),
        ("open absent.pose", "no such file"),
        ("x" * 30_000, "far too long"),
        ("accept", "nothing is being typed"),
    ],
)
def test_a_mistake_is_one_sentence_on_standard_error_and_the_prompt_goes_on(line, phrase, tmp_path):
    status, out, errors = plain([line, "set neck 0 0 10"], tmp_path)
    assert (
        status == 0 and errors.count("\n") == 1 and phrase in errors.casefold() and "traceback" not in errors.casefold()
    )
    assert errors.rstrip()[-1] in ".?" and out == "Neck: turned 10 degrees to the right.\n"


def test_strict_ends_at_the_first_mistake_with_status_two(tmp_path):
    status, out, errors = plain(["set neck 0 0 10", "frobnicate", "undo"], tmp_path, "--strict")
    assert status == 2 and out == "Neck: turned 10 degrees to the right.\n" and "frobnicate" in errors


def test_nothing_printed_could_move_a_cursor(tmp_path):
    lines = ["list commands", "list keys", "help", "figures", "ask open", "palette", "list limbs", "diff", "address"]
    (tmp_path / "bad\x1b[2Jname.pose").write_text("layfigure pose 1\nfigure humanoid\n")
    status, out, errors = plain([*lines, "ask open", "open bad\x1b[2Jname.pose"], tmp_path)
    assert status == 0 and "bad?[2Jname.pose" in out
    assert all(character.isprintable() or character == "\n" for character in out + errors)


def test_odd_bytes_comments_and_empty_lines_do_no_harm(tmp_path):
    status, out, _ = plain(b"\n# a comment\n\xff\xfe\x00\nset neck 0 0 10\r\n   \nundo", tmp_path)
    assert status == 0 and out.splitlines()[-1] == "Neck: turned 10 degrees to the left."


def test_questions_of_the_window_are_answered_by_commands_here(tmp_path):
    status, out, _ = plain(["figures", "ask store", "orbit-mode", "set neck 0 0 10"], tmp_path)
    assert status == 0 and "Type figure and what you choose." in out and "Type store and what you choose." in out
    assert out.endswith("Neck: turned 10 degrees to the right.\n")


def test_a_pose_and_its_picture_are_saved_and_the_log_replays_to_the_same_bytes(tmp_path):
    lines = ["pick 4 left hand", "mut", "vary 2 swing neck", "symmetric on", "set right thigh 40 0 0", "flip", "undo"]
    lines += ["save-log work", "save one", "render two.png", "describe"]
    status, out, errors = plain(lines, tmp_path)
    assert status == 0 and "Saved one.pose and its picture one.png." in out and "Saved two.png." in out, errors
    with Image.open(tmp_path / "one.png") as image:
        assert image.size == (1200, 800)
    again = [*COMMAND, "replay", "work.log", "--pose", "again.pose"]
    subprocess.run(again, cwd=tmp_path, check=True, capture_output=True, timeout=180)
    assert (tmp_path / "again.pose").read_bytes() == (tmp_path / "one.pose").read_bytes()
    told = subprocess.run([*COMMAND, "describe", "one.png"], cwd=tmp_path, check=True, capture_output=True, text=True)
    assert out.endswith("Humanoid:\n" + told.stdout)


def test_a_long_session_stays_in_step(tmp_path):
    lines = [f"set neck 0 0 {n % 40}" for n in range(600)] + ["undo"] * 300 + ["where neck"]
    status, out, errors = plain(lines, tmp_path)
    assert (status, errors) == (0, "") and out.count("Undone: ") == 300


def test_a_closed_session_leaves_no_journal_and_a_killed_one_is_offered_in_words(tmp_path):
    assert plain(["set neck 0 0 10"], tmp_path)[0] == 0
    assert journal.orphans() == []
    _killed(tmp_path, signal.SIGKILL)
    status, out, errors = plain(["restore", "where neck", "undo"], tmp_path)
    assert status == 0 and "The last session was not closed (2 steps" in errors
    assert "Type restore, forget or cancel." in errors
    assert out.startswith("Restored 2 steps") and out.endswith("Spine: straightened 20 degrees.\n")
    assert journal.orphans() == []


def test_a_session_offered_and_not_answered_is_kept_for_later(tmp_path):
    _killed(tmp_path, signal.SIGKILL)
    assert plain(["where neck"], tmp_path)[0] == 0
    assert len(journal.orphans()) == 1
    assert plain([], tmp_path, "--no-restore") == (0, "", "")
    assert plain(["forget"], tmp_path)[1] == "Thrown away.\n"
    assert journal.orphans() == []


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP, signal.SIGINT])
def test_a_signal_ends_it_in_good_order_and_keeps_the_session(number, tmp_path):
    assert _killed(tmp_path, number) == 128 + number
    assert len(journal.orphans()) == 1


def _killed(folder, number):
    """Set two joints in a session, send it a signal while it waits for more, and return its status."""
    victim = subprocess.Popen(
        [*COMMAND, "--plain"],
        cwd=folder,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )
    assert victim.stdin is not None and victim.stdout is not None
    victim.stdin.write("set neck 0 0 10\nset spine -20 0 0\n")
    victim.stdin.flush()
    assert victim.stdout.readline() == "Neck: turned 10 degrees to the right.\n"
    assert victim.stdout.readline() == "Spine: bent 20 degrees forward.\n"
    victim.send_signal(number)
    errors = victim.communicate(timeout=60)[1]
    assert "Traceback" not in errors
    return victim.returncode


def test_describe_tells_of_a_file_and_refuses_others_in_one_sentence(tmp_path):
    sitting = Path(__file__).resolve().parents[3] / "data" / "targets" / "sitting.pose"
    done = subprocess.run([*COMMAND, "describe", sitting], capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0 and done.stdout.splitlines()[0] == "Sitting."
    done = subprocess.run(
        [*COMMAND, "describe", "absent.pose"], cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60
    )
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "no such file" in done.stderr
