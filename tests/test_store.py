"""The episode store: whole or not at all, readable by others, and clear about what is wrong."""

from __future__ import annotations

import errno
import json
import os
import platform
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from safetensors import safe_open

from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError, StorageError
from synthetic import CAMERAS, make_episode

SETTINGS: dict[str, Any] = {"control": "task", "position_scale": 0.02}


@pytest.fixture
def store(tmp_path: Path) -> EpisodeStore:
    return EpisodeStore.create(tmp_path / "data", "square", CAMERAS, SETTINGS)


@settings(max_examples=15)
@given(
    seed=st.integers(0, 10**9),
    steps=st.integers(1, 6),
    skeleton=st.lists(st.sampled_from(["pick", "place", "stack"])),
    info=st.dictionaries(st.text(max_size=5), st.none() | st.booleans() | st.integers() | st.text(max_size=5)),
)
def test_an_episode_reads_back_as_it_was_written(
    tmp_path_factory: pytest.TempPathFactory, seed: int, steps: int, skeleton: list[str], info: dict[str, Any]
) -> None:
    store = EpisodeStore.create(tmp_path_factory.mktemp("data"), "square", CAMERAS, SETTINGS)
    written = make_episode(seed, steps, skeleton=tuple(skeleton), info=info)
    store.write(written)
    read = store.read(seed)
    assert store.seeds == (seed,)
    assert list(read.observations) == list(written.observations)
    for name, array in written.observations.items():
        np.testing.assert_array_equal(read.observations[name], array)
        assert read.observations[name].dtype == array.dtype
    for name in ("actions", "executed", "initial_state", "objects"):
        np.testing.assert_array_equal(getattr(read, name), getattr(written, name))
    for name in ("task", "seed", "agent", "object_names", "success", "failure", "skeleton", "info"):
        assert getattr(read, name) == getattr(written, name)


def test_safetensors_own_reader_finds_the_same_arrays(store: EpisodeStore) -> None:
    episode = make_episode(3)
    store.write(episode)
    with safe_open(store.episode_path(3), "np") as file:
        assert json.loads(file.metadata()["episode"])["task"] == "square"
        np.testing.assert_array_equal(file.get_tensor("actions"), episode.actions)
        np.testing.assert_array_equal(file.get_tensor("obs.front_image"), episode.observations["front_image"])
    header = store.header(3)
    np.testing.assert_array_equal(header.read("obs.wrist_image"), episode.observations["wrist_image"])
    assert header.steps == len(episode)


def test_failures_are_recorded(store: EpisodeStore) -> None:
    store.write_failure(7, "no grasp", ("pick",), {"plan_seconds": 0.5})
    assert store.failed_seeds == (7,)
    assert store.read_failure(7)["reason"] == "no grasp"


def test_create_goes_on_only_with_the_same_settings(store: EpisodeStore) -> None:
    store.write(make_episode(1))
    assert EpisodeStore.create(store.path, "square", CAMERAS, SETTINGS).seeds == (1,)
    with pytest.raises(DatasetError, match=r"control = 'task', not 'joint'"):
        EpisodeStore.create(store.path, "square", CAMERAS, {**SETTINGS, "control": "joint"})
    with pytest.raises(DatasetError, match="task = 'square', not 'stack'"):
        EpisodeStore.create(store.path, "stack", CAMERAS, SETTINGS)


def test_a_folder_of_something_else_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("mine")
    with pytest.raises(DatasetError, match=r"not empty and holds no dataset\.json"):
        EpisodeStore.create(tmp_path, "square", CAMERAS, SETTINGS)
    assert [p.name for p in tmp_path.iterdir()] == ["thesis.tex"]
    with pytest.raises(DatasetError, match="not a dataset"):
        EpisodeStore.open(tmp_path)


def test_episodes_without_their_description_are_left_alone(store: EpisodeStore) -> None:
    """How they were made stood there: others would be mixed with them."""
    store.write(make_episode(1))
    (store.path / "dataset.json").write_text("{")
    with pytest.raises(DatasetError, match="put back a copy"):
        EpisodeStore.open(store.path)
    (store.path / "dataset.json").unlink()
    with pytest.raises(DatasetError, match=r"holds no dataset\.json, so nobody knows"):
        EpisodeStore.create(store.path, "square", CAMERAS, SETTINGS)
    store.episode_path(1).unlink()
    EpisodeStore.create(store.path, "square", CAMERAS, SETTINGS)  # as an interrupted beginning leaves it


@pytest.mark.parametrize("kept", [0, 5, 200, -1])
def test_a_file_cut_short_is_named(store: EpisodeStore, kept: int) -> None:
    store.write(make_episode(1))
    path = store.episode_path(1)
    path.write_bytes(path.read_bytes()[:kept])
    with pytest.raises(DatasetError, match=r"00000001\.safetensors.*delete it"):
        store.headers()


