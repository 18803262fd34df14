"""Hook layfigure_interpolations: a stranger's way from key to key is kept under its id."""

from layfigure.plugins.hookspecs import hookimpl
from layfigure.plugins.records import Interpolation
from layfigure.testing import make_host


class Bringing:
    @hookimpl
    def layfigure_interpolations(self):
        return [Interpolation("smooth", "Smooth", lambda u: u * u * (3 - 2 * u))]


def test_an_interpolation_is_in_service_and_goes_from_0_to_1():
    host = make_host(Bringing())
    ease = host.interpolations["smooth"].ease
    assert (ease(0.0), ease(0.5), ease(1.0)) == (0.0, 0.5, 1.0)
    assert host.owner(host.interpolations["smooth"]) == "Bringing"
