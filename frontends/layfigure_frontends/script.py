"""Runs scripts for subcommands: the options that raise what one may do, and the plug-ins' interpolations."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

import click

from layfigure.language.limits import Limits
from layfigure_frontends.opening import PluginChoice, as_record, open_host

if TYPE_CHECKING:
    from layfigure.language.programme import Programme

_WORDS = {
    "steps": "statements and operations",
    "keys": "keys of one motion",
    "pictures": "pictures of all scenes",
    "actors": "figures in all pictures",
    "volumes": "volumes of all objects made",
    "digits": "digits of a number",
    "letters": "letters of a string",
    "loads": "files loaded and saved",
    "bytes": "bytes loaded and saved",
    "script": "letters of one script",
}

limit_options = as_record(
    "limits",
    Limits,
    *(
        click.option(
            f"--most-{field.name}",
            field.name,
            type=click.IntRange(1, 10**12),
            default=field.default,
            show_default=True,
            help=f"Let scripts go as far: {_WORDS[field.name]}.",
        )
        for field in fields(Limits)
        if field.name in _WORDS
    ),
    click.option("--outside", is_flag=True, help="Let scripts save outside their own folder."),
)


_NO_SCRIPTS = {
    ".motion": "a motion",
    ".pose": "a pose",
    ".poses": "a set of poses",
    ".log": "a session's log",
    ".fig": "a figure",
}


def run(script: Path, limits: Limits, choice: PluginChoice) -> Programme:
    """Return what a script, or the shipped one of that name, comes to.

    Its motions may name the interpolations of plug-ins.

    Raises:
        LayfigureError: it cannot be read, has a mistake, or does more than the limits allow.
    """
    from layfigure import resources
    from layfigure.errors import FileError
    from layfigure.language import run_script
    from layfigure.motions.standard import with_plugins

    kind = _NO_SCRIPTS.get(script.suffix.lower())
    if kind is not None:
        draws = "" if script.suffix.lower() == ".fig" else f", and layfigure render {script} draws it"
        raise FileError(f"{script}: is {kind}, not a script; layfigure check tells of it{draws}")
    return run_script(resources.found(script), limits, with_plugins(open_host(choice).interpolations))
