"""`EpisodeStore`: a dataset on disk, one write-once file an episode.

    DIR/dataset.json                   format, task, cameras, collection settings, versions, a fingerprint of what the task draws
    DIR/episodes/<seed>.safetensors    one successful episode: arrays, and the rest as JSON in the header
    DIR/failures/<seed>.json           an attempt that failed, with its reason; no images

Any number of processes may write different seeds at once: a file is written aside and renamed.
"""

from __future__ import annotations

import json
import platform
import re
from collections.abc import Iterable, Mapping
from importlib import metadata
from pathlib import Path
from typing import Any

from optimus.data.atomic import is_leftover, make_folder, read_record, remove_leftovers, write_json, write_whole
from optimus.data.episode import OSC, RENDERED, TASKS_OWN, VIEWS, Episode
from optimus.data.episode_file import (
    VERSION,
    EpisodeHeader,
    episode_bytes,
    read_episode,
    read_header,
)
from optimus.errors import DatasetError

DATASET_FORMAT = "optimus-dataset"
DESCRIPTION = "dataset.json"

_EPISODE_NAME = re.compile(r"(\d{8,})\.safetensors")
_FAILURE_NAME = re.compile(r"(\d{8,})\.json")


class EpisodeStore:
    """A dataset folder; made by `create` or `open`."""

    def __init__(self, path: Path, description: dict[str, Any]) -> None:
        self.path = path
        self.task: str = description["task"]
        self.cameras: tuple[str, ...] = tuple(description["cameras"])
        self.config: dict[str, Any] = description["config"]
        self.control: str = self.config.get("control", OSC)
        self.robot: str = self.config.get("robot", TASKS_OWN)
        self.views: tuple[dict[str, Any], ...] = tuple(self.config.get(RENDERED, {}).get(VIEWS, ()))
        self.versions: dict[str, str] = description.get("versions", {})
        self.problems: str = description.get("problems", "")
        """A fingerprint of what the task drew when the dataset was begun; empty where that is not known."""

    @classmethod
    def create(
        cls, path: Path | str, task: str, cameras: Iterable[str], config: Mapping[str, Any], problems: str = ""
    ) -> EpisodeStore:
        """A new dataset, or the one that is there if it was made for the same task with the same settings, and the task still draws
        the same `problems` (see `EpisodeStore.problems`)."""
        path = Path(path)
        wanted = {"task": task, "cameras": list(cameras), "config": json.loads(json.dumps(dict(config)))}
        if (path / DESCRIPTION).exists():
            store = cls.open(path)
            store._require_same(wanted)
            store.require_problems(problems)
            return store
        if path.exists() and (not path.is_dir() or _strangers(path)):
            raise DatasetError(f"{path} is not empty and holds no {DESCRIPTION}, so nobody knows what is in it; name a new folder")
        for folder in (path, path / "episodes", path / "failures"):
            make_folder(folder)
        description = {
            "format": DATASET_FORMAT,
            "version": VERSION,
            **wanted,
            "versions": installed_versions(),
            **({"problems": problems} if problems else {}),
        }
        write_json(path / DESCRIPTION, description)
        return cls(path, description)

    @classmethod
    def open(cls, path: Path | str) -> EpisodeStore:
        """An existing dataset; temporary files of processes that are gone are removed."""
        path = Path(path)
        store = cls(path, _read_description(path))
        for folder in ("episodes", "failures"):
            make_folder(path / folder)
            remove_leftovers(path / folder)
        remove_leftovers(path)
        return store

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the episodes stored, ascending."""
        return _seeds(self.path / "episodes", _EPISODE_NAME)

    @property
    def failed_seeds(self) -> tuple[int, ...]:
        """Seeds of the attempts that failed, ascending."""
        return _seeds(self.path / "failures", _FAILURE_NAME)

    def episode_path(self, seed: int) -> Path:
        """The file of one episode."""
        return self.path / "episodes" / f"{seed:08d}.safetensors"

    def write(self, episode: Episode) -> None:
        """Add a successful episode, whole or not at all."""
        if episode.task != self.task:
            raise DatasetError(f"an episode of {episode.task!r} does not belong in {self.path}, a dataset of {self.task!r}")
        if episode.cameras != self.cameras:
            raise DatasetError(f"episode {episode.seed} has cameras {episode.cameras}, {self.path} has {self.cameras}")
        path = self.episode_path(episode.seed)
        payload = episode_bytes(episode, path)
        if path.exists() and path.read_bytes() != payload:
            raise DatasetError(f"{self.path} holds another episode {episode.seed} already; give this one a seed of its own")
        write_whole(path, payload)

    def write_failure(self, seed: int, reason: str, skeleton: Iterable[str] = (), info: Mapping[str, Any] | None = None) -> None:
        """Record an attempt that failed, so that it is counted and not tried again."""
        value = {"seed": seed, "reason": reason, "skeleton": list(skeleton), "info": dict(info or {})}
        write_json(self.path / "failures" / f"{seed:08d}.json", value)

    def read_failure(self, seed: int) -> dict[str, Any]:
        """`seed`, `reason`, `skeleton`, `info` of an attempt that failed."""
        return read_record(self.path / "failures" / f"{seed:08d}.json")

    def header(self, seed: int) -> EpisodeHeader:
        """What an episode says about itself, without its arrays; damage and foreign files are found here."""
        path = self.episode_path(seed)
        if not path.exists():
            raise DatasetError(f"{self.path} holds no episode {seed}; it holds {_range_text(self.seeds)}")
        header = read_header(path)
        if header.seed != seed:
            raise DatasetError(f"{path} is episode {header.seed} by another's name; give it its own, or move it out of the dataset")
        if header.task != self.task:
            raise DatasetError(f"{path} is an episode of {header.task!r}, not of {self.task!r}; move it out of the dataset")
        return header

    def headers(self) -> list[EpisodeHeader]:
        """All headers, ascending by seed: a check of every file's format and size, one small read each."""
        return [self.header(seed) for seed in self.seeds]

    def read(self, seed: int) -> Episode:
        """One episode with all its arrays."""
        return read_episode(self.header(seed))

    def require_problems(self, problems: str) -> None:
        """`DatasetError` if the dataset was begun with others, as far as that is known: episodes of both would be mixed."""
        if problems and self.problems and problems != self.problems:
            raise DatasetError(
                f"what {self.task} draws for its seeds (places, objects, robot, goal) is not what it was when {self.path} was "
                "begun: something of it has been edited; name another folder, or take the edit back"
            )

    def _require_same(self, wanted: dict[str, Any]) -> None:
        have = {"task": self.task, "cameras": list(self.cameras), **self.config}
        want = {"task": wanted["task"], "cameras": wanted["cameras"], **wanted["config"]}
        if differs := _difference(have, want):
            key, there, here = differs
            raise DatasetError(
                f"{self.path} was collected with {key} = {there!r}, not {here!r}; use the same settings or another folder"
            )


