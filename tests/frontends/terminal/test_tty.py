"""In a real pseudo-terminal: taken over, read, written to, and given back however the program ends or is stopped."""

import json
import os
import shutil
import signal
import sys
import termios
import time
from pathlib import Path

import pytest

from layfigure_frontends.terminal.marker import Marker
from layfigure_frontends.terminal.modes import ENTER, LEAVE, restore_sequence

ECHO = """
import sys, pathlib
from layfigure_frontends.terminal.tty import PosixTerminal
marker = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else None
with PosixTerminal(marker=marker) as terminal:
    terminal.write(b"<ready>")
    while True:
        arrival = terminal.wait(None)
        if arrival.resized:
            terminal.write(b"<%dx%d>" % terminal.size())
        if arrival.resumed:
            terminal.write(b"<resumed>")
        if b"!" in arrival.data:
            raise RuntimeError("broken on purpose")
        if arrival.data:
            terminal.write(b"<" + arrival.data.hex().encode() + b">")
        if arrival.ended or b"q" in arrival.data:
            break
print("ended", arrival.ended)
"""


def assert_given_back(program):
    assert program.attributes() == program.before
    assert LEAVE in program.seen


def test_every_control_key_arrives_as_a_byte(start):
    program = start(ECHO)
    program.wait_for(ENTER)
    program.wait_for(b"<ready>")
    assert not program.attributes()[3] & (termios.ICANON | termios.ECHO | termios.ISIG)
    program.send(b"\x1a\x03\x13\x11\x1c\r")
    program.wait_for(b"<1a0313111c0d>")


def test_the_terminal_is_given_back_at_a_normal_end(start):
    program = start(ECHO)
    program.wait_for(b"<ready>")
    program.send(b"q")
    assert program.end() == 0
    assert_given_back(program)
    assert b"ended" in program.seen.partition(LEAVE)[2]


def test_the_terminal_is_given_back_before_an_exception_is_told(start):
    program = start(ECHO)
    program.wait_for(b"<ready>")
    program.send(b"!")
    assert program.end() == 1
    assert_given_back(program)
    assert b"broken on purpose" in program.process.stderr.read()


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_the_terminal_is_given_back_after_a_signal_to_end(start, number):
    program = start(ECHO)
    program.wait_for(b"<ready>")
    program.process.send_signal(number)
    assert program.end() == 0
    assert_given_back(program)
    assert f"ended {number.name}".encode() in program.seen


def test_a_second_signal_ends_a_program_that_does_not_listen(start):
    program = start(ECHO.replace("arrival = terminal.wait(None)", "import time; time.sleep(60)"))
    program.wait_for(b"<ready>")
    program.process.send_signal(signal.SIGTERM)
    time.sleep(0.2)
    program.process.send_signal(signal.SIGTERM)
    assert program.end() == 128 + signal.SIGTERM
    assert_given_back(program)


def test_an_interrupt_from_outside_gives_the_terminal_back_too(start):
    program = start(ECHO)
    program.wait_for(b"<ready>")
    program.process.send_signal(signal.SIGINT)
    program.end()
    assert_given_back(program)


@pytest.mark.parametrize("session_leader", [True, False], ids=["told by SIGHUP", "told by reading"])
def test_a_closed_terminal_ends_the_loop(start, tmp_path, session_leader):
    told = tmp_path / "told"
    code = ECHO.replace('print("ended", arrival.ended)', f"pathlib.Path({str(told)!r}).write_text(arrival.ended)")
    program = start(code) if session_leader else start(arguments=[sys.executable, "-c", code])
    program.wait_for(b"<ready>")
    program.hang_up()
    assert program.process.wait(timeout=30) == 0
    assert told.read_text() in (("closed", "SIGHUP") if session_leader else ("closed",))


def test_a_new_size_is_told(start):
    program = start(ECHO)
    program.wait_for(b"<ready>")
    program.resize(100, 30)
    program.wait_for(b"<100x30>")


@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash for its job control")
def test_stopped_by_a_signal_it_leaves_the_screen_and_takes_it_again_when_it_goes_on(start, tmp_path):
    script, number = tmp_path / "echo.py", tmp_path / "pid"
    note = f"import os; pathlib.Path({str(number)!r}).write_text(str(os.getpid()))"
    script.write_text(ECHO.replace('write(b"<ready>")', f'write(b"<ready>"); {note}'))
    code = "import os; os.dup2(1, 2); os.execvp('bash', ['bash', '--norc', '--noprofile', '-i'])"
    program = start(code, environment={"PS1": "shell> ", "TERM": "xterm"})
    program.wait_for(b"shell> ")
    program.send(f"{sys.executable} {script}\r".encode())
    program.wait_for(b"<ready>")
    while not number.exists() or not number.read_text():
        program.read(0.02)
    os.kill(int(number.read_text()), signal.SIGTSTP)
    program.wait_for(LEAVE)
    program.wait_for(b"Stopped")
    program.wait_for(b"shell> ")
    program.send(b"fg\r")
    program.wait_for(ENTER)
    program.wait_for(b"<resumed>")
    assert not program.attributes()[3] & termios.ICANON
    program.send(b"q")
    program.wait_for(LEAVE)
    program.wait_for(b"shell> ")
    program.send(b"exit\r")
    assert program.end() == 0


