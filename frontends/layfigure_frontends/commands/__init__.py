"""The subcommands of `layfigure`, one module each."""
