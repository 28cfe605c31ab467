"""Corrections: the policy acts, the labels stay the expert's."""

import json
import shutil
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from optimus.collect import CollectConfig, collect
from optimus.correct import Corrections, Turns
from optimus.data.episode import MISHAP, Observation
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError
from optimus.expert import PlanFollower, TimeLaw
from optimus.learn.checkpoint import load
from optimus.learn.train import TrainConfig, train
from optimus.motion.plan import Plan
from optimus.planner import solve
from optimus.rollout import LAST_LOOK
from optimus.skills import Workspace
from optimus.tasks import task

SHORT = replace(task("stack"), horizon=100)
"""A policy that has learned nothing is not watched for long."""


def test_the_policy_acts_and_the_expert_answers(taught: tuple[Path, Path]) -> None:
    env, config = ManipulationEnv(SHORT), ExpertConfig()
    always = partial(Corrections, Turns(taught[1], policy_steps=1e9, expert_steps=1.0))
    first = demonstrate(env, 3, config, always).episode
    again = demonstrate(env, 3, config, always).episode
    assert first is not None and again is not None
    np.testing.assert_array_equal(first.executed, again.executed)
    # in the last steps, where the expert has nothing more to answer, nobody acts
    assert np.any(first.actions != first.executed, axis=1)[:-LAST_LOOK].mean() > 0.9
    assert first.info["perturbed"] and not first.success  # three steps of training teach nobody to stack
    # a label is what a fresh follower of the same plan would say, wherever the policy went
    assert np.abs(first.actions).max() <= 1.0 and set(np.unique(first.actions[:, 6])) <= {-1.0, 1.0}


def test_while_a_grasp_is_led_astray_the_policy_sees_every_frame(taught: tuple[Path, Path]) -> None:
    seen, shown = [], Corrections.next

    class Watched(Corrections):
        def next(self, observation: Observation, label: NDArray[np.float32], slack: float) -> NDArray[np.float64]:
            seen.append(observation["robot0_eef_pos"].copy())
            return shown(self, observation, label, slack)

    config = ExpertConfig(mishaps=1.0)
    seed = next(seed for seed in range(50) if config.mishap(seed) == "miss")
    never = partial(Watched, Turns(taught[1], policy_steps=1.0, expert_steps=1e12))
    episode = demonstrate(ManipulationEnv(task("stack")), seed, config, never).episode
    assert episode is not None and MISHAP in episode.info
    np.testing.assert_array_equal(np.array(seen), episode.observations["robot0_eef_pos"][: len(seen)])
    assert len(seen) >= len(episode) - LAST_LOOK


def test_a_policy_is_corrected_with_the_gripper_that_it_was_taught(taught: tuple[Path, Path], tmp_path: Path) -> None:
    run = Path(shutil.copytree(taught[1], tmp_path / "run"))
    config = json.loads((run / "config.json").read_text())
    config["dataset"]["config"]["gripper"] = "continuous"
    (run / "config.json").write_text(json.dumps(config))
    with pytest.raises(CheckpointError, match="gripper 'continuous', not 'binary'"):
        collect(CollectConfig("stack", tmp_path / "data", 1, turns=Turns(run)))
    with pytest.raises(CheckpointError, match="task 'stack', not 'pick-place'"):
        collect(CollectConfig("pick-place", tmp_path / "data", 1, turns=Turns(run)))
    env = ManipulationEnv(SHORT, gripper="continuous")
    always = partial(Corrections, Turns(run, policy_steps=1e9, expert_steps=1.0))
    episode = demonstrate(env, 3, ExpertConfig(law=TimeLaw(gripper="continuous")), always).episode
    assert episode is not None
    between = np.abs(episode.executed[:, 6]) < 1.0  # where a binary gripper never is told to be
    assert between[:-LAST_LOOK].mean() > 0.5


def test_without_turns_of_the_policy_nothing_changes(taught: tuple[Path, Path]) -> None:
    env = ManipulationEnv(task("stack"))
    never = partial(Corrections, Turns(taught[1], policy_steps=1.0, expert_steps=1e12))
    for seed in range(20):
        corrected = demonstrate(env, seed, ExpertConfig(), never).episode
        assert corrected is not None
        if np.array_equal(corrected.actions, corrected.executed):  # the expert had the first turn
            plain = demonstrate(env, seed, ExpertConfig()).episode
            assert plain is not None
            np.testing.assert_array_equal(plain.actions, corrected.actions)
            return
    raise AssertionError("the expert never had the first turn")


def test_training_begins_with_the_weights_and_sees_both_datasets(taught: tuple[Path, Path], tmp_path: Path) -> None:
    data, policy = taught
    more = collect(CollectConfig("stack", tmp_path / "more", 2, seed=900, workers=1))
    assert more.demonstrations == 2
    tuned = train(data, tmp_path / "tuned", TrainConfig(steps=1), corrections=tmp_path / "more", initial=policy)
    before = load(policy).state_dict()
    for name, value in tuned.state_dict().items():
        assert float((value.float() - before[name].float()).abs().max()) < 0.05, name
    assert EpisodeStore.open(tmp_path / "more").seeds == (900, 901)


def test_the_follower_waits_for_fingers_that_do_not_move() -> None:
    env = ManipulationEnv(task("stack"), images=False)
    observation, _ = env.reset(seed=1)
    plan = solve(Workspace(env.world), env.state(), env.problem.goal, np.random.default_rng(1))
    assert isinstance(plan, Plan)
    follower = PlanFollower(plan)
    for _ in range(150):
        action = follower.act(observation)
        assert action is not None
        action[6] = -1.0  # somebody holds the gripper open
        observation, *_ = env.step(action)
    assert follower.segment is not None and follower.segment.name == "close"
