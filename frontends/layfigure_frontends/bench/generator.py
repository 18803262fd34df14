"""How fast a new page is there, and how soon a perfect user gets to a target."""

from __future__ import annotations

from collections.abc import Callable
from itertools import cycle

from layfigure.configuration import Configuration
from layfigure.drawing.render_list import new_target
from layfigure.plugins.host import Host
from layfigure.session.document import Document
from layfigure.session.figures import open_figure
from layfigure.session.frame import Size
from layfigure.session.session import Session
from layfigure_frontends.bench.rows import Row, median_seconds
from layfigure_frontends.opening import session_options

SIZE = Size(1280, 900)


def rows(quick: bool) -> list[Row]:
    """Return the generator's rows: M to a new offer, and M to a page drawn in memory."""
    host = Host.discover()
    options = session_options(host, Configuration(), "headless")
    session = Session(host, Document.new(open_figure(host, "humanoid")), options)
    session.execute("pick 4 spine rightthigh leftupperarm neck")
    target = new_target(SIZE.width, SIZE.height)
    intensities = cycle(range(20, 100))

    def mutate() -> None:
        session.execute(f"intensity {next(intensities)}")  # so that no alternatives are remembered from last time
        session.execute("mutate")

    def offer() -> None:
        mutate()
        session.offer()

    def page() -> None:
        mutate()
        session.draw(session.frame(SIZE), target)

    def cones() -> None:
        list(session.offer().cones())

    repeats = 20 if quick else 100
    found = [
        _row("M to nine new candidates", offer, repeats),
        _row("M to the new page in pixels, 1280x900", page, repeats, "<= 10"),
        _row("cones of the skeleton", cones, repeats, "<= 2"),
    ]
    session.execute("spread apart")
    found.append(_row("M to nine of 45 seen apart", offer, repeats))
    session.execute("spread ordered")
    for name in ("within-limits", "above-floor", "no-touching", "balanced"):
        session.execute(f"{name} on")
    found.append(_row("M to what passes all filters, of 90", offer, repeats))
    return found


def _row(work: str, run: Callable[[], None], repeats: int, target: str = "") -> Row:
    return Row("generator", work, median_seconds(run, repeats) * 1e3, "ms", target)
