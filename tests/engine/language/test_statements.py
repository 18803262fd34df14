"""How scripts are written: lines, comments, case, blocks, and what is said of those that are not right."""

import pytest

from layfigure.errors import SourceError


def test_case_does_not_matter(printed):
    assert printed("X = 1\nprint x\nPrint X") == ["1", "1"]


def test_a_semicolon_parts_statements_of_a_line(printed):
    assert printed("a = 1; b = 2; PRINT a + b") == ["3"]


def test_comments_stand_in_braces_anywhere_and_over_lines(printed):
    assert printed("{one} a = {two\nthree} 1 {four}\nPRINT a") == ["1"]


def test_a_brace_in_a_string_is_no_comment(printed):
    assert printed('PRINT "{a}"') == ["{a}"]


@pytest.mark.parametrize("text", ["a = 1 +\n2", "a = (1\n+ 2)", "a = 1\n + 2", "a = (1 +\n\n{x}\n 2)"])
def test_a_statement_goes_on_over_lines_where_it_cannot_end(printed, text):
    assert printed(f"{text}\nPRINT a") == ["3"]


def test_an_asterisk_in_the_first_column_is_ignored(printed):
    assert printed("* a = 2\n*\n* PRINT a,\n*   a * 3") == ["2 6"]


def test_all_three_signs_assign(printed):
    assert printed("a = 1; b :- 2; c := 3; PRINT a, b, c") == ["1 2 3"]


def test_words_of_the_language_are_good_names_where_they_can_be_nothing_else(printed):
    text = "frame = 1; width = 2; box = 3; view = 4; at = 5; to = 6; load = 7; joint = 8; scale = 9\n"
    assert printed(text + "PRINT frame + width, box * view, at, to, load, joint, max(box, at, to), scale") == [
        "3 12 5 6 7 8 6 9"
    ]


def test_names_may_be_long_and_of_any_script(printed):
    name = "größe_" + "x" * 500
    assert printed(f"{name} = 1\nPRINT {name}") == ["1"]


def test_if_is_written_in_a_line_in_lines_or_with_begin(printed):
    text = """
    FOR n = 1 TO 3
      IF n = 1 THEN PRINT "one" ELSE IF n = 2 THEN PRINT "two" ELSE PRINT "many"
      IF n = 1 THEN
        PRINT "one"
      ELSE IF n = 2 THEN
        PRINT "two"
      ELSE
        PRINT "many"
      ENDIF
      IF n = 1 THEN
      BEGIN
        PRINT "one"; PRINT "still"
      END
      ELSE BEGIN PRINT "other" END
    ENDFOR
    """
    assert printed(text) == ["one", "one", "one", "still", "two", "two", "other", "many", "many", "other"]


def test_else_on_a_line_of_its_own_belongs_to_the_if_of_lines_around_it(printed):
    assert printed("IF FALSE THEN\nIF TRUE THEN PRINT 1\nELSE\nPRINT 2\nENDIF") == ["2"]


def test_else_may_follow_an_if_of_one_line_on_the_next(printed):
    assert printed("IF 1 > 2 THEN PRINT 1\nELSE PRINT 2") == ["2"]


def test_loops_count_up_and_down_and_by_fractions(printed):
    text = "FOR x = 1 TO 2 STEP 1/2\nPRINT x\nENDFOR\nDO i = 3, 1, -1\nPRINT i\nENDDO\nFOR j = 2 TO 1\nPRINT j\nENDFOR"
    assert printed(text) == ["1", "1.5", "2", "3", "2", "1"]


def test_one_continue_closes_all_loops_of_its_label(printed):
    assert printed("DO 10 i = 1,2\nDO 10 j = 1,2\nPRINT i, j\n10 CONTINUE\nPRINT 9") == [
        "1 1",
        "1 2",
        "2 1",
        "2 2",
        "9",
    ]


def test_while_runs_as_long_as_its_condition_holds(printed):
    assert printed("n = 3\nWHILE n > 0\nn = n - 1\nENDWHILE\nPRINT n") == ["0"]


def test_stop_ends_the_run_and_end_the_script(printed):
    assert printed("PRINT 1\nSTOP\nPRINT 2\nEND\n") == ["1"]


