"""Every hook has a page with its true signature, is linked and tested, and the code on the pages runs."""

import inspect
import re
from pathlib import Path

import pytest

from layfigure.plugins import hookspecs
from layfigure.plugins.host import Host

ROOT = Path(__file__).resolve().parents[2]
HOOKS = sorted(name for name in vars(hookspecs) if name.startswith("layfigure_"))


@pytest.mark.parametrize("hook", HOOKS)
def test_every_hook_has_a_page_with_its_true_signature(hook):
    page = (ROOT / "docs" / "hooks" / f"{hook}.md").read_text(encoding="utf-8")
    signature = inspect.signature(getattr(hookspecs, hook))
    text = str(signature).replace("'", "")
    assert f"def {hook}{text}" in page


def test_every_page_is_of_a_hook_that_exists_and_is_linked():
    pages = {path.stem for path in (ROOT / "docs" / "hooks").glob("*.md")}
    assert pages == set(HOOKS)
    overview = (ROOT / "docs" / "plugins.md").read_text(encoding="utf-8")
    assert all(f"hooks/{hook}.md" in overview for hook in HOOKS)


@pytest.mark.parametrize("hook", HOOKS)
def test_the_examples_run_without_a_fault(hook, monkeypatch):
    page = (ROOT / "docs" / "hooks" / f"{hook}.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", page, re.S)
    monkeypatch.syspath_prepend(str(ROOT / "docs" / "template"))
    for block in blocks:
        namespace: dict[str, object] = {}
        exec(compile(block, f"{hook}.md", "exec"), namespace)
        host = Host()
        host.register(type("Example", (), {hook: staticmethod(namespace[hook])})(), "example")
        assert host.faults == []


@pytest.mark.parametrize("hook", HOOKS)
def test_every_hook_is_tested_with_the_kit_in_a_file_of_its_own(hook):
    text = (ROOT / "tests" / "hooks" / f"test_{hook}.py").read_text(encoding="utf-8")
    assert f"def {hook}(" in text or "make_host(ONE_FILE" in text
    assert "from layfigure.testing import" in text


def test_every_test_of_a_hook_is_of_one_that_exists():
    files = {path.stem.removeprefix("test_") for path in (ROOT / "tests" / "hooks").glob("test_*.py")}
    assert files == set(HOOKS)


@pytest.mark.parametrize("page", sorted((ROOT / "docs").glob("*.md")), ids=lambda path: path.stem)
def test_the_code_on_a_page_runs_from_top_to_bottom(page, monkeypatch):
    monkeypatch.chdir(ROOT)
    namespace: dict[str, object] = {}
    for block in re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.S):
        exec(compile(block, page.name, "exec"), namespace)


def test_the_readme_names_the_commands_that_ci_runs():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    ci = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    command = ".venv/bin/pip install -q -e '.[test]' && .venv/bin/pytest -q -n auto"
    assert command in readme and command in ci


@pytest.mark.parametrize("page", sorted(path.name for path in [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")]))
def test_links_between_pages_lead_somewhere(page):
    path = next(p for p in (ROOT / page, ROOT / "docs" / page) if p.is_file())
    for target in re.findall(r"\]\(([^)#:]+)\)", path.read_text(encoding="utf-8")):
        assert (path.parent / target).exists(), target
