"""`--help` of every verb, and the page made from it: purpose, examples, every option with its meaning, unit and default."""

import inspect
import os
import re
import subprocess
import sys
import typing
from pathlib import Path
from unittest import mock

import pytest

from optimus.cli import VERBS
from program import optimus

DOCS = Path(__file__).parent.parent / "docs"
UNIT = r"minute|second|\[\w+|metre|share|standard deviation|factor|rate|probability|weight|times"


def help_of(verb: str) -> str:
    """What a terminal of 100 columns shows, without its frames."""
    with mock.patch.dict(os.environ, {"COLUMNS": "100"}):
        done = optimus(verb, "--help")
    return re.sub(r"[│╭╮╰╯─]", " ", done.stdout)


def options_in(text: str) -> dict[str, str]:
    """Option or positional -> its help, from what the terminal shows."""
    found: dict[str, str] = {}
    name = ""
    for line in text[text.index("positional" if "positional" in text else "options  ") :].splitlines()[1:]:
        if begins := re.match(r"\s{1,3}(-\S+|[A-Z|]{3,})(.*)", line):
            name = begins.group(1).rstrip(",")
            found[name] = begins.group(2)
        elif name:
            found[name] += f" {line.strip()}"
    return found


@pytest.fixture(scope="module", params=list(VERBS))
def verb(request: pytest.FixtureRequest) -> tuple[str, str]:
    return request.param, help_of(request.param)


def test_it_says_what_for_and_shows_an_example(verb: tuple[str, str]) -> None:
    name, text = verb
    purpose = (inspect.getdoc(VERBS[name]) or "").split("\n")[0]
    assert purpose[:1].isupper() and len(purpose) > 12
    assert purpose[:30] in " ".join(text.split())
    examples = re.findall(rf"^\s*(?:Try: )?optimus {name}\b.*$", text, re.M)
    assert examples, f"{name} --help has no example"


def test_every_option_says_what_it_means(verb: tuple[str, str]) -> None:
    """Help of its own for each, a default where it has one; and a unit for every number that is not a count."""
    name, text = verb
    options = options_in(text)
    assert "--json" in options
    for option, said in options.items():
        if option == "-h":
            continue
        assert len(re.findall(r"[a-z]{2,}", re.sub(r"\((default|required).*?\)", "", said))) >= 2, f"{name} {option}: no help"
        assert re.search(r"\((default|required|optional|repeatable)", said), f"{name} {option}: no default in {said!r}"
    for option, kind in typing.get_type_hints(VERBS[name]).items():
        if float in (kind, *typing.get_args(kind)):
            told = f"{option} {options['--' + option.replace('_', '-')]}"
            assert re.search(UNIT, told), f"{name} --{option}: which unit? {told}"


def test_the_reference_is_as_the_program_says() -> None:
    """docs/reference/cli.md is made by scripts/make_reference; this says when that has to be done again."""
    command = [sys.executable, DOCS.parent / "scripts" / "make_reference", "--check"]
    made = subprocess.run(command, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
