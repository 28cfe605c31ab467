"""The score of imitability: zero for a function of the state, the noise's own size for noise, and worse for worse habits."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from optimus.cli.demonstrations import imitability as command
from optimus.collect import CollectConfig, collect
from optimus.data.describe import describe
from optimus.data.imitability import compared, imitability
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig
from optimus.errors import DatasetError, OptimusError
from optimus.expert import TimeLaw
from optimus.skills import Style
from synthetic import make_episode

STEPS, SCALE = 12, 0.05


def made(folder: Path, noise: float, episodes: int = 40, wait: int = 0, alone_from: int = 40) -> EpisodeStore:
    """The hand goes along x at 1 cm a step, the actions with `noise` [m] on each number of the position; or, having shut the
    gripper, it waits for so many steps and goes on, which no state tells. From episode `alone_from` on each
    has a thing of its own."""
    store = EpisodeStore.create(folder, "square", (), {"position_scale": SCALE, "rotation_scale": 0.5})
    for seed in range(episodes):
        rng = np.random.default_rng(seed)
        place = np.concatenate([np.arange(STEPS // 2), np.full(wait, STEPS // 2), np.arange(STEPS // 2, STEPS)])
        moving = np.append(np.diff(place), 1)
        hand = np.zeros((len(place), 3), np.float32)
        hand[:, 0] = 0.01 * place
        actions = np.zeros((len(place), 7), np.float32)
        actions[:, 0] = 0.01 * moving / SCALE
        actions[:, :3] += rng.normal(size=(len(place), 3)) * noise / SCALE
        actions[:, 6] = np.where(place < STEPS // 2, -1, 1)
        base = make_episode(seed, len(place), cameras=())
        changes: dict[str, Any] = {"actions": actions, "executed": actions, "objects": np.zeros((len(place), 1, 3), np.float32)}
        changes["object_names"] = ("thing" if seed < alone_from else f"thing {seed}",)
        changes["observations"] = {**base.observations, "robot0_eef_pos": hand}
        store.write(make_episode(seed, len(place), cameras=(), **changes))
    return store


def test_a_function_of_the_state_leaves_nothing_to_chance(tmp_path: Path) -> None:
    score = imitability(made(tmp_path, 0.0).path)
    assert score.drift < 1e-6 and score.doubt == 0 and score.alike < 1e-6 and score.compared == 1


def test_an_episode_whose_gripper_never_changes_is_compared_too(tmp_path: Path) -> None:
    store = made(tmp_path, 0.0)
    odd = store.read(0)
    odd.actions[:, 6] = -1
    same = {"actions": odd.actions, "executed": odd.actions, "observations": odd.observations}
    store.write(make_episode(99, len(odd.actions), cameras=(), **same))
    assert np.isfinite(imitability(tmp_path).drift) and describe(tmp_path).imitability is not None


def test_noise_is_found_in_its_own_size(tmp_path: Path) -> None:
    """Independent noise of 2 mm on each of three numbers, over twelve steps, sums to 2 mm x sqrt(36)."""
    score = imitability(made(tmp_path, 0.002).path)
    assert describe(tmp_path).imitability == score
    assert score.drift == pytest.approx(0.002 * np.sqrt(3 * STEPS), rel=0.08)
    whole = sum(phase["drift"] ** 2 for phase in score.phases.values())
    assert score.drift == pytest.approx(np.sqrt(whole))


def test_what_can_be_compared_with_nothing_makes_no_dataset_easier(tmp_path: Path) -> None:
    whole = imitability(made(tmp_path / "whole", 0.01).path)
    partly = imitability(made(tmp_path / "partly", 0.01, alone_from=15).path)
    assert whole.compared == 1 and partly.compared < 0.6 and "% of the steps compared" in partly.in_words
    assert partly.drift == pytest.approx(whole.drift, rel=0.15) and partly.steps == whole.steps
    np.testing.assert_allclose(np.sqrt(sum(p["drift"] ** 2 for p in partly.phases.values())), partly.drift)


@pytest.mark.parametrize("wait", [3, 20])
def test_a_wait_that_nothing_ends_is_a_matter_of_chance(tmp_path: Path, wait: int) -> None:
    """In the best guess of a memoryless policy, w steps stand still and one goes on 1 cm: the variance of that choice, summed."""
    score = imitability(made(tmp_path, 0.0, wait=wait).path)
    share = 1 / (wait + 1)
    assert score.drift == pytest.approx(0.01 * np.sqrt((wait + 1) * share * (1 - share)), rel=0.35)


def test_habits_are_put_in_their_order(tmp_path: Path) -> None:
    """Of stack: the defaults are easier to imitate than longer stalls or random grasps, and these than sampled motion."""
    kinds = {
        "default": ExpertConfig(),
        "stall": ExpertConfig(law=TimeLaw(stall=25)),
        "random": ExpertConfig(style=Style(grasps="random", ik="random")),
        "sampled": ExpertConfig(style=Style(motion="sampled")),
    }
    drift = {}
    for name, expert in kinds.items():
        collect(CollectConfig("stack", tmp_path / name, 8, workers=1, expert=expert, images=False))
        drift[name] = imitability(tmp_path / name).drift
    assert drift["default"] < drift["stall"] < drift["sampled"]
    assert drift["default"] < drift["random"] < drift["sampled"]


def test_what_cannot_be_compared_is_said(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="collect more"):
        imitability(made(tmp_path / "few", 0.0, episodes=3).path)
    other = EpisodeStore.create(tmp_path / "other", "square", (), {})
    for seed in range(8):
        other.write(make_episode(seed, cameras=()))
    with pytest.raises(DatasetError, match="position_scale"):
        imitability(other.path)
    more, fewer = made(tmp_path / "more", 0.01).path, made(tmp_path / "fewer", 0.01, episodes=8).path
    assert [score.episodes for score in compared([more, fewer])] == [8, 8]
    with pytest.raises(DatasetError, match=r"of several tasks \(circle, square\)"):
        command((more, EpisodeStore.create(tmp_path / "circle", "circle", (), {}).path))
    with pytest.raises(OptimusError, match="at least one DATASET"):
        command(())
