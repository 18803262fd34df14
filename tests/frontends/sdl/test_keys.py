import pygame
import pytest

from layfigure_frontends.sdl.keys import key_chord, repeats


@pytest.mark.parametrize(
    ("key", "scancode", "modifiers", "expected"),
    [
        (pygame.K_m, pygame.KSCAN_M, 0, "m"),
        (pygame.K_n, pygame.KSCAN_N, pygame.KMOD_LSHIFT, "shift+n"),
        (pygame.K_z, pygame.KSCAN_Z, pygame.KMOD_LCTRL, "ctrl+z"),
        (pygame.K_z, pygame.KSCAN_Z, pygame.KMOD_LCTRL | pygame.KMOD_RSHIFT, "ctrl+shift+z"),
        (pygame.K_z, pygame.KSCAN_Z, pygame.KMOD_LMETA, "ctrl+z"),
        (pygame.K_LEFT, pygame.KSCAN_LEFT, pygame.KMOD_LALT, "alt+left"),
        (pygame.K_TAB, pygame.KSCAN_TAB, pygame.KMOD_LSHIFT, "shift+tab"),
        (pygame.K_SLASH, pygame.KSCAN_SLASH, pygame.KMOD_LSHIFT, "?"),
        (pygame.K_SEMICOLON, pygame.KSCAN_SEMICOLON, pygame.KMOD_LSHIFT, ":"),
        (pygame.K_EQUALS, pygame.KSCAN_EQUALS, pygame.KMOD_LSHIFT, "+"),
        (pygame.K_MINUS, pygame.KSCAN_MINUS, 0, "-"),
        (pygame.K_LEFTBRACKET, pygame.KSCAN_LEFTBRACKET, 0, "["),
        (pygame.K_COLON, pygame.KSCAN_PERIOD, 0, ":"),
        (pygame.K_KP4, pygame.KSCAN_KP4, pygame.KMOD_NUM, "kp4"),
        (pygame.K_KP_PLUS, pygame.KSCAN_KP_PLUS, 0, "+"),
        (pygame.K_KP_ENTER, pygame.KSCAN_KP_ENTER, 0, "enter"),
        (pygame.K_PAGEUP, pygame.KSCAN_PAGEUP, 0, "pageup"),
        (pygame.K_F12, pygame.KSCAN_F12, 0, "f12"),
        (pygame.K_5, pygame.KSCAN_5, 0, "5"),
    ],
)
def test_keys_have_the_names_that_keymaps_use(key, scancode, modifiers, expected):
    assert key_chord(key, scancode, modifiers) == expected


def test_the_digit_row_types_digits_on_a_french_keyboard_without_shift():
    assert key_chord(pygame.K_AMPERSAND, pygame.KSCAN_1, 0) == "1"
    assert key_chord(233, pygame.KSCAN_2, 0) == "2"


def test_letters_follow_the_layout_and_fall_back_to_the_position_where_it_is_not_latin():
    assert key_chord(pygame.K_z, pygame.KSCAN_Y, 0) == "z"
    assert key_chord(0x44C, pygame.KSCAN_M, 0) == "m"


def test_modifiers_alone_and_unknown_keys_mean_nothing():
    assert key_chord(pygame.K_LSHIFT, pygame.KSCAN_LSHIFT, pygame.KMOD_LSHIFT) is None
    assert key_chord(0, 0, 0) is None


def test_walking_and_stepping_keys_repeat_and_commands_do_not():
    assert all(map(repeats, ["left", "shift+left", "tab", "shift+tab", "[", "+", "ctrl++", "-", "pageup", "backspace"]))
    assert not any(map(repeats, ["m", "n", "shift+n", "f", "ctrl+z", "1", "enter", "escape", "space"]))
