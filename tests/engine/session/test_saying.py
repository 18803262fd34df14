"""The commands that say things: on the status line, and as a page for every front end."""

import pytest

from layfigure.errors import LayfigureError


def test_describe_says_the_pose_on_the_status_line_and_as_a_page(session):
    session.execute("set rightforearm 90")
    session.execute("describe")
    page = session.mode.overlay()
    assert session.status == "Standing upright. Right elbow bent 90 degrees, forearm forward."
    assert page.spoken == ("Standing upright.", "Right elbow bent 90 degrees, forearm forward.")
    assert page.sections == (
        ("The whole body", ((" ", "standing upright"),)),
        ("Right elbow", ((" ", "bent 90 degrees"), (" ", "forearm forward"))),
    )
    session.run("cancel")
    assert session.mode.overlay() is None


def test_describe_says_a_candidate_beside_the_pose(session):
    session.execute("describe 4")
    page = session.mode.overlay()
    assert page.title == "Candidate 4" and page.spoken[-1].startswith("Compared with your pose, ")


def test_saying_leaves_document_history_and_log_alone(session):
    before = session.document, list(session.log), session.history
    for line in ("describe", "describe 2", "where lefthand", "list limbs", "list candidates", "list keys", "help pick"):
        session.execute(line)
    assert (session.document, session.log, session.history) == before


@pytest.mark.parametrize("what", ["limbs", "candidates", "techniques", "commands"])
def test_lists_hold_a_line_for_each(session, what):
    session.execute(f"list {what}")
    page = session.mode.overlay()
    line = {
        "limbs": "leftleg: flexion only; at rest.",
        "candidates": "Candidate 1: ",
        "techniques": "generator: Generator, in use.",
        "commands": "describe [CANDIDATE]: Say the pose or a candidate in words.",
    }[what]
    assert any(spoken.startswith(line) for spoken in page.spoken), page.spoken
    assert len(page.spoken) == len(page.sections[0][1]) > 3


def test_where_and_help_answer_on_the_status_line(session):
    session.execute("where lefthand")
    assert session.status.startswith("Left hand ends at the height of the hips")
    session.execute("help describe")
    assert session.status == "describe [CANDIDATE]: Say the pose or a candidate in words. Its key is Shift-D."


@pytest.mark.parametrize(
    ("line", "phrase"),
    [
        ("describe 10", "whole number from 1 to 9"),
        ("describe 1 2", "one word too many"),
        ("where", "limb"),
        ("where tail", "no limb"),
        ("list", "ends too early"),
        ("list everything", "it can be limbs, candidates"),
        ("help frobnicate", "no command"),
    ],
)
def test_a_mistake_is_one_sentence(session, line, phrase):
    with pytest.raises(LayfigureError, match=phrase):
        session.execute(line)


def test_without_candidates_there_is_none_to_describe(session):
    session.execute("use fk")
    for line in ("describe 1", "list candidates"):
        with pytest.raises(LayfigureError, match="no candidates"):
            session.execute(line)