def test_foreign_files_are_named(store: EpisodeStore) -> None:
    path = store.episode_path(2)
    path.write_bytes(os.urandom(4096))
    with pytest.raises(DatasetError, match=r"00000002\.safetensors is not an episode file"):
        store.read(2)
    path.unlink()
    store.write(make_episode(3))
    shutil.copy(store.episode_path(3), store.episode_path(300))
    with pytest.raises(DatasetError, match="is episode 3 by another's name"):
        store.headers()
    store.episode_path(300).unlink()
    (store.path / "episodes" / "notes.txt").write_text("")
    with pytest.raises(DatasetError, match=r"notes\.txt does not belong"):
        _ = store.seeds


@pytest.mark.parametrize("shape", [[], [10**15, 7], [3, 7], "seven"])
def test_a_header_that_does_not_fit_its_bytes_is_named(store: EpisodeStore, shape: object) -> None:
    store.write(make_episode(3))
    path = store.episode_path(3)
    payload = path.read_bytes()
    length = int.from_bytes(payload[:8], "little")
    header = json.loads(payload[8 : 8 + length])
    header["actions"]["shape"] = shape
    text = json.dumps(header).encode()
    path.write_bytes(len(text).to_bytes(8, "little") + text + payload[8 + length :])
    with pytest.raises(DatasetError, match="is not an episode file or is damaged"):
        store.header(3)


def test_an_episode_of_another_task_is_refused(store: EpisodeStore) -> None:
    with pytest.raises(DatasetError, match="'stack' does not belong"):
        store.write(make_episode(1, task="stack"))
    with pytest.raises(DatasetError, match="cameras"):
        store.write(make_episode(1, cameras=("front",)))
    assert store.seeds == ()


def test_values_that_are_not_finite_are_refused(store: EpisodeStore) -> None:
    episode = make_episode(1)
    episode.actions[3, 2] = np.nan
    with pytest.raises(DatasetError, match=r"00000001.*actions holds NaN"):
        store.write(episode)
    assert list((store.path / "episodes").iterdir()) == []


def test_a_full_disk_damages_nothing(store: EpisodeStore, monkeypatch: pytest.MonkeyPatch) -> None:
    store.write(make_episode(1))
    before = store.episode_path(1).read_bytes()

    def full(self: Path, target: Path) -> Path:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(StorageError, match="No space left on device"):
        store.write(make_episode(1))
    assert store.episode_path(1).read_bytes() == before
    assert [p.name for p in (store.path / "episodes").iterdir()] == ["00000001.safetensors"]


def test_a_folder_that_cannot_be_made_is_an_error_of_storage(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError, match="cannot create"):
        EpisodeStore.create(tmp_path / "file" / "data", "square", CAMERAS, SETTINGS)


def test_leftovers_of_dead_processes_only_are_removed(store: EpisodeStore) -> None:
    host = re.sub(r"[^\w.]", "_", platform.node())
    gone = subprocess.run([sys.executable, "-c", "import os; print(os.getpid())"], capture_output=True, check=True)
    dead = store.path / "episodes" / f"00000009.safetensors.tmp-{host}-{int(gone.stdout)}"
    alive = store.path / "episodes" / f"00000010.safetensors.tmp-{host}-{os.getpid()}"
    elsewhere, forgotten = (store.path / "episodes" / f"{n:08d}.safetensors.tmp-other-{int(gone.stdout)}" for n in (11, 12))
    for path in (dead, alive, elsewhere, forgotten):
        path.write_bytes(b"half")
    os.utime(forgotten, (0, 0))
    assert EpisodeStore.open(store.path).seeds == ()
    assert [p.exists() for p in (dead, alive, elsewhere, forgotten)] == [False, True, True, False]


def test_what_no_reader_would_take_is_refused_by_the_writer(store: EpisodeStore) -> None:
    whole = make_episode(1)
    store.write(whole)
    store.write(whole)  # once more is no harm
    hand = whole.observations["robot0_eef_pos"]
    for wrong, said in (
        (make_episode(1, steps=3), "holds another episode 1 already"),
        (replace(whole, seed=-1), "0 or more"),
        (replace(whole, seed=2, observations={**whole.observations, "robot0_eef_pos": hand.astype(np.float16)}), "float16"),
        (replace(whole, seed=2, observations={**whole.observations, "robot0_eef_pos": hand[1:]}), "actions"),
        (replace(whole, seed=2, object_names=("square", "circle")), r"not \(steps, 2, 3\)"),
        (replace(whole, seed=2, info={"mass": np.float32(1)}), "JSON"),
    ):
        with pytest.raises(DatasetError, match=said):
            store.write(wrong)
    assert store.seeds == (1,) and len(store.read(1)) == len(whole)
