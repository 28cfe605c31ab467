"""Kill a collection again and again: its parent or one of its workers, at random moments. By hand, for fifty of them:

    python tests/kills.py --moments 50

After every kill of the parent nothing may be left running; files are whole, and what else is left is at most part of an episode
a worker. A killed worker must not stop the collection. In the end the dataset is, byte for byte, what an undisturbed one gives.
"""

from __future__ import annotations

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from optimus.collect import CollectConfig, collect
from optimus.data.atomic import is_leftover
from optimus.data.store import EpisodeStore

WORKERS = 2
PATIENCE = 60.0
"""A worker that is still loading its modules notices only afterwards that it is alone [s]."""


@dataclass(eq=False)
class Kills:
    """What was done and what came of it."""

    parents: int = 0
    workers: int = 0
    ended: int = 0
    """Times that the collection was through before its moment came."""
    leftovers: int = 0
    largest_leftover: int = 0
    """[bytes]"""
    seconds_to_end: float = 0.0
    """The longest that any process lived on after its parent."""


def contents(folder: Path) -> dict[str, bytes]:
    return {p.name: p.read_bytes() for p in sorted((folder / "episodes").iterdir()) if not is_leftover(p)}


def descendants(pid: int) -> set[int]:
    """All processes below one, as the kernel tells."""
    found: set[int] = set()
    with suppress(OSError):
        for thread in Path(f"/proc/{pid}/task").iterdir():
            for child in map(int, (thread / "children").read_text().split()):
                found |= {child} | descendants(child)
    return found


def runs(pid: int) -> bool:
    """Whether a process is there and not just waiting to be counted."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def workers_of(pid: int) -> list[int]:
    """The spawned workers: children whose command line says so."""
    found = []
    for child in descendants(pid):
        with suppress(OSError):
            if b"spawn_main" in Path(f"/proc/{child}/cmdline").read_bytes():
                found.append(child)
    return sorted(found)


def start(folder: Path, episodes: int) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "optimus.cli", "collect", "stack", "--out", str(folder), "--no-images"]
    command += ["--episodes", str(episodes), "--workers", str(WORKERS)]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True)


def check_folder(folder: Path, kills: Kills) -> int:
    """The number of episodes in the folder, every one of which must be whole; what else is there is measured."""
    if not (folder / "dataset.json").exists():
        return 0
    left = [p for p in folder.rglob("*") if p.is_file() and is_leftover(p)]
    whole = [p.stat().st_size for p in (folder / "episodes").glob("*.safetensors")]
    kills.leftovers += len(left)
    kills.largest_leftover = max([kills.largest_leftover, *(p.stat().st_size for p in left)])
    assert len(left) <= WORKERS + 1 and all(p.stat().st_size <= 2 * max(whole, default=10**6) for p in left), left
    store = EpisodeStore.open(folder)
    for seed in store.seeds:
        assert store.read(seed).success
    assert not [p for p in folder.rglob("*") if p.is_file() and is_leftover(p)]
    return len(store.seeds)


def kill_parent(process: subprocess.Popen[bytes], kills: Kills) -> None:
    below = descendants(process.pid)
    process.kill()
    process.wait()
    began = time.perf_counter()
    while alive := [pid for pid in below if runs(pid)]:
        assert time.perf_counter() - began < PATIENCE, f"orphans: {alive}"
        time.sleep(0.05)
    kills.parents += 1
    kills.seconds_to_end = max(kills.seconds_to_end, time.perf_counter() - began)


def disturb(folder: Path, episodes: int, moments: int, seed: int, longest: float = 6.0) -> Kills:
    """Kill the collection into `folder` at so many random moments, parent and worker by turns, then let it end."""
    rng, kills, had, process = random.Random(seed), Kills(), 0, start(folder, episodes)
    while kills.parents + kills.workers < moments:
        workers_turn = kills.workers <= kills.parents
        while workers_turn and process.poll() is None and not workers_of(process.pid):
            time.sleep(0.05)
        time.sleep(rng.uniform(0.1, longest))
        if process.poll() is not None:
            break
        victims = workers_of(process.pid)
        if victims and workers_turn:
            with suppress(ProcessLookupError):
                os.kill(rng.choice(victims), signal.SIGKILL)
            kills.workers += 1
            continue
        kill_parent(process, kills)
        now = check_folder(folder, kills)
        assert now >= had, "episodes were lost"
        had, process = now, start(folder, episodes)
    _, errors = process.communicate()
    assert process.returncode == 0, errors.decode()[-2000:]
    kills.ended = int(kills.parents + kills.workers < moments)
    assert check_folder(folder, kills) == episodes
    return kills


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--moments", type=int, default=50)
    parser.add_argument("--episodes", type=int, default=600)
    parser.add_argument("--longest", type=float, default=6.0, help="most seconds from one kill to the next")
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        kills = disturb(Path(folder) / "killed", asked.episodes, asked.moments, asked.seed, asked.longest)
        sys.stdout.write(f"{kills}\n")
        sys.stdout.flush()
        collect(CollectConfig("stack", Path(folder) / "whole", asked.episodes, workers=1, images=False))
        assert contents(Path(folder) / "killed") == contents(Path(folder) / "whole")
    sys.stdout.write("nothing lost, nothing torn, no orphan; the same bytes as undisturbed\n")


if __name__ == "__main__":
    main()
