"""Every hook has a page with its true signature, is linked, and its example runs."""

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


def test_the_readme_names_the_commands_that_ci_runs():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    ci = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    command = ".venv/bin/pip install -q -e '.[test]' && .venv/bin/pytest -q"
    assert command in readme and command in ci


@pytest.mark.parametrize("page", sorted(path.name for path in [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")]))
def test_links_between_pages_lead_somewhere(page):
    path = next(p for p in (ROOT / page, ROOT / "docs" / page) if p.is_file())
    for target in re.findall(r"\]\(([^)#:]+)\)", path.read_text(encoding="utf-8")):
        assert (path.parent / target).exists(), target
