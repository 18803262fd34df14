import pygame
import pytest

from layfigure.session.events import DropEvent, KeyEvent, PointerEvent
from layfigure_frontends.sdl.translation import Translator, coalesced


class Clock:
    now = 0

    def __call__(self) -> int:
        return self.now


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def translator(clock):
    return Translator(clock)


def down(key, *, mod=0, text="", scancode=0):
    return pygame.Event(pygame.KEYDOWN, key=key, mod=mod, unicode=text, scancode=scancode)


def up(key, *, mod=0):
    return pygame.Event(pygame.KEYUP, key=key, mod=mod, unicode="", scancode=0)


def press(x, y, button=1):
    return pygame.Event(pygame.MOUSEBUTTONDOWN, pos=(x, y), button=button, touch=False)


def release(x, y, button=1):
    return pygame.Event(pygame.MOUSEBUTTONUP, pos=(x, y), button=button, touch=False)


def motion(x, y, buttons=(0, 0, 0)):
    return pygame.Event(pygame.MOUSEMOTION, pos=(x, y), rel=(0, 0), buttons=buttons, touch=False)


def heard(translator, *events, ratio=1.0, typing=False):
    return [meant for event in events for meant in translator.translate(event, ratio, typing=typing)]


def test_a_key_becomes_its_chord_and_what_it_would_type(translator):
    assert heard(translator, down(pygame.K_m, text="m")) == [KeyEvent("m", "m")]


def test_clicks_carry_the_modifiers_of_the_key_events_before_them(translator):
    (event,) = heard(translator, down(pygame.K_LCTRL, mod=pygame.KMOD_LCTRL), press(5, 6))
    assert event == PointerEvent("press", 5, 6, 1, ctrl=True)
    (event,) = heard(translator, up(pygame.K_LCTRL), release(5, 6))
    assert event == PointerEvent("release", 5, 6, 1)


def test_leaving_the_window_lets_go_of_modifiers(translator):
    heard(translator, down(pygame.K_LSHIFT, mod=pygame.KMOD_LSHIFT), pygame.Event(pygame.WINDOWFOCUSLOST))
    assert heard(translator, press(1, 1)) == [PointerEvent("press", 1, 1, 1)]


def test_pointer_positions_become_surface_pixels(translator):
    assert heard(translator, motion(30, 40, (0, 0, 1)), ratio=2.0) == [PointerEvent("move", 60, 80, 3)]


def test_a_second_press_soon_and_near_is_a_double_click_and_a_third_is_not(translator, clock):
    kinds = []
    for at in (0, 200, 300):
        clock.now = at
        kinds += [event.kind for event in heard(translator, press(10, 10), release(10, 10))]
    assert kinds == ["press", "release", "double", "release", "press", "release"]


@pytest.mark.parametrize(("later", "dx", "button"), [(401, 0, 1), (100, 5, 1), (100, 0, 3)])
def test_late_far_or_other_presses_are_not_double_clicks(translator, clock, later, dx, button):
    heard(translator, press(10, 10))
    clock.now = later
    assert heard(translator, press(10 + dx, 10, button))[0].kind == "press"


def test_the_wheel_comes_once_where_the_pointer_is(translator):
    wheel = pygame.Event(pygame.MOUSEWHEEL, x=0, y=-1, precise_x=0.0, precise_y=-1.5, flipped=False, touch=False)
    events = heard(translator, motion(7, 8), press(7, 8, 5), wheel)
    assert events[1:] == [PointerEvent("wheel", 7, 8, steps=-1.5)]


def test_a_held_command_key_runs_once_and_a_held_arrow_goes_on(translator):
    assert len(heard(translator, down(pygame.K_m), down(pygame.K_m), down(pygame.K_m))) == 1
    assert len(heard(translator, down(pygame.K_LEFT), down(pygame.K_LEFT), down(pygame.K_LEFT))) == 3
    assert len(heard(translator, up(pygame.K_m), down(pygame.K_m))) == 1


def test_while_text_is_typed_letters_come_from_text_input_only(translator):
    typed = pygame.Event(pygame.TEXTINPUT, text="é ")
    events = heard(translator, down(pygame.K_e, text="e"), typed, typing=True)
    assert events == [KeyEvent("é", "é"), KeyEvent("space", " ")]


def test_while_text_is_typed_editing_keys_and_chords_still_come(translator):
    events = heard(
        translator,
        down(pygame.K_BACKSPACE, text="\b"),
        down(pygame.K_RETURN, text="\r"),
        down(pygame.K_k, mod=pygame.KMOD_LCTRL, text="\x0b"),
        typing=True,
    )
    assert [event.key for event in events] == ["backspace", "enter", "ctrl+k"]


def test_text_input_means_nothing_while_no_text_is_typed(translator):
    assert heard(translator, pygame.Event(pygame.TEXTINPUT, text="m")) == []


def test_a_dropped_file_is_handed_on(translator):
    assert heard(translator, pygame.Event(pygame.DROPFILE, file="a.pose")) == [DropEvent("a.pose")]


def test_runs_of_moves_become_their_last_and_nothing_changes_place():
    events = [motion(1, 1), motion(2, 2), press(2, 2), motion(3, 3), motion(4, 4), motion(5, 5), release(5, 5)]
    kept = coalesced(events)
    assert [event.pos for event in kept] == [(2, 2), (2, 2), (5, 5), (5, 5)]
    assert [event.type for event in kept] == [
        pygame.MOUSEMOTION,
        pygame.MOUSEBUTTONDOWN,
        pygame.MOUSEMOTION,
        pygame.MOUSEBUTTONUP,
    ]


def shifted(translator, key, scancode, text=""):
    pressed = down(key, mod=pygame.KMOD_LSHIFT, text=text, scancode=scancode)
    (event,) = heard(translator, pressed, pygame.Event(pygame.KEYUP, key=key, mod=0, unicode="", scancode=scancode))
    return event


def test_a_digit_with_shift_tells_its_sign_also_where_the_window_system_keeps_it_to_itself(translator):
    assert shifted(translator, pygame.K_9, pygame.KSCAN_9) == KeyEvent("shift+9", "(")
    assert shifted(translator, pygame.K_9, pygame.KSCAN_9, ")") == KeyEvent("shift+9", ")"), "a German keyboard's"
    assert shifted(translator, pygame.K_AMPERSAND, pygame.KSCAN_1) == KeyEvent("shift+1"), "a French one types 1"


def test_a_sign_that_comes_again_as_text_is_not_told_twice(translator):
    pressed = down(pygame.K_9, mod=pygame.KMOD_LSHIFT, scancode=pygame.KSCAN_9)
    assert [event.text for event in heard(translator, pressed, typing=True)] == [""]
