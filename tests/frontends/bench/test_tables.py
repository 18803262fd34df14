"""Rows as tables: plain ones together, systems beside systems."""

from __future__ import annotations

from layfigure_frontends.bench.rows import Row, compared
from layfigure_frontends.bench.tables import markdown, tables

ROWS = [
    Row("drawing", "page", 0.82, "ms", "<= 0.6", "pygame", 3.4, 4.1),
    Row("ik", "solve", 5.0, "us", "<= 10", system="ours", measures={"success %": 100.0}, ratio=1.0),
    Row("ik", "solve", 60.04, "us", system="theirs", measures={"success %": 98.2, "outside": 0.0}, ratio=12.0),
    Row("ik", "peers", None, "", system="nobody", note="not installed"),
]


def test_each_work_that_systems_share_is_a_table_of_its_own():
    assert [table.title for table in tables(ROWS)] == ["drawing", "solve: target <= 10", "peers"]
    solve = tables(ROWS)[1]
    assert solve.headings == ("system", "median", "times ours", "success %", "outside", "note")
    assert solve.lines == (("ours", "5.00 us", "1.00", "100", "", ""), ("theirs", "60.0 us", "12.0", "98.2", "0", ""))


def test_values_are_told_as_multiples_of_ours_where_there_is_one():
    rows = [
        Row("ik", "solve", value, "us", system=name) for value, name in ((4.0, "ours"), (6.0, "theirs"), (None, "x"))
    ]
    assert [row.ratio for row in compared(rows, "ours")] == [1.0, 1.5, None]
    assert [row.ratio for row in compared(rows, "x")] == [None, None, None]


def test_markdown_leaves_empty_columns_out():
    text = markdown(ROWS)
    assert (
        "**solve: target <= 10**\n\n| system | median | times ours | success % | outside |\n|---|--:|--:|--:|--:|"
        in text
    )
    assert "| nobody | not installed |" in text and "| page | 0.820 ms | <= 0.6 | pygame 3.40 ms | 4.1 |" in text
