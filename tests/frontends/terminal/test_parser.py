"""Whatever a terminal sends, however it is cut, becomes the same events; garbage is dropped and never sticks."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from layfigure.session.events import KeyEvent, PointerEvent
from layfigure_frontends.terminal import parser as limits
from layfigure_frontends.terminal.parser import Parser
from layfigure_frontends.terminal.pointer import CELLS, HALF_BLOCKS, Scale, coalesced
from layfigure_frontends.terminal.replies import (
    CellSize,
    ColourRegisters,
    CursorReport,
    DeviceAttributes,
    Focus,
    GraphicsReply,
    KeyboardFlags,
    ModeReport,
    Paste,
    Resize,
    TerminalName,
)

KEYS = {
    b"a": ("a", "a"),
    b"M": ("shift+m", "M"),
    b"5": ("5", "5"),
    b"?": ("?", "?"),
    b"+": ("+", "+"),
    b" ": ("space", " "),
    "é".encode(): ("é", "é"),
    "É".encode(): ("shift+é", "É"),
    "€".encode(): ("€", "€"),
    "🙂".encode(): ("🙂", "🙂"),
    b"\r": ("enter", ""),
    b"\n": ("ctrl+j", ""),
    b"\t": ("tab", ""),
    b"\x08": ("backspace", ""),
    b"\x7f": ("backspace", ""),
    b"\x1a": ("ctrl+z", ""),
    b"\x19": ("ctrl+y", ""),
    b"\x03": ("ctrl+c", ""),
    b"\x0b": ("ctrl+k", ""),
    b"\x00": ("ctrl+space", ""),
    b"\x1c": ("ctrl+\\", ""),
    b"\x1d": ("ctrl+]", ""),
    b"\x1f": ("ctrl+_", ""),
    b"\x1ba": ("alt+a", ""),
    b"\x1bA": ("alt+shift+a", ""),
    b"\x1b\x1a": ("ctrl+alt+z", ""),
    b"\x1b\x7f": ("alt+backspace", ""),
    "\x1bé".encode(): ("alt+é", ""),
    b"\x1b[A": ("up", ""),
    b"\x1b[1;5D": ("ctrl+left", ""),
    b"\x1b[1;2C": ("shift+right", ""),
    b"\x1b[1;8B": ("ctrl+alt+shift+down", ""),
    b"\x1bOA": ("up", ""),
    b"\x1bOH": ("home", ""),
    b"\x1bOP": ("f1", ""),
    b"\x1bO5P": ("ctrl+f1", ""),
    b"\x1bOR": ("f3", ""),
    b"\x1b[R": ("f3", ""),
    b"\x1b[S": ("f4", ""),
    b"\x1bOq": ("kp1", "1"),
    b"\x1bOk": ("+", "+"),
    b"\x1bOM": ("enter", ""),
    b"\x1b[[A": ("f1", ""),
    b"\x1b[11~": ("f1", ""),
    b"\x1b[24~": ("f12", ""),
    b"\x1b[3~": ("delete", ""),
    b"\x1b[5;5~": ("ctrl+pageup", ""),
    b"\x1b[6~": ("pagedown", ""),
    b"\x1b[7~": ("home", ""),
    b"\x1b[3^": ("ctrl+delete", ""),
    b"\x1b[a": ("shift+up", ""),
    b"\x1bOd": ("ctrl+left", ""),
    b"\x1b[Z": ("shift+tab", ""),
    b"\x1b[122;5u": ("ctrl+z", ""),
    b"\x1b[122;6u": ("ctrl+shift+z", ""),
    b"\x1b[97;2u": ("shift+a", "A"),
    b"\x1b[49:33;6u": ("ctrl+!", ""),
    b"\x1b[27u": ("escape", ""),
    b"\x1b[13;2u": ("shift+enter", ""),
    b"\x1b[53;5u": ("ctrl+5", ""),
    b"\x1b[57400u": ("kp1", "1"),
    b"\x1b[57413u": ("+", "+"),
    b"\x1b[110;1:1u": ("n", "n"),
    b"\x1b[110;1:2u": ("n", "n"),
    b"\x1b[27;6;90~": ("ctrl+shift+z", ""),
    b"\x1b[27;5;9~": ("ctrl+tab", ""),
}

REPLIES = {
    b"\x1b[?62;4;22c": DeviceAttributes((62, 4, 22)),
    b"\x1b[12;40R": CursorReport(12, 40),
    b"\x1b_Gi=31;OK\x1b\\": GraphicsReply(31, True),
    b"\x1b_Gi=31;ENOENT:no\x1b\\": GraphicsReply(31, False),
    b"\x1b[?2026;2$y": ModeReport(2026, 2),
    b"\x1b[?1u": KeyboardFlags(1),
    b"\x1b[?1;0;256S": ColourRegisters(256),
    b"\x1b[6;16;8t": CellSize(8, 16),
    b"\x1b[48;50;160;800;1280t": Resize(160, 50),
    b"\x1bP>|XTerm(379)\x1b\\": TerminalName("XTerm(379)"),
    b"\x1bP>|kitty\x07": TerminalName("kitty"),
    b"\x1b[I": Focus(True),
    b"\x1b[O": Focus(False),
    b"\x1b[200~two\r\nlines\x1b[31m\x1b[201~": Paste("two\nlines[31m"),
    b"\x1b[200~\x1b[201~": Paste(""),
}

POINTER = {
    b"\x1b[<0;5;3M": PointerEvent("press", 4, 2, 1),
    b"\x1b[<0;5;3m": PointerEvent("release", 4, 2, 1),
    b"\x1b[<2;1;1M": PointerEvent("press", 0, 0, 3),
    b"\x1b[<34;1;2M": PointerEvent("move", 0, 1, 3),
    b"\x1b[<35;1;2M": PointerEvent("move", 0, 1, 0),
    b"\x1b[<16;300;2M": PointerEvent("press", 299, 1, 1, ctrl=True),
    b"\x1b[<48;3;2M": PointerEvent("move", 2, 1, 1, ctrl=True),
    b"\x1b[<12;3;2M": PointerEvent("press", 2, 1, 1, shift=True, alt=True),
    b"\x1b[<64;3;2M": PointerEvent("wheel", 2, 1, steps=1.0),
    b"\x1b[<81;3;2M": PointerEvent("wheel", 2, 1, ctrl=True, steps=-1.0),
    b"\x1b[M !!": PointerEvent("press", 0, 0, 1),
    b"\x1b[32;3;2M": PointerEvent("press", 2, 1, 1),
}

NOTHING = [
    *(b"\x1b[110;1:3u", b"\x1b[57441u", b"\x1b[99999999999u", b"\x1b[1;5:3A", b"\x1b[55296u"),
    *(b"\x1b[<66;3;2M", b"\x1b[<128;3;2M", b"\x1b[201~", b"\x1b[999~", b"\x1b[1;2;3;4X", b"\x1b[=1;2c"),
    *(b"\x1b]11;rgb:0000/0000/0000\x07", b"\x1b]4;1;rgb:00/00/00\x1b\\", b"\x1bP1$r0m\x1b\\", b"\x1b_Xother\x1b\\"),
    *(b"\x1bOz", b"\xff", b"\xc3\xff", b"\xe2\x82\xff", b"\xed\xa0\x80", b"\xf8", b"\x9b"),
]

STREAM = b"".join([*KEYS, *POINTER, *REPLIES, *NOTHING])
FRAGMENTS = [*KEYS, *POINTER, *REPLIES, *NOTHING, b"\x1b", b"\x1b[", b"\x1b_G", b"\x1b]", b"\x1bP", b"\xe2", b"\x1b[M"]


def events_of(data, scale=CELLS):
    return Parser(scale).feed(data, 0.0)


@pytest.mark.parametrize(("data", "key"), KEYS.items(), ids=repr)
def test_a_key_gets_its_name_and_the_text_it_types(data, key):
    assert events_of(data) == [KeyEvent(*key)]


@pytest.mark.parametrize(("data", "reply"), REPLIES.items(), ids=repr)
def test_an_answer_becomes_a_record(data, reply):
    assert events_of(data) == [reply]


@pytest.mark.parametrize(("data", "event"), POINTER.items(), ids=repr)
def test_a_mouse_report_becomes_a_pointer_event_in_cells(data, event):
    assert events_of(data) == [event]


@pytest.mark.parametrize("data", NOTHING, ids=repr)
def test_what_means_nothing_to_us_is_dropped_whole(data):
    parser = Parser()
    assert parser.feed(data + b"a", 0.0) == [KeyEvent("a", "a")]
    assert parser.seconds_left(0.0) is None


def test_places_are_told_in_half_blocks_or_pixels_where_that_is_wanted():
    (event,) = events_of(b"\x1b[<0;5;3M", HALF_BLOCKS)
    assert (event.x, event.y) == (4, 4)
    (event,) = events_of(b"\x1b[<0;5;3M", Scale(8, 16))
    assert (event.x, event.y) == (4 * 8 + 3, 2 * 16 + 7)


def test_a_second_press_soon_and_near_is_a_double_click_and_a_third_is_not():
    parser = Parser(CELLS)
    press, release = b"\x1b[<0;5;3M", b"\x1b[<0;5;3m"
    kinds = [event.kind for now in (0.0, 0.2, 0.3, 0.9) for event in parser.feed(press + release, now)]
    assert kinds == ["press", "release", "double", "release", "press", "release", "press", "release"]


@pytest.mark.parametrize("second", [b"\x1b[<2;5;3M", b"\x1b[<0;9;3M"])
def test_another_button_or_another_place_makes_no_double_click(second):
    assert [event.kind for event in events_of(b"\x1b[<0;5;3M" + second)] == ["press", "press"]


def test_of_many_moves_in_a_row_only_the_last_is_kept():
    moves = b"".join(b"\x1b[<32;%d;3M" % x for x in range(1, 9))
    events = coalesced(events_of(moves + b"a" + moves))
    assert [getattr(event, "x", None) for event in events] == [7, None, 7]


@given(st.data())
@settings(max_examples=300)
def test_any_split_of_the_stream_gives_the_same_events(data):
    stream = b"".join(data.draw(st.lists(st.sampled_from(FRAGMENTS), max_size=30)))
    cuts = sorted(data.draw(st.lists(st.integers(0, len(stream)), max_size=12)))
    parser, events = Parser(), []
    for begin, end in zip([0, *cuts], [*cuts, len(stream)], strict=True):
        events += parser.feed(stream[begin:end], 0.0)
    assert events == Parser().feed(stream, 0.0)


def test_the_whole_stream_byte_by_byte_gives_the_same_events():
    parser = Parser()
    assert [event for byte in STREAM for event in parser.feed(bytes([byte]), 0.0)] == Parser().feed(STREAM, 0.0)


GARBAGE = st.one_of(
    st.binary(max_size=60),
    st.lists(st.sampled_from([*FRAGMENTS, b"\x1b", b"[", b";", b"<", b"_", b"\\", b"~", b"M", b"0"]), max_size=20).map(
        b"".join
    ),
)


@given(GARBAGE)
@settings(max_examples=500)
def test_after_any_garbage_a_key_is_a_key_again_within_a_bounded_number_of_bytes(garbage):
    parser = Parser()
    parser.feed(garbage.replace(b"\x1b[200~", b""), 0.0)
    typed = parser.feed(b"a" * (limits.LONGEST_STRING + 1), 0.0)
    if parser._pasted is None:
        assert typed[-1:] == [KeyEvent("a", "a")]
        assert parser.seconds_left(0.0) is None
    else:  # garbage can put the beginning of a paste together
        assert isinstance(parser.feed(b"\x1b[201~", 0.0)[-1], Paste)


@given(GARBAGE)
@settings(max_examples=300)
def test_after_any_garbage_and_a_little_time_the_very_next_key_is_a_key(garbage):
    parser = Parser()
    parser.feed(garbage, 0.0)
    parser.expire(parser.seconds_left(0.0) or 0.0)
    assert parser.seconds_left(0.0) is None
    assert parser.feed(b"a", 9.0) == [KeyEvent("a", "a")]


def test_a_paste_that_never_ends_is_given_up_at_a_length():
    parser = Parser()
    parser.feed(b"\x1b[200~", 0.0)
    paste, *keys = parser.feed(b"x" * limits.LONGEST_PASTE + b"a" * 9, 0.0)
    assert len(paste.text) == limits.LONGEST_PASTE
    assert keys == [KeyEvent("a", "a")] * 9


def test_a_long_paste_in_pieces_arrives_whole():
    parser, text = Parser(), "figure " * 20000
    stream = b"\x1b[200~" + text.encode() + b"\x1b[201~"
    events = [event for at in range(0, len(stream), 997) for event in parser.feed(stream[at : at + 997], 0.0)]
    assert events == [Paste(text)]


def test_a_lone_escape_is_decided_when_its_time_has_passed():
    parser = Parser()
    assert parser.feed(b"\x1b", 10.0) == []
    assert parser.seconds_left(10.01) == pytest.approx(0.02)
    assert parser.expire(10.01) == []
    assert parser.expire(10.04) == [KeyEvent("escape")]
    assert parser.seconds_left(10.04) is None


def test_escape_twice_is_two_escapes():
    parser = Parser()
    assert parser.feed(b"\x1b\x1b", 0.0) + parser.expire(0.1) == [KeyEvent("escape")] * 2


@pytest.mark.parametrize("letter", "[OP]_^X")
def test_alt_and_what_else_begins_a_sequence_is_decided_by_time_too(letter):
    parser = Parser()
    assert parser.feed(b"\x1b" + letter.encode(), 0.0) == []
    (event,) = parser.expire(0.1)
    assert event.key in (f"alt+{letter}", f"alt+shift+{letter.lower()}")


def test_control_z_breaks_off_a_stuck_sequence_and_still_counts():
    for stuck in (b"\x1b[12;", b"\x1b_Gi=31", b"\x1b]0;title", b"\x1bO", b"\x1b[M", b"\xe2\x82"):
        assert Parser().feed(stuck + b"\x1a", 0.0) == [KeyEvent("ctrl+z")]
