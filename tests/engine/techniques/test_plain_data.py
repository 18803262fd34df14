"""What techniques' states have in common as plain data."""

import pytest

from layfigure.errors import LayfigureError
from layfigure.figures.library import load_figure
from layfigure.poses.locks import Hold, JointLock, Pin
from layfigure.techniques.plain_data import limb_names, limbs_named, lock_lists, locks_listed, reading

HUMANOID = load_figure("humanoid")
LOCKS = (Pin(3, (1.0, -2.5, 3.25)), Hold(6, 7, (0.5, 0.0, 0.0)), JointLock(8))


def test_limbs_and_locks_come_back_as_they_were():
    assert limbs_named(HUMANOID, limb_names(HUMANOID, {5, 2, 9})) == {2, 5, 9}
    assert locks_listed(HUMANOID, lock_lists(HUMANOID, LOCKS)) == LOCKS


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        ({"version": 2, "limbs": []}, "juggling reads states of version 1, not 2"),
        ({"limbs": []}, "juggling reads states of version 1, not None"),
        ({"version": 1}, "the state of juggling is damaged"),
        ({"version": 1, "limbs": 3}, "the state of juggling is damaged"),
        ({"version": 1, "limbs": [None]}, "the state of juggling is damaged"),
        ({"version": 1, "limbs": ["tail"]}, 'no limb "tail"'),
    ],
)
def test_data_that_cannot_be_read_is_refused_in_one_sentence(data, sentence):
    with pytest.raises(LayfigureError, match=sentence), reading("juggling", data, 1):
        limbs_named(HUMANOID, data["limbs"])
