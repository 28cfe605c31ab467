"""The policies that come with the package: they load, act, may be evaluated, and nothing is written into the package."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

import optimus
from optimus.cli.policies import evaluate
from optimus.env import ManipulationEnv
from optimus.errors import UnknownNameError
from optimus.pretrained import PREFIX, SHIPPED, names, run_folder, trained_folder
from optimus.tasks import task


def files(folder: Path) -> dict[str, int]:
    return {str(p.relative_to(folder)): p.stat().st_mtime_ns for p in folder.rglob("*") if p.is_file() and p.suffix != ".pyc"}


def test_they_do_their_task(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """In physics, from fresh problems: half of four is far below what they do, and far above what chance does."""
    monkeypatch.setattr("optimus.pretrained.cache_folder", lambda: tmp_path)
    before = files(SHIPPED)
    assert names() == ["pick-place", "stack"]
    for name in names():
        evaluate(Path(PREFIX + name), episodes=4, workers=1, json=True)
        said = json.loads(capsys.readouterr().out.splitlines()[-1])
        assert said["successes"] >= 2 and said["task"] == name
        assert (run_folder(PREFIX + name) / "evaluation-random.json").exists()
        assert sum(p.stat().st_size for p in (SHIPPED / name).iterdir()) < 4e6
    assert files(SHIPPED) == before


def test_one_acts_by_its_name(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("optimus.pretrained.cache_folder", lambda: tmp_path)
    env = ManipulationEnv(task("stack"))
    policy = optimus.load_policy("pretrained:stack")
    policy.reset()
    action = policy.act(env.reset(seed=1)[0])
    assert action.shape == env.action_space.shape and np.isfinite(action).all()
    env.close()


def test_the_folder_of_a_main_job_stands_for_its_policy(tmp_path: Path) -> None:
    shutil.copytree(SHIPPED / "stack", tmp_path / "job" / "policy")
    assert trained_folder(tmp_path / "job") == trained_folder(tmp_path / "job" / "policy") == tmp_path / "job" / "policy"
    assert run_folder(tmp_path / "job") == tmp_path / "job"
    assert optimus.load_policy(tmp_path / "job").policy.inputs.task == "stack"


def test_another_name_is_refused() -> None:
    with pytest.raises(UnknownNameError, match="pick-place"):
        run_folder("pretrained:juggle")
    assert run_folder("runs/stack") == Path("runs/stack")
