"""Curation: ids and reasons, and not a byte of the data changed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from optimus.data.curate import CurationConfig, curate, load_curation
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError, OptimusError
from optimus.exchange.selection import select
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
    for seed in (23, 24):  # as long as they take to make good what happened
        write(store, seed, steps=60, info={"retries": 1, "mishap": {"kind": "slip", "at": 20}})
    before = {p: p.read_bytes() for p in (store.path / "episodes").iterdir()}
    curation = curate(store.path)
    assert curation.dropped == {20: "too long", 21: "failed", 22: "retried"}
    assert curation.kept == (*range(20), 23, 24)
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


def released_rule(lengths: dict[int, int], hands: dict[int, Any], sd: float, bounds: Any) -> list[int]:
    """The paper's filter as its script states it: over the whole file, an episode that is longer than the mean by so many standard
    deviations is out, and so is one whose hand is ever below or above a bound."""
    mean, deviation = np.mean(list(lengths.values())), np.std(list(lengths.values()))
    kept = []
    for seed, length in lengths.items():
        along = [(hands[seed][:, axis], *bounds[axis]) for axis in range(3)]
        outside = any(min(hand) < low or max(hand) > high for hand, low, high in along)
        if not outside and not length > mean + sd * deviation:
            kept.append(seed)
    return kept


def test_the_papers_filter_gives_the_same_ids(store: EpisodeStore) -> None:
    rng = np.random.default_rng(0)
    lengths, hands = {}, {}
    for seed in range(60):
        steps = int(rng.choice([8, 9, 10, 11, 30], p=[0.25, 0.25, 0.25, 0.2, 0.05]))
        made = make_episode(seed, steps, cameras=("front",), skeleton=("pick",) * (1 + seed % 3))
        hand = rng.normal(0, 0.12, (steps, 3)).astype(np.float32)
        made.observations["robot0_eef_pos"][:] = hand
        store.write(made)
        lengths[seed], hands[seed] = steps, hand
    bounds = [(-0.3, 0.31), (-0.32, 0.3), (-0.3, 0.35)]
    corners: dict[str, Any] = {"workspace_min": [b[0] for b in bounds], "workspace_max": [b[1] for b in bounds]}
    config = CurationConfig(max_length_sd=2, length_over="all", **corners)
    curation = curate(store.path, config)
    assert list(curation.kept) == released_rule(lengths, hands, 2, bounds)
    assert {"too long", "outside workspace"} <= set(curation.dropped.values())
    assert curation.rules["too long"]["alone"] >= curation.rules["too long"]["removed"] > 0
    assert load_curation(store.path) == curation


def test_what_a_camera_does_not_see_is_left_out(store: EpisodeStore) -> None:
    """A camera 1 m above the origin, 90 degrees wide, looks straight down: on the ground it sees 1 m to either side."""
    views = {"views": {"top": {"pos": [0.0, 0.0, 1.0], "quat": [1.0, 0.0, 0.0, 0.0], "fovy": 90.0}}}
    for seed, x in enumerate((0.0, 0.9, 1.1, -0.99)):
        made = make_episode(seed, 5, cameras=("front",), info=views)
        made.objects[-1, 0] = (x, 0.0, 0.0)
        store.write(made)
    behind = make_episode(4, 5, cameras=("front",), info=views)
    behind.observations["robot0_eef_pos"][2] = (0.0, 0.0, 1.5)
    store.write(behind)
    assert curate(store.path, CurationConfig(in_view=("top",))).dropped == {2: "out of view", 4: "out of view"}
    with pytest.raises(DatasetError, match="'side'; it tells of top"):
        curate(store.path, CurationConfig(in_view=("side",)))


def test_numbers_that_make_no_rule_are_refused(store: EpisodeStore) -> None:
    nan = float("nan")
    rules: tuple[dict[str, Any], ...] = (
        {"validation_share": nan}, {"validation_share": 7.0}, {"validation_share": -1.0}, {"seed": -1}, {"validation_episodes": -1},
        {"max_length_sd": nan}, {"max_tracking_error": nan}, {"workspace_min": (nan, 0.0, 0.0)},
    )  # fmt: skip
    CurationConfig(workspace_min=(0.2, -np.inf, 0.0))  # open on a side
    for wrong in rules:
        with pytest.raises(OptimusError):
            CurationConfig(**wrong)


def test_episodes_that_came_later_are_not_left_out_in_silence(store: EpisodeStore, tmp_path: Path) -> None:
    for seed in range(4):
        write(store, seed)
    curate(store.path)
    write(store, 4)
    with pytest.raises(DatasetError, match="1 episodes came after its curation"):
        select(store.path)
    assert len(select(store.path, everything=True).headers) == 5
    curate(store.path)
    assert len(select(store.path).headers) == 5
