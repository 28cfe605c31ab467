"""Training: it learns, keeps to its plan, and goes on after any kill as if nothing had been."""

from __future__ import annotations

import json
import math
import os
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st
from safetensors.numpy import load_file

from optimus.data.curate import curate, load_curation
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import CheckpointError, DatasetError
from optimus.learn import checkpoint, metrics
from optimus.learn.checkpoint import load
from optimus.learn.encoder import EncoderConfig
from optimus.learn.gradient import GradientWorkers, LossConfig, Runtime, batch_loss
from optimus.learn.policy import PolicyConfig, PolicyInputs
from optimus.learn.schedule import RateConfig, StepPlan
from optimus.learn.state import OptimiserConfig, TrainState
from optimus.learn.train import Progress, TrainConfig, TrainingError, fresh_policy, train
from optimus.learn.trunk import TransformerConfig
from synthetic import CAMERAS, make_dataset, make_episode

torch.set_num_threads(1)  # tests run in several processes

SMALL = PolicyConfig(
    crop=60,
    encoder=EncoderConfig(channels=(8, 16), kernels=(8, 3), strides=(4, 2), keypoints=8, features=16),
    trunk=TransformerConfig(width=32, layers=1, heads=2),
)
QUICK = TrainConfig(
    steps=24,
    loss=LossConfig(runs=4, location_weight=0.5),
    evaluations=2,
    held_out_runs=4,
    checkpoint_seconds=0.0,
    runtime=Runtime(shards=2, half=False),
)


