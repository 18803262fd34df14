"""Names that no file can have end in a sentence, whatever the command."""

import pytest

from layfigure.errors import FileError, LayfigureError
from layfigure.files.reading import read_text
from layfigure.files.writing import write_text
from layfigure.session.words import quoted

LONG = "a" * 300
NAMES = [".", "..", "/", "~nobody-of-that-name/x", LONG, LONG + ".pose", "a\0b.pose", "x/" * 3000, "\ud800.pose"]


@pytest.mark.parametrize("name", NAMES, ids=ascii)
@pytest.mark.parametrize("command", ["save", "picture", "open", "save-log", "breathe", "diff", "plugin", "figure"])
def test_a_name_that_no_file_can_have_is_refused(session, command, name, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    session.execute("use generator")
    before = session.document
    with pytest.raises(LayfigureError):
        session.execute(f"{command} {quoted(name)}")
    assert session.document is before and not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", [LONG, "a\0b", "\ud800"], ids=ascii)
def test_reading_and_writing_say_so_too(tmp_path, name):
    with pytest.raises(FileError):
        read_text(tmp_path / name)
    with pytest.raises(FileError):
        write_text(tmp_path / name, "x")
