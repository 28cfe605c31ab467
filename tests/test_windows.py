"""Windows: the right frames, crops and labels, compared with slices of the episode as it was made."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from optimus.data.keyposes import keyposes
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import DatasetError
from synthetic import make_dataset, make_episode

LENGTHS = {0: 12, 1: 5, 2: 20}


@pytest.fixture(scope="module")
def store(tmp_path_factory: pytest.TempPathFactory) -> EpisodeStore:
    store = EpisodeStore.create(tmp_path_factory.mktemp("data"), "square", ("front",), {})
    for seed, steps in LENGTHS.items():
        store.write(make_episode(seed, steps, cameras=("front",)))
    return store


@settings(max_examples=30)
@given(context=st.integers(1, 9), windows=st.integers(1, 6), data=st.data())
def test_a_run_is_consecutive_frames_of_one_episode(store: EpisodeStore, context: int, windows: int, data: st.DataObject) -> None:
    cut = Windows(store, list(LENGTHS), WindowConfig(context=context, windows=windows, ahead=3))
    index = data.draw(st.integers(0, len(cut) - 1))
    batch = cut.batch([index])
    ends = [(seed, e) for seed, n in LENGTHS.items() for e in range(n + windows - 1)]
    seed, end = ends[index]
    assert len(cut) == len(ends)
    episode = make_episode(seed, LENGTHS[seed], cameras=("front",))
    frames = np.arange(end - cut.config.frames + 1, end + 1)
    inside = frames.clip(0, LENGTHS[seed] - 1)
    np.testing.assert_array_equal(batch.images["front"][0], episode.observations["front_image"][inside, 4:80, 4:80])
    np.testing.assert_array_equal(batch.proprioception["robot0_eef_pos"][0], episode.observations["robot0_eef_pos"][inside])
    np.testing.assert_array_equal(batch.actions[0], episode.actions[inside])
    np.testing.assert_array_equal(batch.objects[0], episode.objects[inside])
    np.testing.assert_array_equal(batch.weight[0], frames == inside)
    for k in range(3):  # never of the next episode
        np.testing.assert_array_equal(batch.ahead[0, :, k], episode.actions[np.minimum(inside + 1 + k, LENGTHS[seed] - 1)])


@pytest.mark.parametrize("windows", [1, 4])
def test_all_labels_are_learned_equally_often(store: EpisodeStore, windows: int) -> None:
    cut = Windows(store, list(LENGTHS), WindowConfig(context=3, windows=windows))
    places = cut.places(np.arange(len(cut)))
    supervised = places.steps[:, -windows:][places.inside[:, -windows:]]
    assert np.bincount(supervised).tolist() == [windows] * cut.labels


def test_sampling_is_a_function_of_the_generator(store: EpisodeStore) -> None:
    cut = Windows(store, list(LENGTHS), WindowConfig())
    first, again, other = (cut.sample(np.random.default_rng(s), 6) for s in (1, 1, 2))
    np.testing.assert_array_equal(first.images["front"], again.images["front"])
    np.testing.assert_array_equal(first.actions, again.actions)
    assert not np.array_equal(first.images["front"], other.images["front"])


def test_a_random_crop_is_one_offset_for_a_run(store: EpisodeStore) -> None:
    cut = Windows(store, [2], WindowConfig())
    images = store.read(2).observations["front_image"]
    batch = cut.sample(np.random.default_rng(0), 20)
    offsets = set()
    for run, actions in zip(batch.images["front"], batch.actions, strict=True):
        end = int(np.flatnonzero((store.read(2).actions == actions[-1]).all(1))[-1])
        frames = np.maximum(np.arange(end - 7, end + 1), 0)
        found = [
            (top, left)
            for top in range(9)
            for left in range(9)
            if np.array_equal(run, images[frames, top : top + 76, left : left + 76])
        ]
        assert len(found) == 1
        offsets.add(found[0])
    assert len(offsets) > 10


def test_labels_near_a_change_of_the_gripper_weigh_more(store: EpisodeStore) -> None:
    cut = Windows(store, [2], WindowConfig(change_weight=3.0, change_reach=1))
    changes = int(np.flatnonzero(np.diff(make_episode(2, 20).actions[:, 6]))[0]) + 1
    weight = cut.batch([changes + 4]).weight[0]  # frames changes-3 .. changes+4
    np.testing.assert_array_equal(weight, [1, 1, 3, 3, 3, 1, 1, 1])


def test_episodes_that_do_not_fit_together_are_named(store: EpisodeStore, tmp_path: Path) -> None:
    other = EpisodeStore.create(tmp_path, "square", ("front",), {})
    other.write(make_episode(0, cameras=("front",)))
    two = {"objects": np.zeros((20, 2, 3), np.float32), "object_names": ("square", "circle")}
    other.write(make_episode(1, cameras=("front",), **two))
    with pytest.raises(DatasetError, match=r"00000001\.safetensors: objects has shape \(2, 3\)"):
        Windows(other, [0, 1], WindowConfig())
    with pytest.raises(DatasetError, match="no episodes"):
        Windows(store, [], WindowConfig())


def test_nan_in_a_file_is_found_when_it_is_loaded(tmp_path: Path) -> None:
    store = make_dataset(tmp_path, 2)
    path, slot = store.episode_path(1), store.header(1).arrays["obs.robot0_eef_pos"]
    content = bytearray(path.read_bytes())
    content[slot.offset : slot.offset + 4] = np.float32(np.nan).tobytes()
    path.write_bytes(content)
    with pytest.raises(DatasetError, match=r"00000001\.safetensors: robot0_eef_pos holds NaN"):
        Windows(store, [0, 1], WindowConfig())


@settings(max_examples=50)
@given(gripper=st.lists(st.sampled_from([-1.0, 1.0]), min_size=1, max_size=12), seed=st.integers(0, 1000))
def test_a_keypose_is_the_hands_at_the_next_change_of_the_gripper(gripper: list[float], seed: int) -> None:
    """Found by walking on, step by step; the direction and the line by scipy, the line the same after half a turn."""
    rng = np.random.default_rng(seed)
    turns, places = Rotation.random(len(gripper), rng=rng), rng.normal(size=(len(gripper), 3))
    found = keyposes(np.array(gripper), places, turns.as_quat())
    about_its_own = turns * Rotation.from_euler("z", np.pi)
    np.testing.assert_allclose(found, keyposes(np.array(gripper), places, about_its_own.as_quat()), atol=1e-6)
    for step, keypose in enumerate(found):
        stop = max(step, 1)
        while stop < len(gripper) - 1 and gripper[stop] == gripper[stop - 1]:
            stop += 1
        stop = min(stop, len(gripper) - 1)
        np.testing.assert_allclose(keypose[:3], places[stop], rtol=1e-6)
        matrix = turns[stop].as_matrix()
        np.testing.assert_allclose(keypose[3:6], matrix[:, 2], atol=1e-6)
        line = np.outer(matrix[:, 1], matrix[:, 1])
        np.testing.assert_allclose(keypose[6:], line[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]], atol=1e-6)
