"""A killed session is offered back whole; a closed one is not."""

import os
import signal
import subprocess
import sys

from layfigure.plugins.host import Host
from layfigure.session import journal
from layfigure.session.document import Document
from layfigure.session.events import KeyEvent
from layfigure.session.figures import open_figure
from layfigure.session.session import Session, SessionOptions
from layfigure_frontends.recovery import Recovery

VICTIM = """
import sys, time
from layfigure.plugins.host import Host
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.session import Session, SessionOptions
from layfigure_frontends.recovery import Recovery
host = Host.discover()
session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions(compiled=False))
recovery = Recovery(session)
for line in ("pick 4 spine neck", "mutate", "pick 2 leftthigh", "undo", "intensity 40"):
    session.execute(line)
print(session.document.pose.angles.tolist(), flush=True)
time.sleep(60)
"""


def killed_session() -> str:
    """Run a session in another process, kill it in mid-work, and return the angles it stood at."""
    victim = subprocess.Popen([sys.executable, "-c", VICTIM], stdout=subprocess.PIPE, text=True)
    assert victim.stdout is not None
    angles = victim.stdout.readline().strip()
    assert journal.orphans() == [], "a living session's journal must not be offered to another"
    os.kill(victim.pid, signal.SIGKILL)
    victim.wait()
    victim.stdout.close()
    return angles


def test_after_kill_9_the_next_start_offers_the_session_and_y_brings_it_back(session):
    angles = killed_session()
    recovery = Recovery(session)
    recovery.offer()
    assert "not closed (5 steps" in session.mode.overlay().text
    session.handle(KeyEvent("y", "y"))
    assert str(session.document.pose.angles.tolist()) == angles
    assert session.offer().values["intensity"] == 40
    session.run("redo")
    assert "nothing to redo" in session.status or session.history.done
    assert journal.orphans() == []
    recovery.close()


def test_motions_and_where_one_stood_in_them_survive_too(session):
    lost = Session(Host.discover(), Document.new(session.document.figure), SessionOptions(compiled=False))
    first = Recovery(lost)
    for line in ("open walk", "frame-at 7", "set neck 20 0 0", "key", "stretch 2", "undo", "frame-at 3"):
        lost.execute(line)
    lost.on_closed = first.close
    lost.close(interrupted=True)
    recovery = Recovery(session)
    recovery.offer()
    session.handle(KeyEvent("y", "y"))
    restored, document = session.document, lost.document
    assert (restored.motion, restored.pose, restored.playhead) == (document.motion, document.pose, 3)
    assert len(session.history.done) == len(lost.history.done)
    recovery.close()


def test_a_restored_session_is_kept_safe_again(session, host):
    killed_session()
    recovery = Recovery(session)
    recovery.offer()
    session.handle(KeyEvent("enter"))
    session.execute("mutate")
    lines = journal.read(next(journal.folder().glob("*.log"))).splitlines()
    assert lines == session.log and lines[-1] == "mutate" and len(lines) == 3 + 6
    recovery.close()


def test_a_session_thrown_away_is_gone_and_one_kept_for_later_stays(session):
    killed_session()
    recovery = Recovery(session)
    recovery.offer()
    session.handle(KeyEvent("escape"))
    recovery.close()
    assert len(journal.orphans()) == 1
    recovery = Recovery(session)
    recovery.offer()
    session.handle(KeyEvent("d", "d"))
    recovery.close()
    assert journal.orphans() == []


def test_a_session_that_was_closed_leaves_nothing(session):
    recovery = Recovery(session)
    session.on_closed = recovery.close
    session.execute("mutate")
    session.execute("quit")
    assert list(journal.folder().iterdir()) == []


def test_a_session_without_work_is_not_offered(session):
    recovery = Recovery(session)
    path = next(journal.folder().glob("*.log"))
    recovery.close()
    path.write_text("layfigure log 1\nfigure humanoid\ntechnique generator\n")
    assert journal.orphans() == [] and not path.exists()


def test_a_line_cut_by_the_crash_is_left_out(tmp_path):
    path = tmp_path / "cut.log"
    path.write_bytes(b"layfigure log 1\nfigure humanoid\ntechnique generator\nmutate\npick 3 le")
    assert journal.read(path).splitlines()[-1] == "mutate"


def test_a_journal_that_no_longer_plays_gives_back_what_it_can(session):
    journal.folder().mkdir(parents=True)
    path = journal.folder() / "20200101-000000-000000-1.log"
    path.write_text("layfigure log 1\nfigure humanoid\ntechnique generator\npick 4 spine\nno-such-command\nmutate\n")
    recovery = Recovery(session)
    recovery.offer()
    session.handle(KeyEvent("y", "y"))
    assert session.log[3:] == ["pick 4 spine"] and "Restored as far as it goes" in session.status
    recovery.close()


def test_where_the_state_folder_cannot_be_written_the_session_says_so(session, monkeypatch, tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("")
    monkeypatch.setenv("XDG_STATE_HOME", str(blocked))
    recovery = Recovery(session)
    assert "not kept safe" in session.status
    session.execute("mutate")
    recovery.close()


def test_restoring_takes_the_figure_of_the_lost_session(host, tmp_path):
    journal.folder().mkdir(parents=True)
    path = journal.folder() / "20200101-000000-000000-1.log"
    path.write_text("layfigure log 1\nfigure juxo\ntechnique generator\nmutate\n")
    session = Session(host, Document.new(open_figure(host, "humanoid")), SessionOptions(compiled=False))
    recovery = Recovery(session)
    recovery.offer()
    session.handle(KeyEvent("y", "y"))
    assert session.document.figure.name == "juxo"
    recovery.close()


def test_an_interrupted_session_is_kept_for_the_next_start(session):
    recovery = Recovery(session)
    session.on_closed = recovery.close
    session.execute("mutate")
    session.close(interrupted=True)
    assert len(journal.orphans()) == 1
