"""The documentation is true: its code runs, its commands are ones that the program takes, its links lead somewhere."""

import contextlib
import functools
import inspect
import io
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from unittest import mock

import pytest
import tyro

from optimus.cli import VERBS
from program import optimus

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
IN_TEST_GUIDES = {"add_a_task.md", "add_a_skill.md", "add_a_robot.md"}
"""Their code is run by tests of their own."""
NEEDS_A_POLICY = {"use_a_policy.md"}
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```", re.M | re.S)


def name(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


def blocks(page: Path, kind: str) -> list[str]:
    return [text for found, text in BLOCK.findall(page.read_text()) if found == kind]


WITH_CODE = [p for p in PAGES if blocks(p, "python") and p.name not in IN_TEST_GUIDES | NEEDS_A_POLICY]


@pytest.mark.parametrize("page", WITH_CODE, ids=name)
def test_the_code_on_a_page_runs(page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One block after another, as somebody would who reads from top to bottom."""
    monkeypatch.chdir(tmp_path)
    space: dict[str, Any] = {"__name__": page.stem}
    for block in blocks(page, "python"):
        exec(compile(block, name(page), "exec"), space)


def test_demonstrations_written_by_hand_are_learned_from(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from optimus.data.curate import curate
    from optimus.learn.train import TrainConfig, train

    monkeypatch.chdir(tmp_path)
    exec(compile(blocks(ROOT / "docs" / "use_other_demonstrations.md", "python")[0], "guide", "exec"), {"__name__": "guide"})
    assert curate("data/mine").validation
    train("data/mine", Path("run"), TrainConfig(steps=1))


@pytest.fixture(scope="module")
def trained(tmp_path_factory: pytest.TempPathFactory) -> Path:
    from optimus.collect import CollectConfig, collect
    from optimus.data.curate import curate
    from optimus.learn.train import TrainConfig, train

    folder = tmp_path_factory.mktemp("docs")
    collect(CollectConfig("stack", folder / "data", 3, workers=1))
    curate(folder / "data")
    train(folder / "data", folder / "runs" / "policy", TrainConfig(steps=2))
    return folder


@pytest.mark.parametrize("page", [p for p in PAGES if p.name in NEEDS_A_POLICY], ids=name)
def test_the_code_with_a_policy_runs(page: Path, trained: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import optimus
    from optimus.env import ManipulationEnv
    from optimus.tasks import task

    if not hasattr(optimus, "load_policy"):
        pytest.skip("optimus.load_policy is not there yet")
    monkeypatch.chdir(trained)
    observation, _ = ManipulationEnv(task("stack")).reset(seed=0)
    space: dict[str, Any] = {"__name__": page.stem, "observation": observation}
    for block in blocks(page, "python"):
        exec(compile(block, name(page), "exec"), space)


def commands(page: Path) -> Iterator[str]:
    """Every whole command of a page: lines of code blocks, fenced or indented, that call `optimus`."""
    for line in page.read_text().splitlines():
        found = re.match(r"^(?:\s*|\| .*\| `)(?:PYTHONPATH=\S+ )?(?:\.venv/bin/)?(optimus [a-z]+\b[^`#|]*)", line)
        if found and page.name != "cli.md":
            yield found.group(1).strip()


def mentions(page: Path) -> Iterator[str]:
    """Every command that a sentence of a page names."""
    yield from re.findall(r"`(optimus [a-z]+\b[^`]*)`", page.read_text())


def parsed(command: str) -> None:
    """AssertionError unless the program takes `command`; nothing is done."""

    def idle(verb: Callable[..., None]) -> Callable[..., None]:
        @functools.wraps(verb)
        def nothing(*args: Any, **kwargs: Any) -> None:
            inspect.signature(verb).bind(*args, **kwargs)

        return nothing

    said = io.StringIO()
    words = shlex.split(command)[1:]
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(said):
        try:
            tyro.extras.subcommand_cli_from_dict({v: idle(f) for v, f in VERBS.items()}, prog="optimus", args=words)
        except SystemExit as ended:
            assert ended.code == 0, f"{command}:\n{said.getvalue()}"


def test_a_wrong_command_is_noticed() -> None:
    parsed("optimus collect stack --out x --episodes 3")
    for wrong in ("optimus collect stack --out x --episode-count 3", "optimus colect stack", "optimus collect stack"):
        with pytest.raises(AssertionError):
            parsed(wrong)


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_the_program_takes_every_command_of_a_page(page: Path) -> None:
    for command in commands(page):
        parsed(command)
    for mention in mentions(page):
        verb, *rest = mention.split()[1:]
        assert verb in VERBS, f"{page}: {mention}"
        known = options_of(verb)
        for option in (word.partition("=")[0].rstrip(",;") for word in rest if word.startswith("--")):
            assert option in known, f"{name(page)}: {mention}: no {option}"


@functools.cache
def options_of(verb: str) -> frozenset[str]:
    with mock.patch.dict(os.environ, {"COLUMNS": "200"}):
        done = optimus(verb, "--help")
    return frozenset(re.findall(r"--[a-z][a-z-]*", done.stdout))


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_links_and_pictures_are_there(page: Path) -> None:
    for target in re.findall(r"\]\(([^)#\s]+)", page.read_text()):
        if not target.startswith(("http://", "https://", "mailto:")):
            assert (page.parent / target).exists(), f"{name(page)} -> {target}"


def test_the_gallery_is_small() -> None:
    films = list((ROOT / "docs" / "images" / "gallery").glob("*"))
    assert films and max(f.stat().st_size for f in films) < 300_000
    assert sum(f.stat().st_size for f in (ROOT / "docs" / "images").rglob("*") if f.is_file()) < 4_000_000


def test_the_site_builds_without_a_warning(tmp_path: Path) -> None:
    pytest.importorskip("mkdocs", reason="pip install 'optimus-tamp[docs]'")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(tmp_path / "site")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    api = (tmp_path / "site" / "reference" / "api" / "index.html").read_text()
    assert "ManipulationEnv" in api and "delta position and delta rotation" in api
