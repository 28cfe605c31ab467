"""What is held out is held out: no initial state, no size of a receptacle and no object of the validation occurs in training."""

from pathlib import Path

import numpy as np
import pytest

from optimus.assets.catalogue import ObjectSet, keys_of
from optimus.collect import CollectConfig, collect
from optimus.conditions import Conditions
from optimus.data.curate import CurationConfig, curate
from optimus.data.episode import RECEPTACLE
from optimus.data.store import EpisodeStore
from optimus.errors import CheckpointError, DatasetError
from optimus.evaluate import RANDOM_SEEDS_FROM, evaluate, random_starts, validation_starts
from optimus.evaluate.start import require_unseen
from optimus.learn.presets import preset
from optimus.learn.sources import learned_starts
from optimus.learn.train import TrainConfig, train
from optimus.reproduce.work import EXPERT_SEED
from optimus.run import CORRECTION_SEEDS_FROM
from optimus.task import pick_one
from optimus.tasks import task
from synthetic import CAMERAS, make_episode

SIZED = ("shelf-receptacle", "microwave-receptacle")


def furniture(name: str, seed: int) -> tuple[bytes, ...]:
    """The receptacle of a problem, by the geometry that physics has: every fixture's place and parts."""
    fixtures = task(name).problem(seed).scene.fixtures
    return tuple(repr((f.name, f.pos, f.shape)).encode() for f in fixtures)


@pytest.mark.parametrize("name", SIZED)
def test_a_receptacle_is_named_by_its_geometry(name: str) -> None:
    by_name: dict[str, set[tuple[bytes, ...]]] = {}
    for seed in range(150):
        by_name.setdefault(task(name).problem(seed).receptacle, set()).add(furniture(name, seed))
    assert "" not in by_name and all(len(shapes) == 1 for shapes in by_name.values())
    assert len({s for shapes in by_name.values() for s in shapes}) == len(by_name)


@pytest.mark.parametrize("name", SIZED)
def test_no_size_is_on_both_sides(name: str, tmp_path: Path) -> None:
    """Over enough problems that sizes do come twice: a split by episodes would have some on both sides."""
    store = EpisodeStore.create(tmp_path, name, CAMERAS, {})
    seeds = range(400)
    sizes = {seed: task(name).problem(seed).receptacle for seed in seeds}
    twice = [seed for seed in seeds if list(sizes.values()).count(sizes[seed]) > 1]
    for seed in [*twice, *[s for s in seeds if s not in set(twice)][:30]]:
        store.write(make_episode(seed, steps=3, task=name, info={RECEPTACLE: sizes[seed]}))
    found = curate(tmp_path, CurationConfig(validation_share=0.3))
    train, held_out = ({furniture(name, s) for s in side} for side in (found.train, found.validation))
    assert train and held_out and not train & held_out
    assert {*found.train, *found.validation} == set(store.seeds) - set(found.dropped)


def test_collected_episodes_tell_their_receptacle_and_no_start_is_in_both(tmp_path: Path) -> None:
    collect(CollectConfig("shelf-receptacle", tmp_path, 6, workers=1, images=False))
    found = curate(tmp_path)
    store = EpisodeStore.open(tmp_path)
    assert all(store.header(s).info[RECEPTACLE] == task("shelf-receptacle").problem(s).receptacle for s in store.seeds)
    train = [store.read(s).initial_state for s in found.train]
    for start in validation_starts(tmp_path, 10):
        assert start.state is not None and start.seed in found.validation
        assert not any(np.array_equal(start.state, other) for other in train if len(other) == len(start.state))


def test_unseen_objects_are_none_of_those_trained_with() -> None:
    trained, unseen = ObjectSet("19"), ObjectSet("unseen")
    assert not set(trained) & set(unseen) and set(trained) | set(unseen) == set(keys_of("72"))
    drawn = {pick_one(unseen, np.random.default_rng([s.seed, 0x0971])) for s in random_starts(300, objects="unseen")}
    assert len(drawn) > 40 and not drawn & set(trained)
    assert not set(task("pick-place@").draw.args[0]) & set(keys_of("72"))  # type: ignore[attr-defined]


def test_seeds_of_demonstrations_corrections_and_trials_are_apart() -> None:
    assert max(10**6, EXPERT_SEED) < CORRECTION_SEEDS_FROM < CORRECTION_SEEDS_FROM + 10**6 < RANDOM_SEEDS_FROM
    starts = [random_starts(50, seed) for seed in range(3)]
    assert len({s.seed for some in starts for s in some}) == 150


