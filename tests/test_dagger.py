"""DAgger: the planner teaches from the policy's states; a run that was stopped anywhere ends as if it had not been."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest

from optimus.cli import main
from optimus.collect import CollectConfig, collect
from optimus.dagger import DaggerConfig, dagger
from optimus.data.curate import curate
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError
from optimus.exchange.robomimic import RobomimicConfig, export_robomimic
from optimus.exchange.robomimic_import import import_robomimic
from optimus.learn.gradient import LossConfig, Runtime
from optimus.learn.presets import preset
from optimus.learn.train import TrainConfig
from optimus.rerender import RenderConfig, rerender
from optimus.statistics import wilson
from optimus.tasks.stack import STACK
from test_train import Stop, assert_same_bits

LESSON = TrainConfig(steps=2, loss=LossConfig(runs=2), evaluations=1, held_out_runs=2, runtime=Runtime(1, False))
ROUNDS = DaggerConfig(rounds=1, episodes=2, evaluations=1, workers=1)


@pytest.fixture(scope="module", autouse=True)
def short() -> Iterator[None]:
    """A policy that has learned nothing is not watched for long, and soon the expert acts alone."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("optimus.tasks.stack.STACK", replace(STACK, horizon=160))
        patch.setattr("optimus.dagger.ALONE_FROM", 0.3)
        yield


@pytest.fixture(scope="module")
def whole(taught: tuple[Path, Path], tmp_path_factory: pytest.TempPathFactory) -> Path:
    run = tmp_path_factory.mktemp("dagger") / "run"
    dagger(taught[0], run, LESSON, ROUNDS)
    return run


def bytes_of(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def test_each_round_adds_answers_and_says_what_it_was_worth(taught: tuple[Path, Path], whole: Path) -> None:
    report = json.loads((whole / "dagger.json").read_text())
    before, after = report["rounds"]
    assert after["demonstrations"] == before["demonstrations"] + 2
    for row in (before, after):
        found = row["success"]
        assert found["episodes"] == 1 and tuple(found["interval"]) == wilson(found["successes"], 1)
    added = EpisodeStore.open(whole / "dagger" / "1" / "data")
    assert len(added.seeds) == 2 and added.config["turns"]["policy"] == "run"
    episodes = [added.read(seed) for seed in added.seeds]
    others = [np.any(e.actions != e.executed, axis=1).mean() for e in episodes]
    assert after["share_not_by_expert"] == pytest.approx(np.mean(others)) and 0 < after["share_not_by_expert"] < 1
    assert all(e.success for e in episodes)
    config = json.loads((whole / "dagger" / "1" / "policy" / "config.json").read_text())
    assert config["dataset"]["episodes"] == after["demonstrations"]
    assert config["train"]["rate"]["first"] == pytest.approx(LESSON.rate.first * 2 / 3)


def test_stopped_in_every_stage_it_ends_the_same(taught: tuple[Path, Path], whole: Path, tmp_path: Path) -> None:
    data, run = bytes_of(taught[0]), tmp_path / "run"
    seen: set[str] = set()

    def stop(stage: str, done: int, total: int, notes: dict[str, str]) -> None:
        if done >= 1 and stage not in seen:
            seen.add(stage)
            raise Stop

    for _ in range(9):
        try:
            dagger(taught[0], run, LESSON, ROUNDS, stop)
            break
        except Stop:
            continue
    assert seen == {"train", "round 0: evaluate", "round 1: correct", "round 1: train", "round 1: evaluate"}
    assert json.loads((run / "dagger.json").read_text()) == json.loads((whole / "dagger.json").read_text())
    assert_same_bits(run / "dagger" / "1" / "policy", whole / "dagger" / "1" / "policy")
    mine, theirs = (EpisodeStore.open(r / "dagger" / "1" / "data") for r in (run, whole))
    assert mine.seeds == theirs.seeds
    for seed in mine.seeds:
        np.testing.assert_array_equal(mine.read(seed).actions, theirs.read(seed).actions)
    assert bytes_of(taught[0]) == data  # the demonstrations are never touched
    with pytest.raises(DatasetError, match=r"episodes = 2, not 3"):
        dagger(taught[0], run, LESSON, replace(ROUNDS, episodes=3))


def test_a_policy_that_is_told_is_corrected_without_images(tmp_path: Path) -> None:
    """Nothing is rendered, and what the policy was told stands in the episodes once, as the places of the objects."""
    collect(CollectConfig("stack", tmp_path / "data", 4, workers=1, images=False))
    curate(tmp_path / "data")
    told = replace(preset("quick-mlp").policy, observe="state")
    dagger(tmp_path / "data", tmp_path / "run", LESSON, ROUNDS, policy=told)
    added = EpisodeStore.open(tmp_path / "run" / "dagger" / "1" / "data")
    episodes = [added.read(seed) for seed in added.seeds]
    assert added.cameras == () and len(episodes) == 2
    assert any(np.any(e.actions != e.executed) for e in episodes)
    shown = EpisodeStore.open(tmp_path / "data")
    assert all(e.observations.keys() == shown.read(shown.seeds[0]).observations.keys() for e in episodes)


def test_what_rounds_cannot_add_to_is_refused_before_anything_is_trained(taught: tuple[Path, Path], tmp_path: Path) -> None:
    export_robomimic(taught[0], tmp_path / "d.hdf5", RobomimicConfig(states=False))
    with h5py.File(tmp_path / "d.hdf5", "r+") as file:
        del file["data"].attrs["optimus"]
    import_robomimic(tmp_path / "d.hdf5", tmp_path / "imported")
    rerender(taught[0], tmp_path / "one", RenderConfig(cameras=("agentview",)), workers=1)
    for folder, why in (("imported", "was imported"), ("one", "is seen by agentview, what rounds add by agentview, robot0")):
        with pytest.raises(DatasetError, match=why):
            dagger(tmp_path / folder, tmp_path / "run", LESSON, ROUNDS)
        assert not (tmp_path / "run").exists()


def test_as_many_plain_demonstrations_instead(
    taught: tuple[Path, Path], whole: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    report = dagger(taught[0], whole, LESSON, replace(ROUNDS, plain=True))
    told = json.loads((whole / "dagger.json").read_text())
    assert [row["demonstrations"] for row in report["rounds"]] == [row["demonstrations"] for row in told["rounds"]]
    assert report["rounds"][0]["success"] == told["rounds"][0]["success"]  # both begin with the same policy
    store = EpisodeStore.open(whole / "plain" / "1" / "data")
    assert "turns" not in store.config and store.config["expert"] == EpisodeStore.open(taught[0]).config["expert"]
    assert all("pick" in store.header(seed).skeleton for seed in store.seeds)
    two = ["optimus", "train", str(taught[0]), str(taught[0]), "--out", str(whole), "--dagger", "1"]
    monkeypatch.setattr(sys, "argv", two)
    with pytest.raises(SystemExit):
        main()
    assert "--dagger takes one dataset" in capsys.readouterr().err
    monkeypatch.setattr("sys.argv", ["optimus", "train", str(taught[0]), "--out", str(whole), "--dagger-plain"])
    with pytest.raises(SystemExit):
        main()
    assert "with --dagger ROUNDS" in capsys.readouterr().err
