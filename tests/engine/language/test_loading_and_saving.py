"""LOAD and SAVE: figures, motions, poses and libraries of one's own and shipped; nothing is written by a run."""

import pytest

from layfigure.errors import SourceError
from layfigure.figures.library import load_figure
from layfigure.motions.motion_file import load_motion
from layfigure.poses.pose import Pose
from layfigure.poses.pose_file import load_pose, save_pose

KEY = "m[1, 1] = FRAME 5 POSITION 1, 2, 1/3 INTERPOLATE linear\n"
MODEL = "a :- BOX WIDTH 1, HEIGHT 2, DEPTH 1; b :- a\nm :- JOINT 7, a, (0, 1, 0), b, (0, -1, 0), (-90, 90)\n"


def test_a_shipped_figure_gets_its_own_name_or_another(printed):
    assert printed('LOAD "Humanoid"\nPRINT humanoid')[0].startswith("humanoid: ")
    assert printed('LOAD "humanoid" AS lay\nPRINT lay')[0].startswith("humanoid: ")


def test_a_motion_that_is_saved_can_be_loaded_and_is_the_same(run, tmp_path):
    programme = run(f'{KEY}SAVE m, "walk to.motion"')
    assert list(tmp_path.iterdir()) == []
    (path,) = programme.write()
    assert path == tmp_path / "walk to.motion"
    assert run('LOAD "walk to.motion"\nPRINT at(walk_to, 5, 1)').printed == ("(1, 2, 1/3)",)
    assert load_motion(path).motion.duration == 5


def test_a_model_that_is_saved_is_a_figure_whose_joints_keep_their_identifiers(run, tmp_path):
    run(f'{MODEL}SAVE m, "m.fig"').write()
    figure = load_figure(tmp_path / "m.fig")
    assert [limb.joint_id for limb in figure.limbs[1:]] == ["7"]
    assert "x -90..90" in run('LOAD "m.fig"\nPRINT m').printed[0]


def test_poses_are_loaded_saved_and_made_into_motions(run, tmp_path):
    figure = load_figure("humanoid")
    bent = Pose.rest(figure).with_joint(figure.index("leftforearm"), 90, 0, 0)
    save_pose(tmp_path / "bent.pose", figure, bent)
    save_pose(tmp_path / "rest.pose", figure, Pose.rest(figure))
    programme = run(
        'LOAD "bent.pose"; LOAD "rest.pose"\nm = through(0, rest, 12, bent)\n'
        'PRINT at(m, 12, leftforearm)\nSAVE bent, "again.pose"\nPRINT bent'
    )
    programme.write()
    assert programme.printed[0] == "(90, 0, 0)"
    assert load_pose(tmp_path / "again.pose")[1] == bent


def test_a_library_gives_its_names_and_reads_its_own_files(run, tmp_path):
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "arm.lay").write_text('LOAD "more.lay"\nforearm = upper + 1\nPRINT "read"')
    (tmp_path / "parts" / "more.lay").write_text("upper = 2")
    assert run('LOAD "parts/arm.lay"\nPRINT upper, forearm').printed == ("read", "2 3")


def test_a_mistake_in_a_library_is_told_at_its_place_there(run, tmp_path):
    (tmp_path / "arm.lay").write_text("\n x = = 2")
    with pytest.raises(SourceError, match=r'arm.lay:2:6: found "="'):
        run('LOAD "arm.lay"')


def test_a_script_that_loads_itself_is_refused(run, tmp_path):
    (tmp_path / "script.lay").write_text('LOAD "script.lay"')
    (tmp_path / "other.lay").write_text('LOAD "./other.lay"')
    for name in ("script", "other"):
        with pytest.raises(SourceError, match="cannot load itself"):
            run(f'LOAD "{name}.lay"')


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ('LOAD "humanoit"', r':1:6: nothing is shipped under the name "humanoit"; did you mean "humanoid"'),
        ('LOAD "none.fig"', "there is no such file"),
        ('LOAD "none.exe"', 'the name "none.exe"'),
        ('LOAD "a/none.exe"', "a script loads .fig, .motion, .pose, .lay files"),
        ("LOAD 3", "must be a string in quotes"),
        (f'{KEY}SAVE m, "m.fig"', "is saved in a file that ends in .motion"),
        ('SAVE 3, "m.motion"', "can be saved, but this is a number"),
        (f'{KEY}SAVE m, "../m.motion"', "its own folder and those below"),
        (f'{KEY}SAVE m, "/tmp/m.motion"', "its own folder and those below"),
        (f'{KEY}SAVE m, "none/../../m.motion"', "its own folder and those below"),
        (
            f'{MODEL}m :- JOINT 8, m, (0,0,0), a, (0,0,0), (0,0), (0,9)\nn :- m <SCALE MODEL -1>\nSAVE n, "n.fig"',
            "mirror",
        ),
    ],
)
def test_what_cannot_be_loaded_or_saved_is_told(run, text, says):
    with pytest.raises(SourceError, match=says):
        run(text)


def test_a_file_whose_name_is_no_name_asks_for_one(run, tmp_path):
    (tmp_path / "1.motion").write_text("layfigure motion 1\nduration 3\n")
    with pytest.raises(SourceError, match=r'LOAD "1\.motion" AS name'):
        run('LOAD "1.motion"')
    assert run('LOAD "1.motion" AS one\nPRINT duration(one)').printed == ("3",)


def test_saving_elsewhere_is_an_option(run, tmp_path):
    (saving,) = run(f'{KEY}SAVE m, "../m.motion"', outside=True).savings
    assert saving.path.resolve() == (tmp_path / ".." / "m.motion").resolve()


def test_a_link_that_leads_outside_is_outside(run, tmp_path, tmp_path_factory):
    (tmp_path / "away").symlink_to(tmp_path_factory.mktemp("elsewhere"))
    with pytest.raises(SourceError, match="its own folder and those below"):
        run(f'{KEY}SAVE m, "away/m.motion"')
