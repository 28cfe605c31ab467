"""Recipes, the best checkpoint, what can be watched, and several data sets in one policy."""

from __future__ import annotations

import io
import json
import math
import shutil
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import torch
from safetensors.numpy import load_file
from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

from optimus.cli import main
from optimus.dagger import DaggerConfig, dagger
from optimus.data.curate import curate, load_curation
from optimus.data.lock import locked
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import CheckpointError, DatasetError, OptimusError, StorageError, UnknownNameError
from optimus.learn import checkpoint, metrics
from optimus.learn.board import BoardError
from optimus.learn.gradient import LossConfig
from optimus.learn.heldout import held_out
from optimus.learn.policy import PolicyInputs
from optimus.learn.recipe import recipe
from optimus.learn.schedule import RateConfig, StepPlan
from optimus.learn.state import OptimiserConfig, TrainState
from optimus.learn.train import Progress, fresh_policy, train
from synthetic import CAMERAS, make_dataset, make_episode
from test_train import QUICK, SMALL, Stop

torch.set_num_threads(1)


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_dataset(tmp_path_factory.mktemp("data"), 4, 12).path


WIDE: dict[str, Any] = {name: np.zeros((12, 8), np.float32) for name in ("actions", "executed")}


def other_dataset(
    path: Path, task: str = "two-squares", objects: int = 2, config: dict[str, Any] | None = None, **changes: Any
) -> Path:
    """A curated dataset of another task, with another number of objects."""
    cameras = changes.get("cameras", CAMERAS)
    store = EpisodeStore.create(path, task, cameras, config or {"position_scale": 1.0})
    for seed in range(3):
        episode = make_episode(seed, 12, task, **changes)
        store.write(replace(episode, objects=np.repeat(episode.objects, objects, 1), object_names=tuple("ab"[:objects])))
    curate(path)
    return path


def test_the_papers_recipe_is_its_table() -> None:
    """Table D.1 and Section D, as printed."""
    paper = recipe("paper")
    rates = [paper.rate.at(step, StepPlan(1_000_000).at(step)) for step in (0, 50_000, 100_000, 999_999)]
    assert rates == pytest.approx([1e-4, 5.5e-5, 1e-5, 1e-5], rel=1e-9)
    assert (paper.steps, paper.loss.runs, paper.optimiser.weight_decay, paper.optimiser.clip) == (1_000_000, 16, 0.01, 1.0)
    assert paper.loss.labels(WindowConfig()) == 16
    with pytest.raises(UnknownNameError, match="valid: gpu, paper, quick"):
        recipe("slow")


@pytest.mark.parametrize("clip", [1.0, 1e9])
def test_a_step_of_the_papers_recipe_is_torchs_own(dataset: Path, clip: float) -> None:
    windows = Windows(EpisodeStore.open(dataset), range(4), WindowConfig(crop=60))
    policy, plain = (fresh_policy(SMALL, PolicyInputs.of("square", windows), 0) for _ in range(2))
    state = TrainState(policy, replace(recipe("paper").optimiser, clip=clip), StepPlan(10))
    optimiser = torch.optim.AdamW(plain.parameters(), lr=1e-4, weight_decay=0.01)
    noise = torch.Generator().manual_seed(0)
    for _ in range(3):
        gradient = [torch.randn(p.shape, generator=noise) for p in plain.parameters()]
        state.update([g.clone() for g in gradient], 1e-4)
        for parameter, g in zip(plain.parameters(), gradient, strict=True):
            parameter.grad = g
        torch.nn.utils.clip_grad_norm_(plain.parameters(), clip)
        optimiser.step()
    for mine, theirs, kept in zip(policy.parameters(), plain.parameters(), state.average.parameters(), strict=True):
        torch.testing.assert_close(mine, theirs, rtol=1e-5, atol=1e-7)
        assert torch.equal(mine, kept)  # without a running average the newest weights are kept