def test_a_start_that_the_policy_has_learned_from_is_refused(tmp_path: Path) -> None:
    """A dataset that grew and was curated anew holds others out than those that the policy never saw."""
    data, run = tmp_path / "data", tmp_path / "run"
    collect(CollectConfig("stack", data, 5, workers=1, images=False))
    found = curate(data)
    train(data, run, TrainConfig(steps=2), preset("quick", observe="state").policy)
    require_unseen(run, validation_starts(data, 3))
    (data / "curation.json").unlink()
    collect(CollectConfig("stack", data, 8, workers=1, images=False))
    again = next(c for seed in range(20) if set((c := curate(data, CurationConfig(seed=seed))).validation) & set(found.train))
    leaked = sorted(set(again.validation) & set(found.train))
    for folder in (run, run / "best"):
        with pytest.raises(CheckpointError, match=f"learned from {len(leaked)} of these initial states .seeds {leaked[0]}"):
            evaluate(folder, validation_starts(data, 8), "validation", workers=1)
    with pytest.raises(DatasetError, match=f"run has learned from {len(leaked)} of the {len(again.validation)} initial states"):
        train(data, tmp_path / "on", TrainConfig(steps=2), preset("quick", observe="state").policy, initial=run)
    assert not (tmp_path / "on").exists()
    # a run that begins with its weights has learned from what it had learned from
    next(c for seed in range(20) if not set((c := curate(data, CurationConfig(seed=seed))).validation) & set(found.train))
    one = TrainConfig(steps=2, demonstrations=1)
    train(data, tmp_path / "on", one, preset("quick", observe="state").policy, initial=run)
    store = EpisodeStore.open(data)
    assert {store.header(s).start for s in found.train} <= learned_starts(tmp_path / "on")


def test_sizes_that_are_held_out_are_learned_from_nowhere_else(tmp_path: Path) -> None:
    """Corrections with such a size are left out; a second dataset with one is refused."""

    def sized(name: str, sizes: dict[int, str]) -> Path:
        store = EpisodeStore.create(tmp_path / name, "square", CAMERAS, {"position_scale": 1.0})
        for seed, size in sizes.items():
            store.write(make_episode(seed, steps=6, info={RECEPTACLE: size}))
        return store.path

    data = sized("data", {0: "a", 1: "b", 2: "c"})
    (held_out,) = (validation := curate(data)).validation
    size, other = "abc"[held_out], "abc"[validation.train[0]]
    corrections = sized("corrections", {10: size, 11: other, 12: "d"})
    small = preset("quick-mlp", observe="state").policy
    run = tmp_path / "run"
    train(data, run, TrainConfig(steps=1), small, corrections=corrections)
    corrected = EpisodeStore.open(corrections)
    assert [corrected.header(seed).start in learned_starts(run) for seed in (10, 11, 12)] == [False, True, True]
    more = sized("more", {20: size, 21: size, 22: "e"})
    next(c for seed in range(20) if 20 in (c := curate(more, CurationConfig(seed=seed))).train)
    with pytest.raises(DatasetError, match="have furniture of a size that is learned from"):
        train([data, more], tmp_path / "both", TrainConfig(steps=1), small)


def test_demonstrations_that_all_begin_alike_are_learned_from(tmp_path: Path) -> None:
    """As those of a fixed start do, and imported ones whose states are placeholders."""
    store = EpisodeStore.create(tmp_path / "data", "square", CAMERAS, {"position_scale": 1.0})
    for seed in range(5):
        store.write(make_episode(seed, 12, initial_state=np.zeros(1)))
    assert curate(store.path).validation
    train(store.path, tmp_path / "run", TrainConfig(steps=1), preset("quick-mlp").policy)


def test_a_fresh_start_that_is_in_the_training_data_is_refused(tmp_path: Path) -> None:
    """Nothing keeps a dataset from seeds as high as those of trials."""
    data, run = tmp_path / "data", tmp_path / "run"
    collect(CollectConfig("stack", data, 3, seed=RANDOM_SEEDS_FROM, workers=1, images=False))
    found = curate(data)
    train(data, run, TrainConfig(steps=1), preset("quick-mlp", observe="state").policy)
    first = min(found.train) - RANDOM_SEEDS_FROM
    with pytest.raises(CheckpointError, match=f"learned from the initial state of seed {min(found.train)}"):
        evaluate(run, random_starts(first + 1)[first:], "random", workers=1, conditions=Conditions(horizon=2))
    more = tmp_path / "more"
    collect(CollectConfig("stack", more, 1, seed=found.validation[0], workers=1, images=False))
    with pytest.raises(DatasetError, match="1 of 1 held-out episodes begin like one that is learned from"):
        train(data, tmp_path / "other", TrainConfig(steps=1), preset("quick-mlp", observe="state").policy, corrections=more)
    assert not (tmp_path / "other").exists()
