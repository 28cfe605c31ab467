"""Curation: ids and reasons, and not a byte of the data changed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from optimus.data.curate import CurationConfig, curate, load_curation
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError
from synthetic import make_episode


@pytest.fixture
def store(tmp_path: Path) -> EpisodeStore:
    return EpisodeStore.create(tmp_path, "square", ("front",), {})


def write(store: EpisodeStore, seed: int, steps: int = 10, **changes: Any) -> None:
    store.write(make_episode(seed, steps, cameras=("front",), **changes))


def test_every_episode_is_kept_or_has_a_reason(store: EpisodeStore) -> None:
    for seed in range(20):
        write(store, seed)
    write(store, 20, steps=60)
    write(store, 21, success=False, failure="dropped")
    write(store, 22, info={"retries": 1})
    before = {p: p.read_bytes() for p in (store.path / "episodes").iterdir()}
    curation = curate(store.path)
    assert curation.dropped == {20: "too long", 21: "failed", 22: "retried"}
    assert curation.kept == tuple(range(20))
    assert len(curation.validation) == 2
    assert not set(curation.train) & set(curation.validation)
    assert load_curation(store.path) == curation
    assert {p: p.read_bytes() for p in (store.path / "episodes").iterdir()} == before


def test_the_split_is_a_function_of_the_seed(store: EpisodeStore) -> None:
    for seed in range(30):
        write(store, seed, steps=2)
    splits = [curate(store.path, CurationConfig(seed=s)).validation for s in (0, 0, 1)]
    assert splits[0] == splits[1] != splits[2]


def test_the_longer_of_two_skeletons_is_kept(store: EpisodeStore) -> None:
    for seed in range(12):
        write(store, seed, steps=5)
    for seed in (12, 13):
        write(store, seed, steps=40, skeleton=("pick", "place", "pick", "place"))
    assert curate(store.path).dropped == {}


def test_the_workspace_and_the_tracking_error_are_limits(store: EpisodeStore) -> None:
    for seed in range(4):
        write(store, seed, info={"tracking_error": {"median": 0.005, "max": 0.06}})
    wide = make_episode(4, 10, cameras=("front",), info={"tracking_error": {"median": 0.005, "max": 0.01}})
    wide.observations["robot0_eef_pos"][5] = (0, 0, 0.9)
    store.write(wide)
    write(store, 5, info={"tracking_error": {"median": 0.05, "max": 0.06}})
    config = CurationConfig(workspace_min=(-1, -1, -0.1), workspace_max=(1, 1, 0.5), max_tracking_error=0.01)
    assert curate(store.path, config).dropped == {4: "outside workspace", 5: "tracking error"}
    assert curate(store.path).dropped == {}


def test_two_episodes_are_enough_and_one_is_not(store: EpisodeStore) -> None:
    write(store, 0)
    with pytest.raises(DatasetError, match="1 of 1 episodes left"):
        curate(store.path)
    write(store, 1)
    curation = curate(store.path)
    assert (len(curation.train), len(curation.validation)) == (1, 1)


def test_what_is_missing_or_damaged_is_said(store: EpisodeStore) -> None:
    with pytest.raises(DatasetError, match="has not been curated"):
        load_curation(store.path)
    (store.path / "curation.json").write_text("{")
    with pytest.raises(DatasetError, match="damaged"):
        load_curation(store.path)


def test_initial_states_of_the_validation_split_are_kept(store: EpisodeStore) -> None:
    for seed in range(5):
        write(store, seed)
    seed = curate(store.path).validation[0]
    made = make_episode(seed, 10, cameras=("front",))
    np.testing.assert_array_equal(store.header(seed).read("initial_state"), made.initial_state)