def test_a_wake_from_another_thread_ends_the_waiting(start):
    program = start(
        "import threading\n"
        "from layfigure_frontends.terminal.tty import PosixTerminal\n"
        "with PosixTerminal() as terminal:\n"
        "    threading.Timer(0.2, terminal.wake).start()\n"
        "    assert terminal.wait(60).data == b''\n"
    )
    assert program.end(20) == 0


def test_waiting_ends_when_its_time_has_passed(start):
    program = start(
        "from layfigure_frontends.terminal.tty import PosixTerminal\n"
        "with PosixTerminal() as terminal:\n"
        "    assert terminal.wait(0.05) == terminal.wait(0.0)\n"
    )
    assert program.end(20) == 0


def test_a_terminal_that_takes_nothing_blocks_neither_writing_nor_ending(start):
    program = start(
        "from layfigure_frontends.terminal.tty import PosixTerminal\n"
        "with PosixTerminal() as terminal:\n"
        "    terminal.write(b'x' * (1 << 20))\n"
        "    assert terminal.unwritten > 1 << 19\n"
        "    terminal.wait(0.1)\n"
    )
    assert program.process.wait(timeout=20) == 0
    assert program.attributes() == program.before


def test_what_was_not_taken_at_once_is_written_while_waiting(start):
    program = start(
        "from layfigure_frontends.terminal.tty import PosixTerminal\n"
        "with PosixTerminal() as terminal:\n"
        "    terminal.write(b'x' * (1 << 18) + b'<end>')\n"
        "    while not terminal.wait(None).drained: pass\n"
        "    assert not terminal.unwritten\n"
        "    while b'q' not in terminal.wait(None).data: pass\n"
    )
    assert program.wait_for(b"<end>").count(b"x") == 1 << 18
    program.send(b"q")
    assert program.end() == 0


def test_answers_still_under_way_at_the_end_do_not_reach_the_shell(start):
    program = start(ECHO.replace('write(b"<ready>")', r'write(b"<ready>\x1b[6n")'))
    program.wait_for(b"<ready>")
    program.send(b"q")
    program.wait_for(LEAVE)
    program.send(b"\x1b[1;1R")
    assert program.end() == 0
    os.set_blocking(program.theirs, False)
    termios.tcflow(program.theirs, termios.TCOON)
    program.send(b"\n")
    assert os.read(program.theirs, 100) == b"\n"


def test_after_a_kill_the_next_start_puts_the_terminal_right(start, tmp_path):
    program = start(f"import sys; sys.argv.append({str(tmp_path)!r})\n" + ECHO)
    program.wait_for(b"<ready>")
    (note,) = tmp_path.iterdir()
    program.process.kill()
    program.end()
    assert program.attributes() != program.before
    program.again(f"import sys; sys.argv.append({str(tmp_path)!r})\n" + ECHO)
    program.wait_for(b"<ready>")
    assert json.loads(note.read_text())["process"] == program.process.pid
    program.send(b"q")
    assert program.end() == 0
    assert_given_back(program)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("note", ["", "{}", "[]", '{"process": 1e99}', '{"process": 4194303, "attributes": [1]}'])
def test_a_damaged_note_counts_as_none(tmp_path, note):
    (tmp_path / "terminal-dev-x.json").write_text(note)
    assert Marker(tmp_path, "/dev/x").left_behind() is None


def test_the_note_of_a_running_program_is_left_alone(tmp_path, start):
    program = start()
    marker = Marker(tmp_path, "/dev/x")
    marker.put(program.before)
    note = tmp_path / "terminal-dev-x.json"
    stored = json.loads(note.read_text())
    note.write_text(json.dumps({**stored, "process": os.getppid()}))
    assert marker.left_behind() is None
    note.write_text(json.dumps({**stored, "process": 4194303}))
    assert marker.left_behind() == program.before


def test_a_folder_that_cannot_be_written_does_not_matter(start):
    marker = Marker(Path("/proc/nowhere"), "/dev/x")
    marker.put(start().before)
    marker.remove()
    assert marker.left_behind() is None


def test_without_a_terminal_a_sentence_says_so(capfd):
    from layfigure_frontends.terminal.driver import TerminalError, open_terminal

    with pytest.raises(TerminalError, match="--plain"):
        open_terminal()


@pytest.mark.skipif(os.name == "nt", reason="there it is at home")
def test_the_windows_driver_can_be_imported_elsewhere_and_says_that_it_is_not_at_home():
    from layfigure_frontends.terminal.driver import TerminalError
    from layfigure_frontends.terminal.windows_console import WindowsConsole

    with pytest.raises(TerminalError, match="no Windows console"):
        WindowsConsole()


def test_restoring_undoes_whatever_entering_does():
    switched_on = {part[:-1] for part in ENTER.split(b"\x1b[") if part.startswith(b"?") and part.endswith(b"h")}
    switched_off = {part[:-1] for part in restore_sequence().split(b"\x1b[") if part.endswith(b"l")}
    assert switched_on - {b"?25"} <= switched_off
    assert b"\x1b[?25h" in restore_sequence()
    assert b"\x1b[?7h" in restore_sequence()
