"""Evaluation: the interval against scipy, the outcome against the number of workers."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import binomtest

from optimus.collect import CollectConfig, collect
from optimus.conditions import Conditions
from optimus.correct import Turns
from optimus.dagger import DaggerConfig, dagger
from optimus.data.curate import curate
from optimus.data.episode import Observation
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError, DatasetError
from optimus.evaluate import evaluate, play, policy_folder, random_starts, require_same_problems, validation_starts
from optimus.evaluate.trials import _Witness
from optimus.learn import checkpoint
from optimus.learn.agent import PolicyAgent
from optimus.learn.presets import preset
from optimus.learn.train import TrainConfig, train
from optimus.rerender import RenderConfig, rerender, with_images
from optimus.rollout import rollout
from optimus.scene import Camera
from optimus.statistics import wilson
from optimus.tasks import task


@given(st.integers(1, 200), st.floats(0, 1))
def test_wilson_interval_agrees_with_scipy(n: int, share: float) -> None:
    k = round(share * n)
    expected = binomtest(k, n).proportion_ci(0.95, "wilson")
    np.testing.assert_allclose(wilson(k, n), (expected.low, expected.high), atol=1e-4)


def test_outcome_files_are_the_same_from_one_environment_and_from_several(taught: tuple[Path, Path], tmp_path: Path) -> None:
    """Episodes end after few steps here; three processes share eight, or one process has all of them."""
    starts, short = random_starts(8), Conditions("push", friction=0.8, horizon=6)
    files = []
    for workers in (1, 3):
        folder = tmp_path / str(workers)
        folder.mkdir()
        report = evaluate(taught[1], starts, "random", workers=workers, conditions=short)
        report.write(folder)
        files.append({path.name: path.read_bytes() for path in folder.iterdir()})
    assert files[0] == files[1] and len(files[0]) == 2
    (lines,) = (text for name, text in files[0].items() if name.endswith(".jsonl"))
    outcomes = [json.loads(line) for line in lines.splitlines()]
    assert [o["seed"] for o in outcomes] == [s.seed for s in starts] and all(o["steps"] <= 6 for o in outcomes)
    assert all(bool(o["cause"]) != o["success"] for o in outcomes)


def test_last_and_best_checkpoints_are_told_apart(taught: tuple[Path, Path], tmp_path: Path) -> None:
    assert policy_folder(taught[1], "last") == taught[1]
    assert checkpoint.best_step(taught[1]) is not None
    assert checkpoint.read_config(policy_folder(taught[1], "best"))["best"]["step"] <= 3
    with pytest.raises(CheckpointError):
        policy_folder(tmp_path, "best")


def test_the_papers_rule_holds_once_the_goal_was_met_however_the_episode_ends() -> None:
    """An agent that puts the cube down, lets go without leaving, and takes it away again: by the paper's rule a success. If it only
    stays, the cause of its failure says so."""
    env = ManipulationEnv(task("stack"), images=False)
    episode = demonstrate(env, 11, ExpertConfig()).episode
    assert episode is not None
    grip = episode.executed[:, -1] > 0
    opens = int(np.flatnonzero(grip[:-1] & ~grip[1:])[-1]) + 1
    stay, take, lift = (np.array([0, 0, up, 0, 0, 0, shut], np.float32) for up, shut in ((0, -1), (0, 1), (0.3, 1)))
    staying = [*episode.executed[:opens], *[stay] * 25]

    class Playing:
        def __init__(self, actions: list[np.ndarray]) -> None:
            self.actions = iter(actions)

        def act(self, observation: Observation) -> np.ndarray | None:
            return next(self.actions, None)

    seen, _ = env.reset(seed=11, options={"state": episode.initial_state})
    taken = rollout(env, seen, Playing([*staying, *[take] * 8, *[lift] * 20]), "taking")
    assert taken.info["paper_success"] and not taken.success
    assert not env.problem.paper_success(env.state())
    witness = _Witness()
    seen, _ = env.reset(seed=11, options={"state": episode.initial_state})
    stayed = rollout(env, seen, Playing(staying), "staying", watch=witness)
    assert env.problem.paper_success(env.state()) and not stayed.success
    assert witness.cause(env, stayed).startswith("put down on the goal, the hand still there")


def test_validation_starts_are_those_of_the_demonstrations(taught: tuple[Path, Path]) -> None:
    data, run = taught
    start = validation_starts(data, 1)[0]
    episode, _ = play(run, start, seed=0)
    recorded = EpisodeStore.open(data).read(start.seed)
    np.testing.assert_array_equal(episode.initial_state, recorded.initial_state)
    for name in ("robot0_eef_pos", "agentview_image", "robot0_eye_in_hand_image"):
        np.testing.assert_array_equal(episode.observations[name][0], recorded.observations[name][0])


def test_a_recorded_demonstration_replays_to_the_same_success() -> None:
    env = ManipulationEnv(task("stack"), images=False)
    episode = demonstrate(env, 11, ExpertConfig()).episode
    assert episode is not None and episode.success
    env.reset(seed=11, options={"state": episode.initial_state})
    done = [env.step(action)[2] for action in episode.executed]
    assert done[-1] and not any(done[:-1])


SHORT = Conditions(horizon=3)


def test_interrupted_it_goes_on_and_ends_the_same(taught: tuple[Path, Path], tmp_path: Path) -> None:
    whole, run = evaluate(taught[1], random_starts(5), "random", workers=1, conditions=SHORT), tmp_path / "run"
    shutil.copytree(taught[1], run)

    def stop(done: int, successes: int) -> None:
        if done == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        evaluate(run, random_starts(5), "random", workers=1, progress=stop, conditions=SHORT, keep=True)
    (kept,) = run.glob("*.unfinished")
    lines = kept.read_text().splitlines(keepends=True)
    damaged = [*lines[:3], lines[3][:20] + "\n", '{"seed": 3}\n', "[]\n"]  # what a machine that went down may leave
    kept.write_text("".join(damaged) + '{"index": 3, "se')  # killed as it wrote
    seen: list[int] = []
    again = evaluate(run, random_starts(5), "random", workers=1, progress=lambda n, _: seen.append(n), conditions=SHORT, keep=True)
    assert again == whole and seen == [3, 4, 5]
    again.write(run)
    assert not list(run.glob("*.unfinished"))


def test_what_was_found_is_of_the_weights_that_it_says(taught: tuple[Path, Path], tmp_path: Path) -> None:
    run = tmp_path / "run"
    shutil.copytree(taught[1], run)
    starts, seeds = random_starts(2), [s.seed for s in random_starts(2)]
    first = evaluate(run, starts, "random", workers=1, conditions=SHORT)
    first.write(run)
    assert first.answered(run, seeds) == first.as_dict()
    assert first.answered(run, seeds[:1]) is None and replace(first, component="likeliest").answered(run, seeds) is None
    replace(first, outcomes=first.outcomes[:1]).write(run)  # a shorter look takes nothing away
    assert first.answered(run, seeds) == first.as_dict()
    lines = (run / first.file_name).with_suffix(".jsonl")
    assert lines.read_text() == first.lines
    replace(first, outcomes=first.outcomes[:1]).write(run)
    lines.unlink()  # killed between the two files
    first.write(run)
    assert first.answered(run, seeds) == first.as_dict() and lines.read_text() == first.lines
    policy = checkpoint.load(run)
    checkpoint.save(run, policy)  # perhaps in another order
    assert checkpoint.weights_of(run) == first.weights
    with torch.no_grad():
        next(policy.parameters()).add_(1.0)
    checkpoint.save(run, policy)
    second = evaluate(run, starts, "random", workers=1, conditions=SHORT)
    assert second.weights == checkpoint.weights_of(run) != first.weights and second.answered(run, seeds) is None
    with pytest.raises(CheckpointError, match="trained on meanwhile"):
        play(run, starts[0], 0, conditions=SHORT, weights=first.weights)
    (run / first.file_name).write_text('{"task": ')
    assert first.answered(run, seeds) is None
    names = {replace(first, component="likeliest").file_name, replace(first, seed=3).file_name, first.file_name}
    assert len(names) == 3


def test_a_policy_of_two_tasks_that_is_told_the_state_plays_both(tmp_path: Path) -> None:
    """Things and doors that one of them does not have are at the origin and shut, as in training."""
    tasks = ("pick-place", "microwave")
    for name in tasks:
        collect(CollectConfig(name, tmp_path / name, 2, workers=1, images=False))
        curate(tmp_path / name)
    told, run = preset("quick-mlp", observe="state").policy, tmp_path / "run"
    train([tmp_path / name for name in tasks], run, TrainConfig(steps=1), told)
    for name in tasks:
        assert evaluate(run, random_starts(1, task=name), "random", workers=1, conditions=SHORT).task == name
        assert evaluate(run, validation_starts(tmp_path / name, 1), "validation", workers=1, conditions=SHORT).task == name
    with pytest.raises(DatasetError, match="task = 'microwave', not 'pick-place'"):
        require_same_problems(run, tmp_path / "microwave", "pick-place")


def test_a_policy_sees_by_the_cameras_and_in_the_size_that_it_was_trained_on(taught: tuple[Path, Path], tmp_path: Path) -> None:
    large, run = tmp_path / "large", tmp_path / "run"
    aside = Camera("aside", (1.2, 0.6, 0.5), (0.5, 0.0, 0.05), 50.0)
    asked = RenderConfig(("robot0_eye_in_hand",), (aside,), size=96)
    rerender(taught[0], large, asked, workers=1)
    train(large, run, TrainConfig(steps=1))
    inputs = checkpoint.load(run).inputs
    assert inputs.frame == (96, 96) and inputs.cameras == ("robot0_eye_in_hand", "aside")
    episode, _ = play(run, random_starts(1)[0], 0, conditions=SHORT)
    assert episode.cameras == inputs.cameras and episode.observations["aside_image"].shape[1:] == (96, 96, 3)
    # what it saw is what `render` makes of the same states
    again = with_images(episode, asked)
    for camera in inputs.cameras:
        np.testing.assert_array_equal(episode.observations[f"{camera}_image"], again.observations[f"{camera}_image"])
    with pytest.raises(CheckpointError, match=r"needs aside_image"):
        PolicyAgent(run).act(ManipulationEnv(task("stack")).reset(seed=0)[0])
    rerender(taught[0], tmp_path / "small", RenderConfig(("robot0_eye_in_hand",), size=20), workers=1)
    with pytest.raises(DatasetError, match=r"rounds add images of \(84, 84\)"):
        dagger(tmp_path / "small", tmp_path / "rounds", TrainConfig(steps=1), DaggerConfig(1))
    with pytest.raises(DatasetError, match="is seen by aside, as what rounds add is not"):
        dagger(large, tmp_path / "rounds", TrainConfig(steps=1), DaggerConfig(1))
    with pytest.raises(CheckpointError, match="not trained on images of 84 x 84"):
        collect(CollectConfig("stack", tmp_path / "more", 1, workers=1, turns=Turns(run)))
