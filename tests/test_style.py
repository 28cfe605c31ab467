"""Style: every option changes what it names, in what is collected, and nothing when it is not asked for."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from optimus.data.episode import GRIPPER, Episode
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import UnknownNameError
from optimus.expert import TimeLaw
from optimus.skills import Style
from optimus.tasks import task

DEFAULT = ExpertConfig()


def shown(config: ExpertConfig, seed: int = 3, gripper: str = "binary") -> Episode:
    attempt = demonstrate(ManipulationEnv(task("stack"), images=False, gripper=gripper), seed, config)
    assert attempt.success and attempt.episode is not None, attempt.failure
    return attempt.episode


def way(episode: Episode) -> float:
    """The length of the hand's way [m]."""
    return float(np.linalg.norm(np.diff(episode.observations["robot0_eef_pos"], axis=0), axis=1).sum())


def test_a_stall_is_as_long_as_it_is_asked_to_be() -> None:
    """From the label's change to the arm's next motion."""
    for stall in (5, 25):
        episode = shown(replace(DEFAULT, law=TimeLaw(stall=stall)))
        change = int(np.flatnonzero(np.diff(episode.actions[:, GRIPPER]))[0]) + 1
        still = np.abs(episode.actions[change:, :3]).max(axis=1) < 0.05
        assert stall <= int(np.argmin(still)) <= stall + 3


def test_the_gripper_is_told_to_be_open_or_shut_or_led_there() -> None:
    binary, continuous = shown(DEFAULT), shown(replace(DEFAULT, law=TimeLaw(gripper="continuous")), gripper="continuous")
    assert set(np.unique(binary.actions[:, GRIPPER])) == {-1.0, 1.0}
    told = continuous.actions[:, GRIPPER]
    between = told[np.abs(told) < 1]
    assert len(between) == 8  # four of the five steps of each stall
    np.testing.assert_allclose(between[:4], [-0.6, -0.2, 0.2, 0.6], atol=1e-6)
    np.testing.assert_allclose(between[4:], [0.6, 0.2, -0.2, -0.6], atol=1e-6)


def test_the_continuous_gripper_stays_where_it_is_told() -> None:
    """Half of the way from 8 cm to 4 cm beyond the fingers' meeting; the binary one takes the same number for open."""
    for gripper, opening in (("continuous", 0.02), ("binary", 0.08)):
        env = ManipulationEnv(task("stack"), images=False, gripper=gripper)
        seen, _ = env.reset(seed=0)
        for _ in range(40):
            seen, *_ = env.step(np.zeros(env.action_size, np.float32))
        assert np.abs(seen["robot0_gripper_qpos"]).sum() == pytest.approx(opening, abs=0.002)


def test_speed_is_the_fastest_that_the_hand_goes() -> None:
    fast, slow = (shown(replace(DEFAULT, law=TimeLaw(speed=speed))) for speed in (0.35, 0.15))
    top = [np.linalg.norm(np.diff(e.observations["robot0_eef_pos"], axis=0), axis=1).max() * 20 for e in (fast, slow)]
    assert 0.25 < top[0] < 0.45 and 0.1 < top[1] < 0.2 and len(slow) > 1.3 * len(fast)


def test_sampled_motion_goes_about() -> None:
    sampled = [shown(replace(DEFAULT, style=Style(motion="sampled")), seed) for seed in (3, 4)]
    straight = [shown(DEFAULT, seed) for seed in (3, 4)]
    assert sum(map(way, sampled)) > 1.2 * sum(map(way, straight))


@pytest.mark.parametrize("changes", [{"grasps": "random"}, {"motion": "sampled"}, {"motion": "sampled", "ik": "random"}])
def test_what_is_random_is_drawn_from_the_seed(changes: dict[str, Any]) -> None:
    style = replace(DEFAULT, style=Style(**changes))
    np.testing.assert_array_equal(shown(style).actions, shown(style).actions)


def test_random_grasps_are_not_always_the_first() -> None:
    def grasp(config: ExpertConfig, seed: int) -> Any:
        episode = shown(config, seed)
        return episode.observations["robot0_eef_quat"][np.flatnonzero(np.diff(episode.actions[:, GRIPPER]))[0]]

    random = replace(DEFAULT, style=Style(grasps="random"))
    apart = [abs(float(grasp(DEFAULT, seed) @ grasp(random, seed))) for seed in range(5)]
    assert min(apart) < 0.95


def test_unknown_styles_are_named() -> None:
    with pytest.raises(UnknownNameError, match="fixed, random"):
        Style(grasps="sometimes")  # pyright: ignore[reportArgumentType]
    with pytest.raises(UnknownNameError, match="binary, continuous"):
        TimeLaw(gripper="soft")  # pyright: ignore[reportArgumentType]
    with pytest.raises(UnknownNameError, match="binary, continuous"):
        ManipulationEnv(task("stack"), gripper="soft")
