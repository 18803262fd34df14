"""Scripts from the command line: run, check, and two hundred broken ones that get one sentence each."""

import random
import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from layfigure_frontends import command_line

SCRIPTS = Path(__file__).resolve().parents[2] / "data" / "scripts"
TOKEN = re.compile(r"\{[^}]*\}|\"[^\"]*\"|[\w.]+|:-|:=|\S")
BROKEN = 200


def layfigure(capfd, monkeypatch, *words: object) -> tuple[int, str, str]:
    """Run the command in this process and return status, standard output and standard error."""
    monkeypatch.setattr(sys, "argv", ["layfigure", *map(str, words)])
    with pytest.raises(SystemExit) as left:
        command_line.main()
    out, err = capfd.readouterr()
    return int(left.value.code or 0), out, err


@cache
def sources() -> tuple[str, ...]:
    """Return the shipped scripts, their films made short."""
    texts = [path.read_text(encoding="utf-8") for path in sorted(SCRIPTS.glob("*.lay"))]
    return tuple(text.replace("LENGTH 2881", "LENGTH 25") for text in texts)


def broken(seed: int) -> str:
    """Return a shipped script with one mutation that chance of a seed chose."""
    chance = random.Random(seed)
    text = chance.choice(sources())
    places = [match.span() for match in TOKEN.finditer(text) if not match.group().startswith("{")]
    begin, end = chance.choice(places)
    token = text[begin:end]
    kind = seed % len(MUTATIONS)
    return MUTATIONS[kind](chance, text, (begin, end), token)


def _swapped(chance: random.Random, text: str, span: tuple[int, int], token: str) -> str:
    begin, end = span
    after = TOKEN.search(text, end)
    if after is None or after.group().startswith("{"):
        return text[:begin]
    return text[:begin] + after.group() + text[end : after.start()] + token + text[after.end() :]


def _other(word: str):
    return lambda chance, text, span, token: text[: span[0]] + word + text[span[1] :]


def _looped(chance: random.Random, text: str, span: tuple[int, int], token: str) -> str:
    line = text.rfind("\n", 0, span[0]) + 1
    body = chance.choice(["x = 1", "x = x + 1", "s = s + s", "PRINT 1", "FOR i = 1 TO 9\nx = i\nENDFOR"])
    return f'{text[:line]}\nx = 0; s = "a"\nWHILE TRUE\n{body}\nENDWHILE\n{text[line:]}'


MUTATIONS = (
    lambda chance, text, span, token: text[: span[0]] + text[span[1] :],
    lambda chance, text, span, token: text[: span[1]] + " " + token + text[span[1] :],
    _swapped,
    lambda chance, text, span, token: text[: span[0]] + token + "q" + text[span[1] :],
    lambda chance, text, span, token: text[: span[1]],
    _other("9" * 400),
    _other("1e999999999"),
    _other("(" * 5000 + "1" + ")" * 4999),
    _other("-" * 3000 + "1"),
    _other("nobody"),
    _other("-100000000000"),
    _looped,
    _other("@"),
    _other('"never'),
    _other("{"),
)


def candidates() -> Iterator[int]:
    """Yield seeds without end."""
    seed = 0
    while True:
        yield seed
        seed += 1


def test_two_hundred_broken_scripts_get_one_sentence_each(capfd, monkeypatch, tmp_path):
    path, found, sentences = tmp_path / "broken.lay", 0, set()
    for seed in candidates():
        path.write_text(broken(seed), encoding="utf-8")
        status, _, err = layfigure(capfd, monkeypatch, "check", "--safe", path)
        if status == 0:
            continue  # some mutations are as good as what they replaced
        found += 1
        (sentence,) = [line for line in err.splitlines() if re.match(r"layfigure: \S*broken.lay:\d+:\d+: ", line)]
        assert status == 2, (seed, err)
        assert err.splitlines() == [sentence], (seed, err)
        assert "Traceback" not in err and len(sentence) < 600, (seed, err)
        sentences.add(re.sub(r"\d+", "", sentence))
        if found == BROKEN:
            break
    assert seed < 2 * BROKEN
    assert len(sentences) > 50
    assert [path.name for path in tmp_path.iterdir()] == ["broken.lay"]


