"""``python -m layfigure_frontends`` is the ``layfigure`` command."""

from layfigure_frontends.command_line import main

if __name__ == "__main__":
    main()