def test_the_best_policy_is_the_one_of_the_lowest_held_out_error(dataset: Path, tmp_path: Path) -> None:
    # a rate that grows out of all bounds: the last policy is not the best
    rate = RateConfig(first=1e-3, last=0.3, warm_up=0, shape="linear")
    wild = replace(QUICK, steps=20, evaluations=10, rate=rate, optimiser=OptimiserConfig(average=0.0))
    train(dataset, tmp_path, wild, SMALL)
    lines = [line for line in metrics.read(tmp_path) if "held_out_action_error" in line]
    errors = [line["held_out_action_error"] for line in lines]
    assert len(lines) == 10 and np.argmin(errors) < 9
    assert checkpoint.best_step(tmp_path) == lines[int(np.argmin(errors))]["step"]
    windows = Windows(EpisodeStore.open(dataset), load_curation(dataset).validation, WindowConfig(crop=60))
    policies = [checkpoint.load(run) for run in (tmp_path / "best", tmp_path)]
    measured = [held_out(policy, windows, QUICK.held_out_runs)["action_error"] for policy in policies]
    assert measured == pytest.approx([min(errors), errors[-1]], rel=1e-5)


def test_a_best_policy_lost_to_a_kill_is_made_good(dataset: Path, tmp_path: Path) -> None:
    train(dataset, tmp_path, replace(QUICK, evaluations=1), SMALL)
    kept = load_file(tmp_path / "best" / "model.safetensors")
    shutil.rmtree(tmp_path / "best")
    train(dataset, tmp_path, replace(QUICK, evaluations=1), SMALL)
    again = load_file(tmp_path / "best" / "model.safetensors")
    assert all(value.tobytes() == again[name].tobytes() for name, value in kept.items())


def test_tensorboard_shows_what_was_reported_once_and_after_a_kill(dataset: Path, tmp_path: Path) -> None:
    late = replace(QUICK, checkpoint_seconds=1e9, evaluations=3)  # saved at evaluations alone: steps 8, 16, 24

    def stop(progress: Any) -> None:
        if progress.step == 13:
            raise Stop

    with pytest.raises(Stop):
        train(dataset, tmp_path, late, SMALL, stop)
    train(dataset, tmp_path, late, SMALL)
    shown = EventAccumulator(str(tmp_path / "tensorboard"))
    shown.Reload()
    lines = metrics.read(tmp_path)
    assert [line["step"] for line in lines] == list(range(1, 25))
    for tag, name in (("train/loss", "loss"), ("train/rate", "rate"), ("held_out/likelihood", "held_out_likelihood")):
        expected = [(line["step"], line[name]) for line in lines if name in line]
        scalars = shown.Scalars(tag)
        assert [s.step for s in scalars] == [step for step, _ in expected], tag
        assert [s.value for s in scalars] == pytest.approx([value for _, value in expected], rel=1e-6)


