"""The storeys of the house, what importing costs, and what a wheel carries."""

import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = ("engine/layfigure", "plugins/layfigure_plugins", "frontends/layfigure_frontends")
SOURCES = sorted(path for package in PACKAGES for path in (ROOT / package).rglob("*.py"))


def imported_by(statement: str) -> set[str]:
    """Return the top-level modules that a fresh interpreter holds after a statement."""
    code = f"import sys, json; {statement}; print(json.dumps(sorted({{name.split('.')[0] for name in sys.modules}})))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    return set(json.loads(done.stdout.splitlines()[-1]))


def test_the_layer_contract_is_kept():
    done = subprocess.run(
        [Path(sys.executable).with_name("lint-imports")],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.returncode == 0, done.stdout


def test_importing_the_engine_or_the_command_line_imports_nothing_heavy():
    heavy = {"numpy", "numba", "pygame", "lark", "PIL", "rich", "pluggy"}
    assert not heavy & imported_by("import layfigure, layfigure_frontends.command_line")


def test_the_options_of_scripts_cost_other_commands_nothing_heavy():
    heavy = {"numpy", "numba", "pygame", "lark", "PIL", "rich", "pluggy"}
    assert not heavy & imported_by("from layfigure_frontends.commands import run, check, render")


def test_a_first_picture_is_composed_without_the_script_language():
    composing = (
        "from layfigure.plugins.host import Host; from layfigure.session.figures import open_figure;"
        "from layfigure.session.document import Document; from layfigure.session.frame import Size;"
        "from layfigure.session.session import Session; import layfigure_frontends.commands.pose;"
        "host = Host.discover(); session = Session(host, Document.new(open_figure(host, 'humanoid')));"
        "assert session.frame(Size(1280, 800)).panes"
    )
    assert not {"lark", "PIL"} & imported_by(composing)


def test_plugins_load_without_numba_or_pygame():
    loading = "from layfigure.plugins.host import Host; host = Host.discover(); assert host.techniques"
    assert not {"numba", "pygame", "PIL"} & imported_by(loading)


def test_pygame_is_imported_only_by_the_window():
    users = {path for path in SOURCES if re.search(r"^\s*(import|from) pygame", path.read_text(encoding="utf-8"), re.M)}
    assert users and all("layfigure_frontends/sdl" in path.as_posix() for path in users)


def test_numba_is_imported_only_by_kernels():
    users = {path for path in SOURCES if re.search(r"^\s*(import|from) numba", path.read_text(encoding="utf-8"), re.M)}
    assert users and all("kernels" in path.as_posix() for path in users)


def test_the_terminal_is_controlled_only_by_the_terminal_front_end_and_what_measures_it():
    control = re.compile(r"\\x1b|\\033|\\e\[|^\s*(import|from) (termios|tty|curses)\b", re.M)
    users = {path for path in SOURCES if control.search(path.read_text(encoding="utf-8"))}
    places = ("layfigure_frontends/terminal", "layfigure_frontends/bench/terminals")
    assert users and all(any(place in path.as_posix() for place in places) for path in users)


def test_a_terminal_is_taken_over_and_written_to_before_numba_is_imported():
    loading = (
        "from layfigure_frontends.terminal import cells, depth, driver, encoder, fence, graphics, parser, tty;"
        "grid = cells.Grid(80, 24); assert encoder.CellEncoder(depth.Depth.TRUE).encode(grid)"
    )
    assert not {"numba", "pygame", "PIL", "click", "rich"} & imported_by(loading)


def test_nothing_is_pickled_or_evaluated():
    for path in SOURCES:
        assert not re.search(r"\bpickle\b|\beval\(|\bexec\(|allow_pickle=True", path.read_text(encoding="utf-8")), path


def test_front_ends_name_no_technique_and_no_key_meaning():
    windows = [*(ROOT / "frontends").rglob("sdl/*.py"), *(ROOT / "frontends").rglob("terminal/**/*.py")]
    assert len(windows) > 30
    for path in windows:
        assert not re.search(r"technique\s*==|[\"']generator[\"']", path.read_text(encoding="utf-8")), path


@pytest.fixture(scope="module")
def wheel(tmp_path_factory) -> Path:
    """A wheel built from the checkout."""
    folder = tmp_path_factory.mktemp("wheel")
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(folder), str(ROOT)]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    return next(folder.glob("*.whl"))


def test_a_wheel_carries_packages_models_data_and_type_marks(wheel):
    names = set(zipfile.ZipFile(wheel).namelist())
    wanted = {"layfigure/shipped/models/humanoid.fig", "layfigure/shipped/data/keymaps/layfigure.toml",
              "layfigure/py.typed", "layfigure_plugins/py.typed", "layfigure_frontends/__main__.py",
              "layfigure/shipped/data/scripts/sitting.log"}  # fmt: skip
    assert wanted <= names
    assert not any("tests" in name or name.endswith(".pyc") for name in names)


def test_a_wheel_works_away_from_the_checkout(wheel, tmp_path):
    site = tmp_path / "site"
    zipfile.ZipFile(wheel).extractall(site)
    code = (
        "import layfigure, sys\n"
        "from layfigure.plugins.host import Host\n"
        "from layfigure.session.figures import open_figure\n"
        "assert layfigure.__file__.startswith(sys.argv[1])\n"
        "print(open_figure(Host(), 'humanoid').limb_count)\n"
    )
    env = {**os.environ, "PYTHONPATH": str(site)}
    done = subprocess.run(
        [sys.executable, "-c", code, str(site)], env=env, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.stdout.strip() == "19", done.stderr
