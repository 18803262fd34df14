"""``layfigure plugins``: what is in service and what is wrong."""

from __future__ import annotations

import json

import click

from layfigure_frontends.opening import PluginChoice, open_host, plugin_options


@click.command("plugins")
@click.option("--json", "as_json", is_flag=True, help="As JSON, for programs.")
@plugin_options
def command(as_json: bool, choice: PluginChoice) -> int:
    """List techniques, renderers and the other things plug-ins bring, whose they are, and faults."""
    host = open_host(choice)
    kinds = {
        "techniques": host.techniques,
        "renderers": host.renderers,
        "solvers": host.solvers,
        "commands": host.commands,
        "keymaps": host.keymaps,
        "overlays": host.overlays,
        "figures": host.figures,
        "interpolations": host.interpolations,
    }
    if as_json:
        listing: dict[str, object] = {
            kind: [{"id": r.id, "title": r.title, "plugin": host.owner(r)} for r in records.values()]  # type: ignore[attr-defined]
            for kind, records in kinds.items()
        }
        listing["plugins"] = list(host.plugins)
        listing["faults"] = [{"plugin": f.plugin, "doing": f.doing, "sentence": f.sentence} for f in host.faults]
        click.echo(json.dumps(listing, indent=2))
        return 0
    for kind, records in kinds.items():
        for record in records.values():  # type: ignore[attr-defined]
            click.echo(f"{kind[:-1]:<14}{record.id:<16}{record.title}  ({host.owner(record)})")
    for fault in host.faults:
        click.echo(f"fault: {fault}", err=True)
    return 0