@pytest.mark.parametrize("path", sorted(SCRIPTS.glob("*.lay")), ids=lambda path: path.name)
def test_the_shipped_scripts_are_right(path, capfd, monkeypatch):
    status, out, _ = layfigure(capfd, monkeypatch, "check", path)
    assert status == 0
    assert re.search(r"right; 1 scene, \d+ pictures?\n", out)


def test_run_prints_and_writes_what_the_script_says_and_check_writes_nothing(capfd, monkeypatch, tmp_path):
    path = tmp_path / "a.lay"
    path.write_text('m[1,1] = FRAME 3 POSITION 1,2,3\nPRINT "hello", 1 + 1\nSAVE m, "m.motion"')
    assert layfigure(capfd, monkeypatch, "check", path) == (0, f"{path}: right; 0 scenes, 0 pictures\n", "")
    assert not (tmp_path / "m.motion").exists()
    status, out, err = layfigure(capfd, monkeypatch, "run", path)
    assert (status, out, err) == (0, "hello 2\n", f"layfigure: wrote {tmp_path / 'm.motion'}\n")
    status, out, _ = layfigure(capfd, monkeypatch, "check", tmp_path / "m.motion")
    assert (status, out) == (0, f"{tmp_path / 'm.motion'}: right; 3 frames, 1 joint, 2 keys\n")


def test_an_option_raises_a_limit(capfd, monkeypatch, tmp_path):
    path = tmp_path / "a.lay"
    path.write_text("FOR i = 1 TO 250000\nENDFOR\nPRINT i")
    status, _, err = layfigure(capfd, monkeypatch, "run", path)
    assert status == 2 and err.endswith("; raise the limit with --most-steps\n")
    assert layfigure(capfd, monkeypatch, "run", path, "--most-steps", 10**6)[:2] == (0, "250000\n")
    assert layfigure(capfd, monkeypatch, "check", path)[2].endswith("; raise the limit with --most-steps\n")


def test_an_option_lets_a_script_save_elsewhere(capfd, monkeypatch, tmp_path):
    path = tmp_path / "in" / "a.lay"
    path.parent.mkdir()
    path.write_text('m[1, 1] = FRAME 3 POSITION 1, 2, 3\nSAVE m, "../m.motion"')
    status, _, err = layfigure(capfd, monkeypatch, "run", path)
    assert status == 2 and err.endswith("; --outside lets it save elsewhere\n")
    assert layfigure(capfd, monkeypatch, "run", path, "--outside")[0] == 0
    assert (tmp_path / "m.motion").is_file()


@pytest.fixture
def plugin(tmp_path):
    """Return the file of a plug-in with an interpolation."""
    path = tmp_path / "bounce.py"
    path.write_text(
        "from layfigure.plugins.hookspecs import hookimpl\n"
        "from layfigure.plugins.records import Interpolation\n\n\n"
        "@hookimpl\ndef layfigure_interpolations():\n"
        '    """Return one."""\n'
        '    return [Interpolation("bounce", "Bounce", ease=lambda u: u * u)]\n'
    )
    return path


def test_a_script_may_name_an_interpolation_of_a_plug_in(capfd, monkeypatch, tmp_path, plugin):
    path = tmp_path / "a.lay"
    path.write_text("m[1,1] = FRAME 3 POSITION 1,2,3 INTERPOLATE bounce\nPRINT duration(m)")
    assert layfigure(capfd, monkeypatch, "run", path)[0] == 2
    assert layfigure(capfd, monkeypatch, "run", path, "--plugin", plugin)[:2] == (0, "3\n")


def test_a_motion_that_nothing_can_play_is_not_right(capfd, monkeypatch, tmp_path, plugin):
    path = tmp_path / "a.motion"
    path.write_text("layfigure motion 1\njoint a\n0 0 0 0\n5 0 0 9 bounce\n")
    status, _, err = layfigure(capfd, monkeypatch, "check", path)
    assert status == 2 and f'{path}:4:9: found "bounce"' in err
    assert layfigure(capfd, monkeypatch, "check", path, "--plugin", plugin)[0] == 0


def test_what_was_printed_before_a_mistake_is_shown(capfd, monkeypatch, tmp_path):
    path = tmp_path / "late.lay"
    path.write_text('PRINT "first"\nPRINT "second"\nPRINT nothing\n', encoding="utf-8")
    status, out, err = layfigure(capfd, monkeypatch, "run", "--safe", path)
    assert (status, out.splitlines()) == (2, ["first", "second"])
    assert "late.lay:3:7: " in err and len(err.splitlines()) == 1
