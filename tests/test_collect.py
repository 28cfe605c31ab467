"""Collection: the same data for any number of workers, and nothing lost or torn when it is killed."""

import errno
import os
import shutil
import subprocess
import sys
from concurrent.futures.process import BrokenProcessPool
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from kills import contents, disturb
from optimus.collect import MOST_BROKEN, CollectConfig, collect
from optimus.data.atomic import is_leftover
from optimus.data.episode import DOOR_ANGLES
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.demonstrate import Attempt, ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError, StorageError, UnknownNameError, WorkerError
from optimus.rerender import RenderConfig, rerender
from optimus.rollout import Perturbation
from optimus.tasks import task
from optimus.tasks.stack import STACK


def test_any_number_of_workers_gives_the_same_files(tmp_path: Path) -> None:
    one = collect(CollectConfig("stack", tmp_path / "one", 3, seed=50, workers=1))
    collect(CollectConfig("stack", tmp_path / "two", 3, seed=50, workers=2))
    assert one.demonstrations == 3
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs /proc")
def test_killed_at_random_moments_it_ends_with_what_was_asked_for(tmp_path: Path) -> None:
    """A worker once, and then the parent; `python tests/kills.py` does fifty."""
    kills = disturb(tmp_path / "killed", 16, moments=2, seed=1, longest=1.0)
    assert kills.parents and kills.workers
    collect(CollectConfig("stack", tmp_path / "whole", 16, workers=1, images=False))
    assert contents(tmp_path / "killed") == contents(tmp_path / "whole")


def test_workers_that_are_always_killed_are_given_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    attempts = []

    def killed(config: CollectConfig, seed: int) -> None:
        attempts.append(seed)
        raise BrokenProcessPool("killed")

    monkeypatch.setattr("optimus.collect._attempt", killed)
    with pytest.raises(WorkerError, match="fewer --workers"):
        collect(CollectConfig("stack", tmp_path, 1, workers=1, images=False))
    assert len(attempts) == MOST_BROKEN and len(set(attempts)) == 1


@pytest.mark.parametrize("room", [200, 400])
def test_a_full_disk_stops_it_clearly_and_room_lets_it_go_on(tmp_path: Path, room: int) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={room}k", "tmpfs", str(disk)], capture_output=True).returncode:
        pytest.skip("needs the right to mount")
    try:
        config = CollectConfig("stack", disk / "data", 16, workers=1 if room == 200 else 2, images=False)
        with pytest.raises(StorageError, match=r"No space left on device.*whole: make room"):
            collect(config)
        store = EpisodeStore.open(disk / "data")
        had = contents(disk / "data")
        assert 0 < len(store.seeds) < 16 and all(store.read(seed).success for seed in store.seeds)
        assert not [p for p in disk.rglob("*") if is_leftover(p)]
        subprocess.run(["mount", "-o", "remount,size=8m", str(disk)], check=True)
        assert collect(config).demonstrations == 16
        assert contents(disk / "data").items() > had.items()
    finally:
        subprocess.run(["umount", str(disk)], check=True)


