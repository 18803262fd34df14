"""Numbers, vectors, strings and truth: exact, bounded, and of one kind each."""

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.errors import SourceError
from layfigure.language.evaluating import Evaluator
from layfigure.language.limits import Limits, Meter
from layfigure.language.parsing import parse_script
from layfigure.language.scope import Scope

numbers = st.fractions(min_value=-1000, max_value=1000, max_denominator=1000)


def value(expression: str) -> object:
    """Return the value of an expression."""
    meter = Meter(Limits())
    (statement,) = parse_script(f"x = {expression}", "x.lay", meter)
    return Evaluator(Scope(), meter).value(statement.value)


def spelled(number: Fraction) -> str:
    """Return an expression for a fraction."""
    return f"({number.numerator}/{number.denominator})"


@settings(max_examples=50, deadline=None)
@given(a=numbers, b=numbers, c=numbers)
def test_arithmetic_is_exact(a, b, c):
    assert value(f"{spelled(a)} + {spelled(b)} * {spelled(c)} - {spelled(b)}") == a + b * c - b


@settings(max_examples=50, deadline=None)
@given(a=numbers, b=numbers.filter(bool))
def test_division_and_mod_belong_together(a, b):
    assert value(f"{spelled(a)} / {spelled(b)} * {spelled(b)}") == a
    remainder = value(f"{spelled(a)} MOD {spelled(b)}")
    assert remainder == a - b * (a // b)
    assert abs(remainder) < abs(b)


@settings(max_examples=50, deadline=None)
@given(a=numbers, b=numbers)
def test_comparisons_agree_with_each_other(a, b):
    left, right = spelled(a), spelled(b)
    assert value(f"{left} < {right}") is (a < b)
    assert value(f"{left} >= {right}") is value(f"NOT {left} < {right}")
    assert value(f"{left} <> {right}") is value(f"{left} < {right} OR {left} > {right}")


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("0.1 + 0.2", Fraction(3, 10)),
        ("1e3", 1000),
        ("2.50e-1", Fraction(1, 4)),
        ("90°", 90),
        ("-2 ** 2", -4),
        ("2 ** 3 ** 2", 512),
        ("2 ** -2", Fraction(1, 4)),
        ("7 - 2 - 1", 4),
        ("1 + 2 * 3", 7),
        ("2 * (1, 2, 3)", (2, 4, 6)),
        ("(1, 2) + (3, 4) - (1, 1)", (3, 5)),
        ("(2, 4, 6) / 2", (1, 2, 3)),
        ("-(1, -2, 0)", (-1, 2, 0)),
        ('"a" + "b"', "ab"),
        ("TRUE AND NOT FALSE OR FALSE", True),
        ("1 = 1 AND 2 = 2", True),
        ("(1, 2) = (1, 2)", True),
        ("sin(30) + cos(60)", 1),
        ("sin(180)", 0),
        ("atan(1, -1)", 135),
        ("sqrt(4/9)", Fraction(2, 3)),
        ("sqrt(2)", Fraction("1.414213562373")),
        ("round(2.5) + round(-2.5)", 0),
        ("round(1/3, 2)", Fraction("0.33")),
        ("floor(-1.5) + ceil(1.2) + abs(-3) + sign(-9)", 2),
        ("min(3, 1, 2) + max(3, 1, 2)", 4),
        ("x((1, 2, 3)) + y((1, 2, 3)) + z((1, 2, 3))", 6),
        ("cross((1, 0, 0), (0, 1, 0))", (0, 0, 1)),
        ("dot((1, 2, 3), (4, 5, 6))", 32),
        ("length((3, 4, 0))", 5),
        ('text(1/3) + ","', "1/3,"),
    ],
)
def test_what_expressions_are(expression, expected):
    assert value(expression) == expected


def test_and_and_or_stop_where_the_answer_is_known():
    assert value("FALSE AND 1 / 0 = 1") is False
    assert value("TRUE OR 1 / 0 = 1") is True


@pytest.mark.parametrize(
    ("expression", "says"),
    [
        ("1 / 0", "division by 0"),
        ("1 MOD 0", "MOD 0"),
        ("0 ** -1", "division by 0"),
        ("(-1) ** 0.5", "no power that is not whole"),
        ("1 + (1, 2)", r"\+ cannot join a number and a vector of 2 numbers"),
        ("(1, 2) + (1, 2, 3)", "cannot join"),
        ("TRUE + 1", "cannot join"),
        ('1 < "a"', "have no order"),
        ('1 = "a"', "cannot be compared"),
        ("NOT 1", "must be TRUE or FALSE"),
        ("1 AND TRUE", "each side of AND"),
        ('-"a"', "has no sign"),
        ("nothing", 'nothing is called "nothing"'),
        ("sine(3)", 'there is no function "sine"; did you mean "sin"'),
        ("sin(1, 2)", r"sin\(degrees\) was given 2 arguments"),
        ('sin("a")', "argument 1 of sin must be a number, but is a string"),
        ("asin(2)", "a number from -1 to 1"),
        ("sqrt(-1)", "0 or more"),
        ("exp(10000)", "too large|not a finite"),
        ("9" * 400, "more than 300 digits"),
        ("1e400", "more than 300 digits"),
        ("1e-99999999999999999999", "more than 300 digits"),
        ("10 ** 10 ** 10", "more than 300 digits"),
        ("(1/3) ** 100000000", "more than 300 digits"),
        ("JOINT 1, 2", "this JOINT has 2 parts"),
    ],
)
def test_what_makes_no_sense_is_told(expression, says):
    with pytest.raises(SourceError, match=says):
        value(expression)


def test_a_declared_name_holds_its_kind_only(run):
    run("REAL a; VECTOR b; INTEGER n; a = 1/2; b = (1, 2, 3); n = 3")
    with pytest.raises(SourceError, match=r':2:1: "a" was declared in line 1 to hold a number, not a vector'):
        run("REAL a\na = (1, 2, 3)")
    with pytest.raises(SourceError, match="a whole number"):
        run("INTEGER n\nn = 1/2")
    with pytest.raises(SourceError, match="was declared as REAL in line 1"):
        run("REAL a\nMOTION a")


def test_a_misspelt_name_gets_the_nearest(run):
    with pytest.raises(SourceError, match='nothing is called "angel"; did you mean "Angle"'):
        run("Angle = 3\nPRINT angel")


def test_a_declared_name_without_a_value_is_told(run):
    with pytest.raises(SourceError, match='"a" has no value yet'):
        run("REAL a\nPRINT a")
