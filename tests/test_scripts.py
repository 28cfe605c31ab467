"""The scripts beside the package: what they refuse, and that nothing they were given or have made is lost."""

from __future__ import annotations

import importlib.util
import json
import os
import signal
import subprocess
import sys
import tarfile
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import ModuleType

import pytest

SCRIPTS = Path(__file__).parent.parent / "scripts"
WORKER = """
import pathlib, sys, time
pathlib.Path(sys.argv[1], "begun").touch()
try:
    time.sleep(60)
except KeyboardInterrupt:
    pathlib.Path(sys.argv[1], "put down").touch()
"""


def script(name: str) -> ModuleType:
    """A script as a module; its own `main` is not called."""
    loader = SourceFileLoader(name, str(SCRIPTS / name))
    spec = importlib.util.spec_from_loader(name, loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module  # where its dataclasses look for their annotations
    loader.exec_module(module)
    return module


@pytest.mark.parametrize("ends", ["its time is over", "it is interrupted"])
def test_a_campaign_s_work_is_put_down_when_it_ends(tmp_path: Path, ends: str) -> None:
    campaign, command = script("gpu_campaign"), [sys.executable, "-c", WORKER, str(tmp_path)]

    def interrupt(*_: object) -> None:
        if (tmp_path / "begun").exists():
            signal.setitimer(signal.ITIMER_REAL, 0)
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        if ends == "it is interrupted":
            signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
        status = campaign.work(command, dict(os.environ), 60 if ends == "it is interrupted" else 3.0)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert status == campaign.MORE_TO_DO and (tmp_path / "put down").exists()


def test_packed_files_are_cut_without_a_byte_lost(tmp_path: Path) -> None:
    campaign, whole = script("gpu_campaign"), tmp_path / "policy.tar"
    payload = os.urandom(1000)
    whole.write_bytes(payload)
    assert campaign.cut(whole, 1000) == [whole] and whole.read_bytes() == payload
    pieces = campaign.cut(whole, 300)
    assert [p.name for p in pieces] == [f"policy.tar.0{i}" for i in range(4)] and not whole.exists()
    assert b"".join(p.read_bytes() for p in pieces) == payload


def test_what_is_carried_is_taken_over_and_what_is_there_stays(tmp_path: Path) -> None:
    campaign, out = script("gpu_campaign"), tmp_path / "out"
    (tmp_path / "cells").mkdir()
    (out / "cells").mkdir(parents=True)
    for name in ("a.json", "b.json"):
        (tmp_path / "cells" / name).write_text("carried")
    (out / "cells" / "a.json").write_text("here")
    with tarfile.open(tmp_path / "carry.tar", "w") as tar:
        tar.add(tmp_path / "cells", "cells")
    campaign.unpack(tmp_path / "carry.tar", out)
    assert [(out / "cells" / name).read_text() for name in ("a.json", "b.json")] == ["here", "carried"]
    (tmp_path / "carry.tar").rename(tmp_path / "carry.tar.00")
    with pytest.raises(SystemExit, match=r"in pieces: cat .*carry\.tar\.\?\?"):
        campaign.unpack(tmp_path / "carry.tar", out)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("gpu_campaign", "table-b2", "--out", "OUT", "--part", "-1"), "--part: -1 MB is less than a byte"),
        (("learning_study", "heads", "--out", "OUT", "--jobs", "0"), "--jobs: 0 is not 1 or more"),
        (("learning_study", "heads", "--out", "OUT", "--task", "pick-place"), "of pick-place there are no lessons"),
        (("door_study",), "the following arguments are required: run"),
        (("results_table", "--chekc"), "unrecognized arguments: --chekc"),
        (("setup",), "the following arguments are required: folder"),
    ],
)
def test_what_cannot_be_is_said_before_any_work(tmp_path: Path, words: tuple[str, ...], said: str) -> None:
    name, *options = (word.replace("OUT", str(tmp_path / "out")) for word in words)
    done = subprocess.run([sys.executable, str(SCRIPTS / name), *options], capture_output=True, text=True)
    assert done.returncode and said in done.stderr and "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["door_study", "gpu_campaign", "learning_study", "make_gallery", "results_table", "setup"])
def test_help_is_help(name: str) -> None:
    done = subprocess.run([sys.executable, str(SCRIPTS / name), "--help"], capture_output=True, text=True)
    assert done.returncode == 0 and f"usage: {name}" in done.stdout, done.stderr


def test_a_study_goes_on_with_the_same_settings_only(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    study = script("learning_study")

    def begin(*options: str) -> None:
        monkeypatch.setattr(sys, "argv", ["learning_study", "heads", "--out", str(tmp_path), *options])
        study.begin(study.asked())

    begin("--steps", "20")
    begin("--steps", "20", "--seeds", "5")  # there may be more of the same
    with pytest.raises(SystemExit, match="begun with steps = 20, not 30"):
        begin("--steps", "30")
    assert json.loads((tmp_path / "asked.json").read_text())["steps"] == 20