def test_weights_and_biases_by_choice(dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    short, logged = replace(QUICK, steps=2), []
    monkeypatch.setattr("optimus.learn.board.find_spec", lambda name: None)
    with pytest.raises(BoardError, match="pip install wandb"):
        train(dataset, tmp_path / "a", short, SMALL, watch="wandb")
    assert not (tmp_path / "a").exists()
    monkeypatch.setattr("optimus.learn.board.find_spec", lambda name: "there")
    run = SimpleNamespace(log=lambda values, step: logged.append((step, values["train/loss"])), finish=lambda: logged.append("end"))
    monkeypatch.setitem(sys.modules, "wandb", SimpleNamespace(init=lambda **asked: run))
    train(dataset, tmp_path / "a", short, SMALL, watch="wandb")
    assert logged == [*((line["step"], line["loss"]) for line in metrics.read(tmp_path / "a")), "end"]
    assert not (tmp_path / "a" / "tensorboard").exists()


def test_one_policy_of_two_tasks(dataset: Path, tmp_path: Path) -> None:
    other = other_dataset(tmp_path / "other")
    policy = train((dataset, other), tmp_path / "run", QUICK, SMALL)
    assert policy.inputs.task == "square+two-squares" and policy.inputs.objects == 2
    for task in ("square", "two-squares"):
        assert checkpoint.load(tmp_path / "run", task=task).inputs == policy.inputs
    with pytest.raises(CheckpointError, match=r"square\+two-squares"):
        checkpoint.load(tmp_path / "run", task="circle")
    # the second object's place is that of the episodes which have one, and theirs alone
    seeds = json.loads((other / "curation.json").read_text())["train"]
    places = np.concatenate([EpisodeStore.open(other).read(seed).objects[:, 1] for seed in seeds])
    np.testing.assert_allclose(policy.objects_mean[3:].numpy(), places.mean(0), atol=1e-6)
    assert all(torch.isfinite(p).all() for p in policy.parameters())
    assert all(np.isfinite(list(line.values())).all() for line in metrics.read(tmp_path / "run"))
    with pytest.raises(CheckpointError, match="episodes = 5, not 3"):
        train(dataset, tmp_path / "run", QUICK, SMALL)


def test_data_sets_that_do_not_go_together(dataset: Path, tmp_path: Path) -> None:
    one_camera = other_dataset(tmp_path / "camera", cameras=("front",))
    with pytest.raises(DatasetError, match="cameras = 'front', not 'front, wrist'"):
        train((dataset, one_camera), tmp_path / "run", QUICK, SMALL)
    joint = other_dataset(tmp_path / "joint", config={"position_scale": 1.0, "control": "joint"})
    with pytest.raises(DatasetError, match="control = 'joint', not 'osc'"):
        train((dataset, joint), tmp_path / "run", QUICK, SMALL)
    arm = other_dataset(tmp_path / "arm", config={"position_scale": 1.0, "robot": "ur5e"})
    with pytest.raises(DatasetError, match="robot = 'ur5e'"):
        train((dataset, arm), tmp_path / "run", QUICK, SMALL)
    scale = other_dataset(tmp_path / "scale", config={"position_scale": 0.5})
    with pytest.raises(DatasetError, match=r"position_scale = 0.5, not 1.0"):
        train((dataset, scale), tmp_path / "run", QUICK, SMALL)
    wide = other_dataset(tmp_path / "wide", **WIDE)
    for sources, more in (((dataset, wide), ()), ((dataset,), (wide,))):
        with pytest.raises(DatasetError, match=r"actions has shape \(8,\)|collected for task 'two-squares'"):
            train(sources, tmp_path / "run", QUICK, SMALL, corrections=more)
    assert not (tmp_path / "run").exists()


def test_weights_to_begin_with_must_fit_the_data(dataset: Path, tmp_path: Path) -> None:
    train(dataset, tmp_path / "run", replace(QUICK, steps=1), SMALL)
    wide = other_dataset(tmp_path / "wide", "square", 1, **WIDE)
    with pytest.raises(CheckpointError, match="actions = 7, not 8"):
        train(wide, tmp_path / "more", QUICK, SMALL, initial=tmp_path / "run")
    one_camera = other_dataset(tmp_path / "camera", "square", 1, cameras=("front",))
    with pytest.raises(CheckpointError, match="cameras"):
        train(one_camera, tmp_path / "more", QUICK, SMALL, initial=tmp_path / "run")
    with pytest.raises(CheckpointError, match=r"inputs\.cameras|inputs\.task|dataset"):
        train(one_camera, tmp_path / "run", replace(QUICK, steps=1), SMALL)


def test_a_run_from_before_these_settings_goes_on(dataset: Path, tmp_path: Path) -> None:
    train(dataset, tmp_path, QUICK, SMALL)
    config = json.loads((tmp_path / "config.json").read_text())
    for name in ("accumulate", "device", "half"):
        del config["train"][name]
    for part, names in (("rate", ("shape", "over")), ("optimiser", ("decay_all", "clip_apart"))):
        for name in names:
            del config["train"][part][name]
    config["runtime"] = config["train"]["runtime"] = {"shards": 2, "half": False}
    (tmp_path / "config.json").write_text(json.dumps(config))
    train(dataset, tmp_path, QUICK, SMALL)
    with pytest.raises(CheckpointError, match=r"train\.accumulate = 1, not 2"):
        train(dataset, tmp_path, replace(QUICK, accumulate=2), SMALL)


NONSENSE: list[tuple[str, Any]] = [
    *(("steps", steps) for steps in (0, -3)),
    *(("epochs", epochs) for epochs in (0.0, -1.0, math.nan, math.inf)),
    *(("minutes", minutes) for minutes in (0.0, -1.0, math.nan, math.inf)),
    *(("accumulate", portions) for portions in (0, -1)),
    ("seed", -1),
]


@pytest.mark.parametrize(("name", "number"), NONSENSE)
def test_numbers_that_make_no_sense_are_refused(name: str, number: float) -> None:
    with pytest.raises(OptimusError, match=f"{name}: {number} is n"):
        replace(QUICK, **{name: number})


def test_averages_batches_and_rounds_that_make_no_sense_are_refused() -> None:
    for average in (-1.0, 1.0, 2.0, math.nan):
        with pytest.raises(OptimusError, match=f"ema: {average} is not 0 or more and less than 1"):
            OptimiserConfig(average=average)
    with pytest.raises(OptimusError, match="batch: 0 is not 1 or more"):
        LossConfig(runs=0)
    for rounds in (DaggerConfig, lambda n: DaggerConfig(1, episodes=n), lambda n: DaggerConfig(1, evaluations=n)):
        with pytest.raises(OptimusError, match="is not 1 or more"):
            rounds(0)


def test_a_run_has_a_folder_of_its_own_and_its_data_once(dataset: Path, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="holds a dataset"):
        train(dataset, dataset, QUICK, SMALL)
    with pytest.raises(DatasetError, match="named twice"):
        train((dataset, dataset), tmp_path / "run", QUICK, SMALL)
    run = tmp_path / "run"

    asked: list[int] = []

    def another(progress: Progress) -> None:
        asked.append(progress.step)
        with pytest.raises(StorageError, match="another process is at work"), locked(run):
            pass

    train(dataset, run, replace(QUICK, steps=1), SMALL, another)
    assert asked == [1] and not (run / ".lock").exists()
    with locked(run):
        pass


def test_weights_to_begin_with_bring_their_own_network(dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    train(dataset, tmp_path / "run", replace(QUICK, steps=1), SMALL)
    words = ["train", str(dataset), "--initial", str(tmp_path / "run"), "--preset", "quick-rnn", "--out", str(tmp_path / "more")]
    monkeypatch.setattr(sys, "argv", ["optimus", *words])
    monkeypatch.setattr(sys, "stderr", said := io.StringIO())
    with pytest.raises(SystemExit):
        main()
    assert "brings a network of its own" in said.getvalue() and not (tmp_path / "more").exists()


def test_a_damaged_curation_is_not_replaced(dataset: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """By other rules, other episodes would be held out."""
    data = tmp_path / "data"
    shutil.copytree(dataset, data)
    (data / "curation.json").write_text("{")
    monkeypatch.setattr(sys, "argv", ["optimus", "train", str(data), "--out", str(tmp_path / "run"), "--steps", "1"])
    monkeypatch.setattr(sys, "stderr", said := io.StringIO())
    with pytest.raises(SystemExit):
        main()
    assert "is damaged" in said.getvalue() and (data / "curation.json").read_text() == "{"


def test_rounds_need_a_robot_of_a_known_name(tmp_path: Path) -> None:
    data = other_dataset(tmp_path / "data", config={"position_scale": 1.0, "robot": "mine"}).resolve()
    with pytest.raises(DatasetError, match="robot 'mine', of whom rounds know the name alone"):
        dagger(data, tmp_path / "run", QUICK, DaggerConfig(1))
    assert not (tmp_path / "run").exists()