def _difference(have: dict[str, Any], want: dict[str, Any]) -> tuple[str, Any, Any] | None:
    """The first key in which two records differ, as `outer.inner` where they are nested, and what each says; the task first."""
    for key in sorted(have.keys() | want.keys(), key=lambda name: (name != "task", name)):
        there, here = have.get(key), want.get(key)
        if isinstance(there, dict) and isinstance(here, dict):
            if inner := _difference(there, here):
                return f"{key}.{inner[0]}", *inner[1:]
        elif there != here:
            return key, there, here
    return None


def require_no_dataset(folder: Path) -> None:
    """`DatasetError` if the folder is a dataset's: nothing else is written there."""
    if (folder / DESCRIPTION).exists():
        raise DatasetError(f"{folder} holds a dataset; name another folder")


def installed_versions() -> dict[str, str]:
    """Versions of Python, of this package and of what decides about figures: the simulator and the numerics."""
    return {"python": platform.python_version(), **{name: _version(name) for name in ("optimus-tamp", "numpy", "mujoco", "torch")}}


def _version(package: str) -> str:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:  # run from a source tree that is not installed
        return "unknown"


def _read_description(path: Path) -> dict[str, Any]:
    file = path / DESCRIPTION
    if not file.exists():
        raise DatasetError(f"{path} is not a dataset (no dataset.json); collect one, or name the folder of one")
    value = read_record(file, remedy="put back a copy, or collect into another folder: it says how the episodes were made")
    if value.get("format") != DATASET_FORMAT:
        raise DatasetError(f"{file} does not describe a dataset of this program; name another folder")
    if value.get("version") != VERSION or not {"task", "cameras", "config"} <= value.keys():
        raise DatasetError(f"{file} has version {value.get('version')!r}; this program reads version {VERSION}")
    return value


def _seeds(folder: Path, pattern: re.Pattern[str]) -> tuple[int, ...]:
    seeds = []
    for path in folder.iterdir():
        match = pattern.fullmatch(path.name)
        if match:
            seeds.append(int(match.group(1)))
        elif not is_leftover(path):
            raise DatasetError(f"{path} does not belong in a dataset; move it elsewhere")
    return tuple(sorted(seeds))


def _strangers(path: Path) -> bool:
    """Whether a folder holds anything but what an interrupted `create` leaves: episodes, say, that were made nobody knows how."""
    inside = [path, *(folder for name in ("episodes", "failures") if (folder := path / name).is_dir())]
    ours = set(inside[1:])
    return any(p not in ours and not is_leftover(p) for folder in inside for p in folder.iterdir())


def _range_text(seeds: tuple[int, ...]) -> str:
    return f"{len(seeds)} from {seeds[0]} to {seeds[-1]}" if seeds else "none"
