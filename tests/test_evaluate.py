"""Evaluation: the interval against scipy, the outcome against the number of workers."""

from pathlib import Path

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import binomtest

from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.evaluate import evaluate, play, random_starts, validation_starts
from optimus.statistics import wilson
from optimus.tasks import task


@given(st.integers(1, 200), st.floats(0, 1))
def test_wilson_interval_agrees_with_scipy(n: int, share: float) -> None:
    k = round(share * n)
    expected = binomtest(k, n).proportion_ci(0.95, "wilson")
    np.testing.assert_allclose(wilson(k, n), (expected.low, expected.high), atol=1e-4)


def test_outcomes_do_not_depend_on_the_number_of_workers(taught: tuple[Path, Path]) -> None:
    starts = random_starts(3)
    reports = [evaluate(taught[1], starts, "random", workers=w) for w in (1, 2)]
    assert reports[0].outcomes == reports[1].outcomes
    assert reports[0].episodes == 3 and all(o.cause for o in reports[0].outcomes if not o.success)


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
