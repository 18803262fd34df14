"""What the panel says of the selection and of locks."""

from layfigure.session.frame import Label, Size

SIZE = Size(1280, 800)


def said(session) -> list[str]:
    return [widget.text for widget in session.frame(SIZE).widgets if isinstance(widget, Label)]


def test_many_locks_are_named_by_their_limbs_so_that_all_fit(session):
    session.run("select leftfoot rightfoot")
    session.run("toggle-lock place")
    session.run("toggle-lock orientation")
    session.run("cancel")
    assert [line for line in said(session) if "lock" in line.casefold()] == ["4 locks: right foot, left foot"]


def test_two_locks_are_told_with_their_kinds(session):
    session.run("select leftfoot")
    session.run("toggle-lock place")
    session.run("toggle-lock joint")
    assert "Locked: left foot pinned, left foot joint locked" in said(session)


def test_the_root_is_not_called_immovable_for_it_turns_and_carries_the_figure(session):
    session.run("select top")
    assert "top: turns and carries the figure" in said(session)
