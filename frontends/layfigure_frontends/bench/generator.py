"""How fast a new page is there, and how soon a perfect user gets to a target."""

from __future__ import annotations

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

    def offer() -> None:
        session.execute("mutate")
        session.offer()

    def page() -> None:
        session.execute("mutate")
        session.draw(session.frame(SIZE), target)

    repeats = 20 if quick else 100
    return [
        Row("generator", "M to nine new candidates", median_seconds(offer, repeats) * 1e3, "ms"),
        Row("generator", "M to the new page in pixels, 1280x900", median_seconds(page, repeats) * 1e3, "ms", "<= 10"),
    ]
