"""The command ``grade``, going from candidate to candidate, and what stands on a graded candidate."""

import pytest

from layfigure.errors import ImpossibleError
from layfigure.session.events import KeyEvent
from layfigure.session.frame import Label, Size
from layfigure.session.words import WordError


@pytest.fixture
def graded(session):
    session.execute("use ga")
    return session


def badges(session, size):
    """The texts on the candidates' main views that are no numbers, by candidate, each inside its view."""
    frame = session.frame(size)
    found = {}
    for pane in frame.panes:
        if pane.candidate >= 0 and pane.view == "main":
            box = pane.rectangle
            for widget in frame.widgets:
                if not isinstance(widget, Label) or not box.contains(widget.rectangle.x, widget.rectangle.y):
                    continue
                assert widget.rectangle.x + widget.rectangle.width <= box.x + box.width
                if widget.role != "number":
                    found[pane.candidate] = widget
    return found


def test_one_word_grades_the_chosen_candidate_and_moves_on(graded):
    graded.execute("choose 4")
    graded.execute("grade 7")
    assert graded.log[-1] == "grade 4 7"
    assert graded.view.candidate == 4
    assert graded.offer().badges[3] == "7/10"
    assert graded.status == "Candidate 4 has 7 of 10."


def test_two_words_grade_that_candidate_and_the_choice_stays(graded):
    graded.execute("grade 9 10")
    assert graded.log[-1] == "grade 9 10"
    assert graded.view.candidate == 0
    assert graded.offer().badges[8] == "10/10"


def test_each_grade_is_one_entry_of_history(graded):
    graded.execute("grade 1 5")
    graded.execute("grade 1 6")
    graded.execute("undo")
    assert graded.offer().badges[0] == "5/10"


@pytest.mark.parametrize(
    ("line", "index"),
    [("grade", 1), ("grade 11", 1), ("grade x", 1), ("grade 10 5", 1), ("grade 1 -1", 2), ("grade 1 2 3", 3)],
)
def test_a_wrong_word_is_named_and_nothing_moves(graded, line, index):
    before, log = graded.document, list(graded.log)
    with pytest.raises(WordError) as error:
        graded.execute(line)
    assert error.value.index == index
    assert graded.document is before
    assert graded.log == log
    assert graded.view.candidate == 0


def test_a_technique_that_takes_no_grades_says_so(session):
    before = session.document
    with pytest.raises(ImpossibleError, match="Generator takes no grades"):
        session.execute("grade 1 5")
    assert session.document is before


def test_the_choice_goes_round_in_both_directions(session):
    session.execute("choose previous")
    assert session.view.candidate == 8
    session.execute("choose next")
    assert session.view.candidate == 0


@pytest.mark.parametrize("size", [Size(1280, 800), Size(800, 600), Size(2560, 1600, 2.0)])
@pytest.mark.parametrize("population", [9, 12])
def test_grades_stand_beside_the_numbers_inside_the_views(graded, size, population):
    graded.execute(f"population {population}")
    graded.execute("grade 1 5")
    graded.execute("evolve")
    assert not badges(graded, size)
    graded.execute("grade 2 0")
    graded.execute(f"grade {population} 10")
    shown = badges(graded, size)
    assert {candidate: label.text for candidate, label in shown.items()} == {1: "0/10", population - 1: "10/10"}
    numbers = [w.rectangle for w in graded.frame(size).widgets if isinstance(w, Label) and w.role == "number"]
    for label in shown.values():
        assert not any(box.contains(label.rectangle.x, label.rectangle.y) for box in numbers)


def test_a_candidate_chosen_in_a_larger_population_is_no_trap(graded):
    graded.execute("population 12")
    graded.execute("grade 1 5")
    graded.execute("evolve")
    graded.execute("choose 12")
    graded.execute("population 9")
    graded.execute("grade 12 5")
    graded.execute("evolve")
    graded.handle(KeyEvent("4", "4"))
    assert graded.log[-1] == "grade 9 4"
