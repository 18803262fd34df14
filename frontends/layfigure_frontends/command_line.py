"""The ``layfigure`` command. Light: what a subcommand needs is imported when it runs."""

from __future__ import annotations

import importlib
import os
import signal
import sys
import threading
from types import FrameType
from typing import TextIO

import click

from layfigure import __version__
from layfigure.errors import LayfigureError
from layfigure_frontends.mistakes import told

_COMMANDS = {
    "pose": "Pose a figure: the main job (the default).",
    "replay": "Play a session log without a window.",
    "describe": "Say a pose in words.",
    "diff": "Say what sets two poses apart, in words and numbers.",
    "render": "Draw poses, motions and scripts as pictures and films.",
    "breathe": "Write small variants of a pose as a set or a loop.",
    "figure": "Tell about figures.",
    "run": "Run a script: what it prints and saves, without its pictures.",
    "check": "Say whether a file is right: a figure, poses, a log, a motion, a script.",
    "plugins": "List plug-ins and what is wrong with them.",
    "bench": "Measure speed and memory.",
    "warm": "Compile the drawing code now rather than at the first start.",
}

EPILOG = """\b
Examples:
  layfigure                        pose the humanoid
  layfigure horse                  pose another figure
  layfigure my.pose                go on with a pose
  layfigure --plain                pose by typed lines: for screen readers, dumb terminals and pipes
  layfigure render my.pose -o my.png
  layfigure diff before.pose after.pose
  layfigure breathe my.pose -o loop.gif
  layfigure figure info humanoid --json
"""


class LazyGroup(click.Group):
    """A group that imports a subcommand when it is asked for, and takes anything unknown as ``pose``'s words."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return the names of the subcommands."""
        return list(_COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Return a subcommand, imported now."""
        if cmd_name not in _COMMANDS:
            return None
        command = importlib.import_module(f"layfigure_frontends.commands.{cmd_name}").command
        assert isinstance(command, click.Command)
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of subcommands without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(_COMMANDS.items()))

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Put ``pose`` before words that do not begin with a subcommand."""
        own = {"-h", "--help", "-V", "--version"}
        if not args or (args[0] not in _COMMANDS and args[0] not in own):
            args = ["pose", *args]
        return super().parse_args(ctx, args)


@click.group(
    cls=LazyGroup,
    epilog=EPILOG,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)
@click.version_option(__version__, "-V", "--version", prog_name="layfigure")
def layfigure() -> None:
    """Pose articulated figures by choosing among candidates, by key or click."""


def main() -> None:
    """Run the command line; a user's mistake is one sentence on standard error and exit status 2."""
    _end_in_good_order()
    try:
        status = layfigure.main(standalone_mode=False)
    except LayfigureError as error:
        _fail(told(error))
    except click.ClickException as error:
        _fail(f"{error.format_message()} (layfigure --help shows what there is)")
    except (click.Abort, KeyboardInterrupt):
        sys.exit(130)
    except BrokenPipeError:
        _mute(sys.stdout)
        sys.exit(1)
    except OSError as error:
        if error.filename is not None:
            raise  # not the output, which has no name
        _mute(sys.stdout)
        _fail(f"the output cannot be written ({error.strerror or error})")
    sys.exit(status if isinstance(status, int) else 0)


def _end_in_good_order() -> None:
    """Let signals that ask for an end clean up as Ctrl-C does; one that is ignored, as under nohup, stays so."""
    if threading.current_thread() is not threading.main_thread():
        return
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, _end)


def _end(number: int, frame: FrameType | None) -> None:
    del frame
    signal.signal(number, signal.SIG_IGN)  # it may come twice, to the process and to its group: clean up once, whole
    sys.exit(128 + number)


def _fail(sentence: str) -> None:
    try:
        click.echo(f"layfigure: {' '.join(sentence.split())}", err=True)
    except OSError:
        _mute(sys.stderr)  # nobody can be told
    sys.exit(2)


def _mute(stream: TextIO | None) -> None:
    """Let what is left in a stream go nowhere, so that the interpreter does not stumble over it at its end."""
    if stream is not None:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
