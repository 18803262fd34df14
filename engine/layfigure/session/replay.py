"""Opens sessions and plays logs: the part of the program that needs no front end at all."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from layfigure.errors import LayfigureError, SourceError
from layfigure.plugins.host import Host
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.log import SessionLog
from layfigure.session.session import Session, SessionOptions
from layfigure.session.words import WordError


def open_log(host: Host, log: SessionLog, options: SessionOptions) -> Session:
    """Return a session that stands where a log begins.

    Raises:
        SourceError: the log's figure or technique is not to be had.
    """
    try:
        figure = open_figure(host, _beside(log, log.figure))
    except SourceError:
        raise
    except LayfigureError as error:
        raise SourceError(log.source, log.figure_line, len("figure ") + 1, str(error)) from None
    if log.technique not in host.techniques:
        known = ", ".join(host.techniques) or "none"
        message = f'there is no technique "{log.technique}"; in service: {known}'
        raise SourceError(log.source, log.technique_line, len("technique ") + 1, message)
    return Session(host, Document.new(figure), replace(options, technique=log.technique))


def play(session: Session, log: SessionLog) -> None:
    """Run the commands of a log. Logs come from strangers, so only what a session would log is run.

    Raises:
        SourceError: a command is unknown, wrong, impossible where it stands or none that is logged; the session stands
            before it.
    """
    solvers = session.workshop.solvers
    waited, solvers.waits = solvers.waits, True
    try:
        _play(session, log)
    finally:
        solvers.waits = waited


def _play(session: Session, log: SessionLog) -> None:
    for entry in log.commands:
        try:
            _check_logged(session, entry.command.name)
            session.execute(entry.text)
        except WordError as error:
            columns = entry.command.columns
            end = len(entry.text.rstrip()) + 1
            column = columns[error.index] if error.index < len(columns) else end
            raise SourceError(log.source, entry.line, column, str(error)) from None
        except SourceError:
            raise
        except LayfigureError as error:
            raise SourceError(log.source, entry.line, entry.command.columns[0], str(error)) from None


def _check_logged(session: Session, name: str) -> None:
    """Refuse a command that writes files, runs code or steers the interface: no session puts it into its log."""
    command = session.commands().get(name)
    if command is not None and not command.logged:
        raise WordError(0, f'"{name}" does not belong in a log, which holds only what changes the document; remove it')


def _beside(log: SessionLog, figure: str) -> str:
    """A figure file named in a log lies beside the log, unless it is found from here."""
    path = Path(figure)
    beside = Path(log.source).parent / path
    return str(beside) if path.suffix == ".fig" and not path.is_file() and beside.is_file() else figure
