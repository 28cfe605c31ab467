"""Evaluation: the interval against scipy, the outcome against the number of workers."""

import json
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import binomtest

from optimus.conditions import Conditions
from optimus.data.episode import Observation
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import CheckpointError
from optimus.evaluate import evaluate, play, policy_folder, random_starts, validation_starts
from optimus.evaluate.trials import _Witness
from optimus.learn import checkpoint
from optimus.rollout import rollout
from optimus.statistics import wilson
from optimus.tasks import task


@given(st.integers(1, 200), st.floats(0, 1))
def test_wilson_interval_agrees_with_scipy(n: int, share: float) -> None:
    k = round(share * n)
    expected = binomtest(k, n).proportion_ci(0.95, "wilson")
    np.testing.assert_allclose(wilson(k, n), (expected.low, expected.high), atol=1e-4)


def test_outcome_files_are_the_same_from_one_and_from_eight_environments(taught: tuple[Path, Path], tmp_path: Path) -> None:
    """Episodes end after few steps here; eight processes have one each, one process has all eight."""
    starts, short = random_starts(8), Conditions("push", friction=0.8, horizon=6)
    files = []
    for workers in (1, 8):
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