def test_a_write_that_fails_for_want_of_room_stops_it_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The same without the right to mount: the write call itself says that the disk is full."""
    config = CollectConfig("stack", tmp_path, 3, workers=1, images=False)
    replace, times = Path.replace, []

    def full(self: Path, target: Path) -> Path:
        times.append(target)
        if len(times) == 3:  # the description of the dataset, an episode, and then
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        return replace(self, target)

    with monkeypatch.context() as patch, pytest.raises(StorageError, match="No space left on device"):
        patch.setattr(Path, "replace", full)
        collect(config)
    assert len(EpisodeStore.open(tmp_path).seeds) == 1
    assert collect(config).new == 2


def test_without_images_all_else_is_the_same(tmp_path: Path) -> None:
    for images in (True, False):
        collect(CollectConfig("stack", tmp_path / str(images), 2, workers=1, images=images))
    with_images, without = (EpisodeStore.open(tmp_path / str(images)) for images in (True, False))
    assert without.cameras == () and with_images.cameras
    for seed in with_images.seeds:
        a, b = with_images.read(seed), without.read(seed)
        np.testing.assert_array_equal(a.actions, b.actions)
        np.testing.assert_array_equal(a.states, b.states)  # pyright: ignore[reportArgumentType]
        assert set(a.observations) - set(b.observations) == {f"{camera}_image" for camera in a.cameras}


def test_states_are_what_was_seen(tmp_path: Path) -> None:
    """The recorded rows, read by their columns, put the objects where the episode says they were."""
    collect(CollectConfig("microwave", tmp_path, 1, workers=1, images=False))
    store = EpisodeStore.open(tmp_path)
    episode = store.read(store.seeds[0])
    assert episode.states is not None and len(episode.states) == len(episode)
    np.testing.assert_allclose(np.diff(episode.states[:, 0]), 0.05, atol=1e-9)
    columns = episode.info["state_columns"]
    for i, name in enumerate(episode.object_names):
        at = columns["objects"][name]
        np.testing.assert_allclose(episode.states[:, at : at + 3], episode.objects[:, i], atol=1e-6)
        np.testing.assert_allclose(np.linalg.norm(episode.states[:, at + 3 : at + 7], axis=1), 1.0, atol=1e-6)
    (door,) = columns["doors"].values()
    assert episode.states[0, door] < 0.1 < episode.states[:, door].max()
    taught = Windows(store, store.seeds, WindowConfig(images=False)).proprioception[DOOR_ANGLES]
    env = ManipulationEnv(task("microwave"), images=False, positions=True)
    seen, _ = env.reset(seed=episode.seed)
    for action, angle in zip(episode.executed, taught, strict=True):  # learned from what was recorded, told by the simulator
        np.testing.assert_allclose(seen[DOOR_ANGLES], angle, atol=1e-5)
        seen, *_ = env.step(action)
    assert env.observation_space.contains(seen)
    pulled = (taught[:, 0] > 0.2) & (np.gradient(taught[:, 0]) > 0.01)
    off = np.linalg.norm(episode.executed[pulled, :3] - episode.actions[pulled, :3], axis=1)
    assert pulled.sum() > 20 and (off > 0.01).mean() > 0.5  # a policy is shown ways back to the handle's arc as well


def test_progress_tells_of_failures_by_reason(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = demonstrate

    def sometimes(env: ManipulationEnv, seed: int, *others: Any) -> Attempt:
        return Attempt(seed, None, f"no plan: {seed % 3}", 0.1, {}) if seed % 2 else real(env, seed, *others)

    monkeypatch.setattr("optimus.collect.demonstrate", sometimes)
    seen = []
    collect(CollectConfig("stack", tmp_path, 3, workers=1, images=False), lambda t: seen.append((t.successes, dict(t.failures))))
    assert seen[0] == (0, {}) and seen[-1] == (3, {"no plan: 1": 1, "no plan: 0": 1})
    collect(CollectConfig("stack", tmp_path, 4, workers=1, images=False), lambda t: seen.append((t.had, t.attempts)))
    assert seen[-1] == (3, 7)


def test_pushes_and_pauses_do_not_make_the_longer_demonstrations_fail(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("optimus.tasks.stack.STACK", replace(STACK, horizon=100))
    pushed = ExpertConfig(perturbation=Perturbation())
    for name, expert in (("alone", ExpertConfig()), ("pushed", pushed)):
        collect(CollectConfig("stack", tmp_path / name, 3, workers=1, expert=expert, images=False))
    alone, meddled = (EpisodeStore.open(tmp_path / name) for name in ("alone", "pushed"))
    assert max(alone.header(s).steps for s in alone.seeds) <= 100
    assert 100 < max(meddled.header(s).steps for s in meddled.seeds) <= 150


def test_ray_gives_the_same_files(tmp_path: Path) -> None:
    pytest.importorskip("ray")
    collect(CollectConfig("stack", tmp_path / "ray", 4, workers=2, images=False, backend="ray"))
    collect(CollectConfig("stack", tmp_path / "here", 4, workers=1, images=False))
    assert contents(tmp_path / "ray") == contents(tmp_path / "here")


def test_a_second_call_adds_to_the_first(tmp_path: Path) -> None:
    collect(CollectConfig("pick-place", tmp_path, 1, workers=1))
    first = contents(tmp_path)
    more = collect(CollectConfig("pick-place", tmp_path, 2, workers=1))
    assert more.new == 1 and contents(tmp_path).items() > first.items()
    with pytest.raises(DatasetError, match="more than the 1"):
        collect(CollectConfig("pick-place", tmp_path, 1, workers=1))


def test_an_edited_task_is_not_mixed_with_what_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    mine = ModuleType("my_tasks")
    monkeypatch.setitem(sys.modules, "my_tasks", mine)
    mine.STACK = task("stack")  # type: ignore[attr-defined]
    config = CollectConfig("my_tasks:STACK", tmp_path / "data", 1, workers=1, images=False)
    collect(config)
    before = contents(config.out)
    mine.STACK = replace(task("stack"), draw=lambda rng: replace(task("stack").draw(rng), variant="edited"))  # type: ignore[attr-defined]
    with pytest.raises(DatasetError, match="has been edited"):
        collect(replace(config, episodes=2))
    with pytest.raises(DatasetError, match="has been edited"):
        rerender(config.out, tmp_path / "rendered", RenderConfig(), workers=1)
    assert contents(config.out) == before and not (tmp_path / "rendered").exists()
    mine.STACK = replace(task("stack"), summary="in other words")  # type: ignore[attr-defined]
    assert collect(replace(config, episodes=2)).new == 1
    assert rerender(config.out, tmp_path / "rendered", RenderConfig(), workers=1).problems == EpisodeStore.open(config.out).problems


def test_bad_input_is_named_and_harms_nothing(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="stack"):
        collect(CollectConfig("stak", tmp_path / "a", 1))
    with pytest.raises(UnknownNameError, match="local, ray"):
        collect(CollectConfig("stack", tmp_path / "a", 1, backend="slurm"))
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    (foreign / "thesis.txt").write_text("precious")
    with pytest.raises(DatasetError, match="foreign"):
        collect(CollectConfig("stack", foreign, 1))
    assert (foreign / "thesis.txt").read_text() == "precious"
    with pytest.raises(StorageError):
        collect(CollectConfig("stack", foreign / "thesis.txt" / "data", 1))
    collect(CollectConfig("stack", tmp_path / "data", 1, workers=1))
    with pytest.raises(DatasetError, match="pick-place"):
        collect(CollectConfig("pick-place", tmp_path / "data", 2, workers=1))


def test_a_damaged_episode_does_not_count(tmp_path: Path) -> None:
    config = CollectConfig("stack", tmp_path / "data", 2, workers=1, images=False)
    collect(config)
    path = EpisodeStore.open(config.out).episode_path(1)
    path.write_bytes(path.read_bytes()[:3000])
    with pytest.raises(DatasetError, match=r"00000001\.safetensors.*delete it"):
        collect(config)
    path.unlink()
    assert collect(config).new == 1


def test_a_foreign_file_among_the_episodes_is_named(tmp_path: Path) -> None:
    collect(CollectConfig("stack", tmp_path / "data", 1, workers=1))
    shutil.copy(__file__, tmp_path / "data" / "episodes" / "00000099.safetensors")
    with pytest.raises(DatasetError, match="00000099"):
        EpisodeStore.open(tmp_path / "data").headers()
