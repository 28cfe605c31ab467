"""Collection: the same data for any number of workers, and nothing lost or torn when it is killed."""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from safetensors.numpy import load_file

from optimus.collect import CollectConfig, collect
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError, StorageError, UnknownNameError


def contents(folder: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() for p in sorted((folder / "episodes").iterdir())}


def test_any_number_of_workers_gives_the_same_files(tmp_path: Path) -> None:
    one = collect(CollectConfig("stack", tmp_path / "one", 4, seed=50, workers=1))
    collect(CollectConfig("stack", tmp_path / "two", 4, seed=50, workers=2))
    assert one.demonstrations == 4
    assert contents(tmp_path / "one") == contents(tmp_path / "two")


def run_until_killed(folder: Path, seconds: float, episodes: int) -> bool:
    """Whether the collection ended by itself before its time was up."""
    command = [sys.executable, "-m", "optimus.cli", "collect", "stack", "--out", str(folder)]
    command += ["--episodes", str(episodes), "--workers", "1"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
    try:
        return process.wait(seconds) == 0
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return False


def test_killed_and_restarted_it_ends_with_what_was_asked_for(tmp_path: Path) -> None:
    moments, folder, wanted = random.Random(1), tmp_path / "data", 40
    killed = [not run_until_killed(folder, moments.uniform(0.5, 2.5), wanted) for _ in range(20)]
    assert sum(killed) > 10
    while not run_until_killed(folder, 60.0, wanted):
        pass
    store = EpisodeStore.open(folder)
    assert len(store.seeds) == wanted
    assert not list(folder.rglob(".tmp-*"))
    for seed in store.seeds:
        episode = store.read(seed)
        assert episode.success and len(episode) == len(load_file(store.episode_path(seed))["actions"])
    whole = collect(CollectConfig("stack", tmp_path / "whole", wanted, workers=2))
    assert whole.demonstrations == wanted and contents(folder) == contents(tmp_path / "whole")


def test_a_second_call_adds_to_the_first(tmp_path: Path) -> None:
    collect(CollectConfig("pick-place", tmp_path, 1, workers=1))
    first = contents(tmp_path)
    more = collect(CollectConfig("pick-place", tmp_path, 2, workers=1))
    assert more.new == 1 and contents(tmp_path).items() > first.items()
    with pytest.raises(DatasetError, match="more than the 1"):
        collect(CollectConfig("pick-place", tmp_path, 1, workers=1))


def test_bad_input_is_named_and_harms_nothing(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="stack"):
        collect(CollectConfig("stak", tmp_path / "a", 1))
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


def test_a_foreign_file_among_the_episodes_is_named(tmp_path: Path) -> None:
    collect(CollectConfig("stack", tmp_path / "data", 1, workers=1))
    shutil.copy(__file__, tmp_path / "data" / "episodes" / "00000099.safetensors")
    with pytest.raises(DatasetError, match="00000099"):
        EpisodeStore.open(tmp_path / "data").headers()


@pytest.mark.skipif(not Path("/proc/self/task").exists(), reason="needs /proc")
def test_workers_end_with_their_parent(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "optimus.cli", "collect", "stack", "--out", str(tmp_path / "d"), "--workers", "2"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(6)
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    process.kill()
    process.wait()
    assert children
    for _ in range(100):  # a worker that is still loading its modules notices only afterwards
        if not [c for c in children if Path(f"/proc/{c}").exists()]:
            return
        time.sleep(0.2)
    raise AssertionError(f"of {children} some are left")
