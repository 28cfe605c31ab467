"""The main job, small: every stage really runs, and a second call finds everything done."""

import json
import math
import shlex
import shutil
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from safetensors.numpy import load_file

from optimus.cli import main
from optimus.collect import CollectConfig, collect, open_dataset
from optimus.correct import Turns
from optimus.data.store import EpisodeStore
from optimus.errors import CheckpointError, DatasetError, OptimusError
from optimus.evaluate import trained_robot
from optimus.learn import checkpoint
from optimus.learn.train import TrainConfig, train
from optimus.robots import PANDA
from optimus.robots.catalogue import robot
from optimus.run import Journal, RunConfig, run
from optimus.summary import _command, summary_of
from optimus.tasks.stack import STACK


def what_was_done(out: Path) -> dict[str, bytes]:
    """Every demonstration, every line of training's metrics and every weight."""
    done = {str(p): p.read_bytes() for p in out.rglob("metrics.jsonl")}
    for path in out.rglob("*.safetensors"):
        done |= {f"{path} {name}": array.tobytes() for name, array in load_file(path).items()}
    return done


def test_from_the_task_to_a_report(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("optimus.run.LEAST_TRAINING", 0.1)
    monkeypatch.setattr("optimus.tasks.stack.STACK", replace(STACK, horizon=160))  # nothing is learned; nobody watches for long
    stages: list[str] = []
    config = RunConfig("stack", tmp_path / "out", 0.2, 4, episodes=1, workers=1, mishaps=0.5)
    first = run(config, lambda stage, done, total, notes: stages.append(stage))
    assert list(dict.fromkeys(stages)) == ["collect", "train", "evaluate"]
    assert first["evaluation"]["episodes"] == 1 and len(first["evaluation"]["interval"]) == 2
    assert EpisodeStore.open(config.out / "data").config["expert"]["mishaps"] == 0.5
    page = Path(first["report"]).read_text()
    assert "<html" in page and "data:video/mp4" in page and "https://" not in page
    done = what_was_done(config.out)
    second = run(config)
    assert second["evaluation"] == first["evaluation"]
    assert what_was_done(config.out) == done
    with pytest.raises(DatasetError, match="minutes"):
        run(RunConfig("stack", tmp_path / "out", minutes=5))
    assert json.loads((tmp_path / "out" / "run.json").read_text())["config"]["minutes"] == 0.2


@pytest.fixture(scope="module")
def with_another_arm(tmp_path_factory: pytest.TempPathFactory) -> RunConfig:
    """A run with the UR5e under joint control: two training steps, no corrections but their empty dataset, no films."""
    out = tmp_path_factory.mktemp("arm") / "out"
    few = {"demonstrations": 3, "episodes": 1, "workers": 1}
    config = RunConfig("stack", out, 0.1, **few, corrections=True, control="joint", robot=robot("ur5e"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("optimus.run.TrainConfig", lambda minutes, seed, rate: TrainConfig(steps=2, seed=seed, rate=rate))
        patch.setattr("optimus.run.CORRECTION_SHARE", 0.0)
        patch.setattr("optimus.run._films", lambda *_: [])
        run(config)
    return config


def test_a_run_with_another_arm_says_so_wherever_it_matters(with_another_arm: RunConfig) -> None:
    out = with_another_arm.out
    for folder in ("data", "corrections"):
        store = EpisodeStore.open(out / folder)
        assert (store.robot, store.control) == ("ur5e", "joint")
    for folder in ("first", "policy"):
        inputs = checkpoint.load(out / folder).inputs
        # six joints and the gripper, where the Panda has seven
        assert (inputs.robot, inputs.control, inputs.actions) == ("ur5e", "joint", 7)
    assert "--control joint --robot ur5e" in (out / "report.html").read_text()
    with pytest.raises(DatasetError, match="robot = 'ur5e', not \"the task's own\""):
        run(replace(with_another_arm, robot=None))
    with pytest.raises(DatasetError, match="control = 'joint', not 'osc'"):
        run(replace(with_another_arm, control="osc"))


def test_a_policy_is_evaluated_with_its_own_arm_alone(
    with_another_arm: RunConfig, taught: tuple[Path, Path], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    policy = with_another_arm.out / "policy"
    assert trained_robot(policy) == trained_robot(policy, robot("ur5e")) == robot("ur5e")
    assert trained_robot(taught[1]) is None and trained_robot(taught[1], PANDA) == PANDA
    with pytest.raises(CheckpointError, match=r"with robot panda .*, not ur5e"):
        trained_robot(taught[1], robot("ur5e"))

    def evaluate(*args: str) -> str:
        monkeypatch.setattr(sys, "argv", ["optimus", "evaluate", str(policy), "--episodes", "1", "--workers", "1", *args])
        try:
            main()
        except SystemExit as stop:
            assert stop.code == 2
        said = capsys.readouterr()
        return said.out or said.err.splitlines()[-1]

    assert "of 1 (" in evaluate("--dataset", str(with_another_arm.out / "data"))
    assert "with robot ur5e, not panda" in evaluate("--states", "random", "--robot", "panda")
    assert "robot = \"the task's own\"" in evaluate("--dataset", str(taught[0]))


def test_arms_do_not_mix_in_corrections(with_another_arm: RunConfig, tmp_path: Path) -> None:
    out = with_another_arm.out
    with pytest.raises(CheckpointError, match="with robot ur5e, not panda"):
        collect(CollectConfig("stack", tmp_path / "c", 1, turns=Turns(out / "policy"), control="joint"))
    open_dataset(CollectConfig("stack", tmp_path / "d", 1, control="joint"))
    with pytest.raises(DatasetError, match="robot = \"the task's own\", not 'ur5e'"):
        train(out / "data", tmp_path / "r", TrainConfig(steps=1), corrections=tmp_path / "d")


def test_an_arm_without_a_name_needs_its_file(with_another_arm: RunConfig, tmp_path: Path) -> None:
    policy, mine = tmp_path / "policy", replace(robot("ur5e"), name="mine")
    shutil.copytree(with_another_arm.out / "policy", policy)
    config = json.loads((policy / "config.json").read_text())
    config["inputs"]["robot"] = "mine"
    (policy / "config.json").write_text(json.dumps(config))
    with pytest.raises(CheckpointError, match=r"with robot mine, not panda .* --robot"):
        trained_robot(policy)
    assert trained_robot(policy, mine) == mine


def test_a_run_from_before_arms_were_recorded_goes_on(tmp_path: Path) -> None:
    config = RunConfig("stack", tmp_path)
    journal = {"config": {k: v for k, v in config.about.items() if k not in ("control", "robot")}, "seconds": {}}
    (tmp_path / "run.json").write_text(json.dumps(journal))
    assert Journal(config).value["config"] == config.about
    with pytest.raises(DatasetError, match="robot"):
        Journal(replace(config, robot=robot("ur5e")))
    for damaged in ("", '{"seconds": {}}', "[1]"):
        (tmp_path / "run.json").write_text(damaged)
        for reader in (lambda: Journal(config), lambda: summary_of(tmp_path)):
            with pytest.raises(DatasetError, match=r"run\.json"):
                reader()


def test_what_makes_no_sense_is_refused_before_anything_is_written(tmp_path: Path) -> None:
    def refused(**asked: Any) -> str:
        with pytest.raises(OptimusError) as caught:
            run(RunConfig("stack", tmp_path / "out", **asked))
        assert not (tmp_path / "out").exists()
        return str(caught.value)

    assert "minutes: nan" in refused(minutes=math.nan) and "minutes: inf" in refused(minutes=math.inf)
    assert "episodes: 0 is not 1 or more" in refused(episodes=0)
    assert "demonstrations: 0 is not 1 or more" in refused(demonstrations=0)
    assert "0 to 1 of the episodes, not in 2" in refused(mishaps=2.0)


def test_a_folder_may_be_renamed_and_its_command_is_the_one_that_was_typed(tmp_path: Path) -> None:
    asked = RunConfig("stack", tmp_path / "a run", 5, demonstrations=8, episodes=4, corrections=True)
    Journal(asked)
    words = shlex.split(_command(Journal(asked).value["config"]))
    assert words[:6] == ["optimus", "run", "stack", "--minutes", "5", "--out"] and words[6] == "a run"
    assert {"--corrections", "--demonstrations", "--episodes"} <= set(words)
    (tmp_path / "a run").rename(tmp_path / "other")
    assert Journal(replace(asked, out=tmp_path / "other")).value["config"]["out"] == "other"
