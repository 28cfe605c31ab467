"""Where a reproduction puts things, and what it remembers: folders, seconds, versions."""

from __future__ import annotations

import json
import platform
import re
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import torch

from optimus.data.atomic import make_folder, read_record, write_json
from optimus.data.store import installed_versions, require_no_dataset
from optimus.errors import DatasetError, require_at_least
from optimus.reproduce.budget import Budget

StageProgress = Callable[[str, int, int, dict[str, str]], None]
"""`(stage, done, total, notes)`"""


@dataclass(eq=False)
class Site:
    """The folder of one table under one budget. What trains may be another device from call to call: policies that were taught on
    a GPU can be tried where there is none.

    OUT/reproduce.json   what was asked for, versions, seconds by stage over all sessions
    OUT/data/, OUT/policies/, OUT/expert/   datasets, training runs, and what the expert came to under each condition
    OUT/cells/           one file a cell that is done
    """

    table: str
    out: Path
    budget: Budget
    seed: int = 0
    workers: int = 0
    progress: StageProgress = lambda *_: None
    record: dict[str, Any] = field(default_factory=dict)
    lock: threading.Lock = field(default_factory=threading.Lock)
    """Of the record: several threads may be at work."""
    cell: str = ""
    """For which cell of the table the work is."""

    def __post_init__(self) -> None:
        require_at_least(0, seed=self.seed, workers=self.workers)

    def open(self) -> None:
        """Make the folder, or go on in it; `DatasetError` if it was begun with something else, or holds a dataset."""
        require_no_dataset(self.out)
        path = self.out / "reproduce.json"
        asked = {"table": self.table, "budget": json.loads(json.dumps(asdict(self.budget))), "seed": self.seed}
        if path.exists():
            self.record = read_record(path)
            self.record["asked"]["budget"] = _said_of_all(self.record["asked"]["budget"], asked["budget"])
            asked["budget"]["device"] = self.record["asked"]["budget"]["device"]
            for key, (have, wanted) in _differing(self.record["asked"], asked):
                raise DatasetError(f"{self.out} was begun with {key} = {have!r}, not {wanted!r}; name another folder")
            return
        make_folder(self.out)
        self.record = {"asked": asked, "versions": installed_versions(), "machine": machine(), "seconds": {}}
        write_json(path, self.record)

    @contextmanager
    def timed(self, stage: str) -> Iterator[None]:
        """Adds the time that the block takes to that of the stage, also when it is interrupted."""
        began = time.perf_counter()
        try:
            yield
        finally:
            with self.lock:
                spent = time.perf_counter() - began
                for by, name in (("seconds", stage), ("seconds_by_cell", self.cell)):
                    seconds = self.record.setdefault(by, {})
                    seconds[name] = seconds.get(name, 0.0) + spent
                write_json(self.out / "reproduce.json", self.record)

    @property
    def hours(self) -> float:
        """All sessions together; of the cell that the work is for, if it is for one. Stages that went on at once are added up."""
        with self.lock:
            by_cell = self.record.get("seconds_by_cell", {})
            seconds = by_cell.get(self.cell, 0.0) if self.cell else sum(self.record["seconds"].values())
        return seconds / 3600


def _differing(have: dict[str, Any], wanted: dict[str, Any]) -> Iterator[tuple[str, tuple[Any, Any]]]:
    """Each setting that is another one now, with what it was and is."""
    for key, value in wanted.items():
        there = have.get(key)
        if isinstance(value, dict) and isinstance(there, dict):
            yield from ((f"{key}'s {inner}", pair) for inner, pair in _differing(there, value))
        elif there != value:
            yield key, (there, value)


def _said_of_all(recorded: dict[str, Any], now: dict[str, Any]) -> dict[str, Any]:
    """The budget that an earlier version recorded, with what it could not yet say at what it did, and networks it did not know."""
    defaults = json.loads(json.dumps(asdict(Budget(now["name"], now["demonstrations"]))))
    presets = {**now["presets"], **recorded.get("presets", {})}
    return {**defaults, **recorded, "presets": presets}


def commit() -> str | None:
    """Of the checkout that the package runs from, with `-dirty` where files differ from it; none where it was installed."""
    package = Path(__file__).parents[1]
    ask = lambda *words: subprocess.run(("git", "-C", package, *words), capture_output=True, text=True, check=True).stdout.strip()  # noqa: E731
    try:
        # a package installed within another project's checkout is not of that project's commit
        own = Path(ask("rev-parse", "--show-toplevel")) / "src" / package.name == package
        return ask("describe", "--always", "--dirty", "--abbrev=7", "--exclude=*") if own else None
    except (OSError, subprocess.CalledProcessError):
        return None


def machine() -> dict[str, Any]:
    """What it was measured on."""
    told = Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*:\s*(.+)", told.read_text()) if told.exists() else []
    gpu = torch.cuda.get_device_name() if torch.cuda.is_available() else None
    return {"processor": names[0] if names else platform.machine(), "cores": len(names) or None, "gpu": gpu}