@pytest.mark.parametrize(
    ("text", "place", "says"),
    [
        ("PRNT 3", "1:1", 'no statement begins with "PRNT"; did you mean "PRINT"?'),
        ("x = ", "1:4", "found the end of the file where a value should stand"),
        ("x = 1\ny = )", "2:5", 'this ")" closes nothing'),
        ("x = (1,\ny = 2", "1:5", 'this "(" is not closed'),
        ("x = (1]", "1:7", 'needs its ")"'),
        ("x = 1 y = 2", "1:7", "a statement begins before the last one ended"),
        ("x = 1 2", "1:7", 'found "2" where an operator or the end of the statement should stand'),
        ("x = 12abc", "1:7", 'found "abc" where an operator or the end of the statement should stand'),
        ("x = 1, 2", "1:6", "the end of the statement should stand"),
        ("x = 1 @ 2", "1:7", 'found "@"'),
        ('x = "abc\ny = 1', "1:5", "is not closed in its line"),
        ("{ never", "1:1", "is not closed"),
        ("IF 1 = 1 THEN\nPRINT 1", "2:8", "the script ends while the IF of line 1 is open; add ENDIF"),
        ("FOR i = 1 TO 3\nENDIF", "2:1", "found ENDIF while the FOR of line 1 is open"),
        ("DO 10 i = 1, 3\n20 CONTINUE", "2:12", "add 10 CONTINUE"),
        ("ENDWHILE", "1:1", "a WHILE is not open"),
        ("END\nx = 1", "2:1", "nothing may follow END"),
        ("x = BOX WIDTH 1, HIGHT 2", "1:16", 'found ","'),
        ("x = a <SCALE FRMS 2>", "1:19", 'found "2"'),
        ("INITIALIZE SCENE 1\nSTARTSCENE LENGTH 3\nANIMATE h FRM 0 TO 2 USING a\nENDSCENE", "3:11", 'mean "FROM"'),
        ("INITIALIZE SCENE 1\nANIMATE h USING a\nSTARTSCENE LENGTH 3\nENDSCENE", "2:1", "in the body of a scene"),
        ("x = 1\nSTARTSCENE LENGTH 3\nENDSCENE\nSHOOTSCENES", "2:1", "put INITIALIZE SCENE and a number before it"),
        ("x = 1\nELSE IF x = 1 THEN x = 2", "2:1", "found ELSE IF, but an IF that it could belong to is not open"),
        ("VIEW WIDTH = 3", "1:1", "stands in a scene"),
        ("INITIALIZE SCENE 1\nENDSCENE", "2:1", "STARTSCENE"),
        ("STARTMODEL a\nx = 1\nENDMODEL", "2:1", "stand only JOINT"),
        ("STARTMOTION a\nFRAME 2 POSITION 1,2,3\nENDMOTION", "2:1", "belongs to no joint"),
        ("JOINT 1 POSITION 1,2,3", "1:1", "between STARTMOTION and ENDMOTION"),
    ],
)
def test_what_is_wrong_is_said_in_one_sentence_at_its_place(run, text, place, says):
    with pytest.raises(SourceError) as wrong:
        run(text)
    sentence = str(wrong.value)
    assert f"script.lay:{place}: " in sentence
    assert says in sentence
    assert "\n" not in sentence


@pytest.mark.parametrize("text", ["x = " + "(" * 10000 + "1" + ")" * 10000 + "\nPRINT x"])
def test_any_number_of_brackets_is_read(printed, text):
    assert printed(text) == ["1"]


@pytest.mark.parametrize(
    "text",
    [
        "x = " + "-" * 10000 + "1",
        "x = " + "f(" * 10000 + "1" + ")" * 10000,
        "x = " + "(1," * 5000 + "1" + ")" * 5000,
        "x = 1" + " ** 1" * 7000,
        "IF 1 = 1 THEN\n" * 2000,
        "IF 1 = 1 THEN " * 2000 + "x = 1",
        "x = " + "NOT " * 9000 + "TRUE",
        "x = a" + " <SCALE 1>" * 3000,
    ],
    ids=["signs", "calls", "vectors", "powers", "blocks", "lines", "nots", "modifiers"],
)
def test_nesting_is_bounded_and_told(run, text):
    with pytest.raises(SourceError, match="nested deeper than 100"):
        run(text)


def test_what_a_script_prints_cannot_command_a_terminal(printed):
    assert printed('PRINT "a\x1b[2J\x9bH\x7f\u202eé"') == [r"a\x1b[2J\x9bH\x7f\u202eé"]


def test_mistakes_that_quote_a_script_cannot_command_a_terminal(run):
    with pytest.raises(SourceError) as error:
        run('LOAD "\x1b[2J"')
    assert "\x1b" not in str(error.value) and r"\x1b[2J" in str(error.value)