@pytest.fixture(scope="module")
def dataset(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return make_dataset(tmp_path_factory.mktemp("data"), 4, 12).path


@pytest.fixture(scope="module")
def uninterrupted(dataset: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    run = tmp_path_factory.mktemp("whole") / "run"
    train(dataset, run, QUICK, SMALL)
    return run


class Stop(Exception):
    """Ends a run from within its progress callback."""


def files_of(run: Path) -> dict[str, dict[str, np.ndarray]]:
    """All tensors of a run."""
    files = [run / "model.safetensors", run / "best" / "model.safetensors", *sorted((run / "train_state").glob("*.safetensors"))]
    return {str(file.relative_to(run)): load_file(file) for file in files}


def assert_same_bits(run: Path, other: Path) -> None:
    first, second = files_of(run), files_of(other)
    assert first.keys() == second.keys()
    for file, tensors in first.items():
        assert tensors.keys() == second[file].keys()
        for name, value in tensors.items():
            assert value.tobytes() == second[file][name].tobytes(), (file, name)


def test_a_finished_run_is_complete(uninterrupted: Path, dataset: Path) -> None:
    assert sorted(p.name for p in uninterrupted.iterdir()) == [
        "README.md",
        "best",
        "config.json",
        "metrics.jsonl",
        "model.safetensors",
        "tensorboard",
        "train_state",
    ]
    lines = metrics.read(uninterrupted)
    assert [line["step"] for line in lines] == list(range(1, 25))
    measured = [line["step"] for line in lines if "held_out_action_error_mm" in line]
    assert measured == [12, 24]
    assert load(uninterrupted, task="square").inputs.cameras == ("front", "wrist")
    before = files_of(uninterrupted)
    train(dataset, uninterrupted, QUICK, SMALL)  # nothing is left to do
    assert before.keys() == files_of(uninterrupted).keys()


def test_the_same_seed_gives_the_same_bits(uninterrupted: Path, dataset: Path, tmp_path: Path) -> None:
    torch.manual_seed(123)  # the global state is of no influence, and is not touched
    state = torch.get_rng_state()
    train(dataset, tmp_path, QUICK, SMALL)
    assert torch.equal(state, torch.get_rng_state())
    assert_same_bits(tmp_path, uninterrupted)


def test_stopping_after_each_step_changes_nothing(uninterrupted: Path, dataset: Path, tmp_path: Path) -> None:
    def stop(progress: Progress) -> None:
        if progress.step % 7 == 0:
            raise Stop

    for _ in range(4):
        try:
            train(dataset, tmp_path, QUICK, SMALL, stop)
        except Stop:
            continue
    assert_same_bits(tmp_path, uninterrupted)
    assert [line["step"] for line in metrics.read(tmp_path)] == list(range(1, 25))


def test_a_session_that_the_callback_ends_loses_nothing(uninterrupted: Path, dataset: Path, tmp_path: Path) -> None:
    def stop(progress: Progress) -> None:
        if progress.step == 10:
            raise Stop

    seldom = replace(QUICK, checkpoint_seconds=1000.0)
    with pytest.raises(Stop):
        train(dataset, tmp_path, seldom, SMALL, stop)
    assert [file.name for file in (tmp_path / "train_state").iterdir()] == ["00000010.safetensors"]
    train(dataset, tmp_path, seldom, SMALL)
    assert_same_bits(tmp_path, uninterrupted)


def test_a_budget_of_minutes_is_kept_to_when_the_pace_changes(dataset: Path, tmp_path: Path) -> None:
    """Slower than was measured at the start: the plan is revised, however long a checkpoint takes to write."""

    def slow(progress: Progress) -> None:
        time.sleep(0.05)

    began = time.perf_counter()
    train(dataset, tmp_path, replace(QUICK, steps=None, minutes=0.1, checkpoint_seconds=60.0), SMALL, slow)
    assert 4 < time.perf_counter() - began < 12
    last = metrics.read(tmp_path)[-1]
    assert last["step"] == last["steps"] < 150


CHILD = """
import sys; sys.path.insert(0, {tests!r})
from test_train import QUICK, SMALL, train
train({dataset!r}, {run!r}, QUICK, SMALL, lambda p: print(p.step, flush=True))
assert "torch._dynamo" not in sys.modules, "the compiler is loaded: seconds of every start"
"""


def test_killed_at_random_moments_it_ends_with_the_same_bits(uninterrupted: Path, dataset: Path, tmp_path: Path) -> None:
    rng = np.random.default_rng(0)
    run = tmp_path / "run"
    script = CHILD.format(tests=str(Path(__file__).parent), dataset=str(dataset), run=str(run))
    for _ in range(2):
        child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
        assert child.stdout is not None
        for _ in range(int(rng.integers(2, 6))):  # a few steps, then somewhere within one
            child.stdout.readline()
        time.sleep(rng.uniform(0, 0.05))
        child.send_signal(signal.SIGKILL)
        child.wait()
        child.stdout.close()
    subprocess.run([sys.executable, "-c", script], check=True, stdout=subprocess.DEVNULL)
    assert_same_bits(run, uninterrupted)
    assert [p.name for p in run.rglob("*.tmp-*")] == []


def test_a_run_goes_on_only_with_the_same_settings(uninterrupted: Path, dataset: Path) -> None:
    other = TrainConfig(**{**vars(QUICK), "seed": 1})
    with pytest.raises(CheckpointError, match=r"train\.seed = 0, not 1"):
        train(dataset, uninterrupted, other, SMALL)


def test_without_its_state_training_begins_anew(dataset: Path, tmp_path: Path) -> None:
    short = replace(QUICK, steps=2, evaluations=1)
    train(dataset, tmp_path, short, SMALL)
    shutil.rmtree(tmp_path / "train_state")
    (tmp_path / "best" / "config.json").write_text("of a training that is gone")
    train(dataset, tmp_path, short, SMALL)
    assert [line["step"] for line in metrics.read(tmp_path)] == [1, 2]
    assert checkpoint.best_step(tmp_path) == 2


def test_a_damaged_training_state_is_named(dataset: Path, tmp_path: Path) -> None:
    train(dataset, tmp_path, TrainConfig(**{**vars(QUICK), "steps": 2}), SMALL)
    state = tmp_path / "train_state" / "00000002.safetensors"
    state.write_bytes(state.read_bytes()[:500])
    with pytest.raises(CheckpointError, match=r"00000002\.safetensors is damaged"):
        train(dataset, tmp_path, TrainConfig(**{**vars(QUICK), "steps": 2}), SMALL)


def test_a_loss_that_is_not_finite_stops_the_run(dataset: Path, tmp_path: Path) -> None:
    wild = TrainConfig(**{**vars(QUICK), "rate": RateConfig(first=1e30, warm_up=0)})
    with pytest.raises(TrainingError, match="no longer finite"):
        train(dataset, tmp_path, wild, SMALL)
    assert all(np.isfinite(v).all() for v in load_file(tmp_path / "model.safetensors").values())


def test_data_that_was_not_curated_is_an_error(tmp_path: Path) -> None:
    store = EpisodeStore.create(tmp_path / "data", "square", ("front", "wrist"), {})
    store.write(make_episode(0))
    with pytest.raises(DatasetError, match="curate it first"):
        train(store.path, tmp_path / "run")


def test_a_budget_of_minutes_is_kept(dataset: Path, tmp_path: Path) -> None:
    config = TrainConfig(**{**vars(QUICK), "steps": None, "minutes": 0.08})
    start = time.perf_counter()
    train(dataset, tmp_path, config, SMALL)
    assert 2.4 < time.perf_counter() - start < 9.6  # of 4.8 s, on a machine that others use too
    assert metrics.read(tmp_path)[-1]["steps"] == metrics.read(tmp_path)[-1]["step"]


def test_epochs_are_passes_over_the_training_episodes(dataset: Path, tmp_path: Path) -> None:
    config = replace(QUICK, steps=None, epochs=2.5)
    train(dataset, tmp_path / "epochs", config, SMALL)
    store = EpisodeStore.open(dataset)
    actions = sum(len(store.read(seed).actions) for seed in load_curation(dataset).train)
    labels = 4 * SMALL.context  # of the 4 windows in a batch, at each of their frames
    steps = metrics.read(tmp_path / "epochs")[-1]["step"]
    assert steps == math.ceil(2.5 * actions / labels)
    train(dataset, tmp_path / "steps", replace(config, steps=int(steps), epochs=None), SMALL)
    assert_same_bits(tmp_path / "epochs", tmp_path / "steps")


def test_the_first_demonstrations_alone_are_learned_from(dataset: Path, tmp_path: Path) -> None:
    train(dataset, tmp_path / "first", replace(QUICK, demonstrations=2), SMALL)
    # by itself: the same episodes, and nobody knows of the others
    alone = tmp_path / "alone"
    shutil.copytree(dataset, alone)
    curation = json.loads((alone / "curation.json").read_text())
    curation["train"] = curation["train"][:2]
    (alone / "curation.json").write_text(json.dumps(curation))
    train(alone, tmp_path / "run", QUICK, SMALL)
    assert_same_bits(tmp_path / "first", tmp_path / "run")


def test_a_run_goes_on_only_with_the_same_split(dataset: Path, tmp_path: Path) -> None:
    data = Path(shutil.copytree(dataset, tmp_path / "data"))
    train(data, tmp_path / "run", replace(QUICK, steps=2), SMALL)
    curation = json.loads((data / "curation.json").read_text())
    curation["train"], curation["validation"] = [*curation["train"][1:], curation["validation"][0]], curation["train"][:1]
    (data / "curation.json").write_text(json.dumps(curation))
    with pytest.raises(CheckpointError, match="split"):
        train(data, tmp_path / "run", replace(QUICK, steps=2), SMALL)


def test_a_run_of_an_earlier_version_that_kept_no_split_goes_on(dataset: Path, tmp_path: Path) -> None:
    train(dataset, tmp_path, replace(QUICK, steps=2), SMALL)
    config = json.loads((tmp_path / "config.json").read_text())
    del config["dataset"]["split"], config["train"]["demonstrations"]
    (tmp_path / "config.json").write_text(json.dumps(config))
    train(dataset, tmp_path, replace(QUICK, steps=2), SMALL)


def test_a_policy_of_an_earlier_version_that_did_not_aim_is_trained_on(dataset: Path, tmp_path: Path) -> None:
    """And one that does is not, with data that do not tell where the hand is."""
    train(dataset, tmp_path / "old", replace(QUICK, steps=2), replace(SMALL, aims=False))
    config = json.loads((tmp_path / "old" / "config.json").read_text())
    del config["policy"]["aims"], config["inputs"]["keypose"]
    (tmp_path / "old" / "config.json").write_text(json.dumps(config))
    assert not train(dataset, tmp_path / "on", replace(QUICK, steps=2), SMALL, initial=tmp_path / "old").aims
    store = EpisodeStore.create(tmp_path / "handless", "square", CAMERAS, {"position_scale": 1.0})
    for seed in range(4):
        episode = make_episode(seed, 12)
        seen = {name: array for name, array in episode.observations.items() if name != "robot0_eef_quat"}
        store.write(replace(episode, observations=seen))
    curate(store.path)
    assert train(dataset, tmp_path / "new", replace(QUICK, steps=2), SMALL).aims
    assert not train(store.path, tmp_path / "without", replace(QUICK, steps=2), SMALL).aims
    with pytest.raises(CheckpointError, match="proprioception"):
        train(store.path, tmp_path / "never", replace(QUICK, steps=2), SMALL, initial=tmp_path / "new")


def test_what_cannot_be_learned_together_is_refused(dataset: Path, tmp_path: Path) -> None:
    blind = make_dataset(tmp_path / "blind", 4, 12, cameras=())
    with pytest.raises(DatasetError, match="holds no images"):
        train(blind.path, tmp_path / "run", QUICK, SMALL)
    continuous = Path(shutil.copytree(dataset, tmp_path / "continuous"))
    about = json.loads((continuous / "dataset.json").read_text())
    about["config"]["gripper"] = "continuous"
    (continuous / "dataset.json").write_text(json.dumps(about))
    for others in ({"dataset": [dataset, continuous]}, {"dataset": dataset, "corrections": continuous}):
        with pytest.raises(DatasetError, match="gripper"):
            train(**others, run=tmp_path / "run", config=QUICK, policy=SMALL)  # type: ignore[arg-type]


@pytest.mark.parametrize("count", [0, 4])
def test_more_demonstrations_than_there_are_is_an_error(count: int, dataset: Path, tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match=f"has 3 demonstrations to train on, not {count}; ask for 1 to 3"):
        train(dataset, tmp_path, replace(QUICK, demonstrations=count), SMALL)


@given(steps=st.integers(2, 1000), left=st.floats(1, 100), pace=st.floats(0.01, 1), data=st.data())
def test_progress_never_jumps_and_ends_at_one(steps: int, left: float, pace: float, data: st.DataObject) -> None:
    step = data.draw(st.integers(0, steps - 1))
    plan = StepPlan(steps)
    revised = plan.revised(step, left, pace)
    assert revised.at(step) == pytest.approx(plan.at(step))
    assert revised.at(revised.steps) == 1
    rates = [RateConfig(warm_up=0).at(s, revised.at(s)) for s in range(step, revised.steps + 1)]
    assert all(b <= a for a, b in pairwise(rates))
    assert rates[-1] == pytest.approx(1e-4)


def test_the_gradient_of_threads_is_that_of_autograd(dataset: Path) -> None:
    """Shards are means of equal size, so their mean is the gradient of the mean of their losses."""
    windows = Windows(EpisodeStore.open(dataset), range(4), WindowConfig(crop=60))
    policy = fresh_policy(SMALL, PolicyInputs.of("square", windows), 0)
    workers = GradientWorkers(policy, windows, LossConfig(runs=4), Runtime(2, False), seed=5)
    _, gradient = workers.gradient(3)
    workers.close()
    total = torch.zeros(())
    for shard in range(2):
        batch = windows.sample(np.random.default_rng([5, 3, shard]), 2)
        noise = torch.Generator().manual_seed(int(np.random.SeedSequence([5, 3, shard]).generate_state(1)[0]))
        likelihood, location = batch_loss(policy, batch, LossConfig(runs=4), noise, False)
        total = total + (likelihood + LossConfig().location_weight * location) / 2
    total.backward()
    for parameter, part in zip(policy.parameters(), gradient, strict=True):
        expected = torch.zeros_like(parameter) if parameter.grad is None else parameter.grad
        torch.testing.assert_close(part, expected, atol=1e-5, rtol=1e-4)


def test_it_learns_to_read_the_place_of_the_square(tmp_path: Path) -> None:
    """Only the image says where to go: an answer that ignores it is off by some 100 mm."""
    dataset = make_dataset(tmp_path / "data", 400, 3).path
    config = TrainConfig(
        steps=140,
        loss=LossConfig(runs=16),
        evaluations=1,
        held_out_runs=60,
        optimiser=OptimiserConfig(average=0.95),
        runtime=Runtime(len(os.sched_getaffinity(0)), half=False),
    )
    train(dataset, tmp_path / "run", config, PolicyConfig(context=2))
    last = metrics.read(tmp_path / "run")[-1]
    assert last["held_out_location_error_mm"] < 20
    assert last["held_out_aim_error_mm"] < 20  # where the hand will be; an answer that ignores the image is off by some 50 mm
    assert last["held_out_action_error_mm"] < 20
    assert math.isfinite(last["held_out_likelihood"])


def test_a_step_moves_every_weight_against_its_own_gradient(dataset: Path) -> None:
    """Whatever the memory layout of weights and gradients: the first step of Adam has the sign of the gradient, negated."""
    windows = Windows(EpisodeStore.open(dataset), range(4), WindowConfig(crop=60))
    policy = fresh_policy(SMALL, PolicyInputs.of("synthetic", windows), 0)
    before = [p.detach().clone() for p in policy.parameters()]
    noise = torch.Generator().manual_seed(0)
    gradient = [torch.randn(p.shape, generator=noise) for p in before]
    TrainState(policy, OptimiserConfig(weight_decay=0.0), StepPlan(10)).update(gradient, 1e-2)
    for old, new, g in zip(before, policy.parameters(), gradient, strict=True):
        moved = (new.detach() - old).flatten()
        assert bool((torch.sign(moved) == -torch.sign(g.flatten())).all()), tuple(old.shape)
