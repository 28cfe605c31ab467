"""`EpisodeStore`: a dataset on disk, one write-once file an episode.

    DIR/dataset.json                      format, task, cameras, the configuration it was collected with, versions
    DIR/episodes/<seed>.safetensors       arrays of one successful episode; everything else as JSON in its header
    DIR/failures/<seed>.json              an attempt that failed, with its reason; no images

Any number of processes may write different seeds at once: a file is written aside and renamed.
"""

from __future__ import annotations

import json
import platform
import re
import struct
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from optimus.data.atomic import is_leftover, make_folder, remove_leftovers, write_json, write_whole
from optimus.data.episode import Episode
from optimus.errors import DatasetError

DATASET_FORMAT = "optimus-dataset"
EPISODE_FORMAT = "optimus-episode"
VERSION = 1
OBSERVATION_PREFIX = "obs."

_EPISODE_NAME = re.compile(r"(\d{8,})\.safetensors")
_FAILURE_NAME = re.compile(r"(\d{8,})\.json")
_DTYPES = {"U8": np.uint8, "F32": np.float32, "F64": np.float64, "I64": np.int64, "BOOL": np.bool_}
_MAX_HEADER = 100_000_000  # [bytes], the format's own limit


@dataclass(frozen=True)
class ArraySlot:
    """Where one array lies in an episode file: `offset` [bytes] counts from the start of the file."""

    dtype: np.dtype[Any]
    shape: tuple[int, ...]
    offset: int


@dataclass(frozen=True, eq=False)
class EpisodeHeader:
    """What an episode file says about itself; read without touching its arrays."""

    path: Path
    seed: int
    task: str
    agent: str
    object_names: tuple[str, ...]
    observation_names: tuple[str, ...]
    success: bool
    failure: str
    skeleton: tuple[str, ...]
    info: dict[str, Any]
    arrays: dict[str, ArraySlot]

    @property
    def steps(self) -> int:
        """The number of actions."""
        return self.arrays["actions"].shape[0]

    def read(self, name: str) -> NDArray[Any]:
        """One array of the file, e.g. `actions` or `obs.robot0_eef_pos`."""
        if name not in self.arrays:
            raise DatasetError(f"{self.path} holds no {name}; it holds {', '.join(sorted(self.arrays))}")
        slot = self.arrays[name]
        count = int(np.prod(slot.shape))
        try:
            flat = np.fromfile(self.path, dtype=slot.dtype, count=count, offset=slot.offset)
        except OSError as error:
            raise DatasetError(f"cannot read {self.path}: {error.strerror or error}") from error
        if flat.size != count:
            raise DatasetError(f"{self.path} is cut short at {name}; {_REMEDY}")
        return flat.reshape(slot.shape)


_REMEDY = "delete it and collect again to replace it"


class EpisodeStore:
    """A dataset folder; made by `create` or `open`."""

    def __init__(self, path: Path, description: dict[str, Any]) -> None:
        self.path = path
        self.task: str = description["task"]
        self.cameras: tuple[str, ...] = tuple(description["cameras"])
        self.config: dict[str, Any] = description["config"]
        self.versions: dict[str, str] = description.get("versions", {})

    @classmethod
    def create(
        cls, path: Path | str, task: str, cameras: Iterable[str], config: Mapping[str, Any]
    ) -> EpisodeStore:
        """A new dataset, or the one that is already there if it was made for the same task with the same configuration."""
        path = Path(path)
        wanted = {"task": task, "cameras": list(cameras), "config": json.loads(json.dumps(dict(config)))}
        if (path / "dataset.json").exists():
            store = cls.open(path)
            store._require_same(wanted)
            return store
        if path.exists() and (not path.is_dir() or _strangers(path)):
            raise DatasetError(f"{path} is not empty and holds no dataset.json; name a new or empty folder")
        for folder in (path, path / "episodes", path / "failures"):
            make_folder(folder)
        description = {
            "format": DATASET_FORMAT,
            "version": VERSION,
            **wanted,
            "versions": installed_versions(),
        }
        write_json(path / "dataset.json", description)
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
            raise DatasetError(
                f"an episode of {episode.task!r} does not belong in {self.path}, a dataset of {self.task!r}"
            )
        if episode.cameras != self.cameras:
            raise DatasetError(
                f"episode {episode.seed} has cameras {episode.cameras}, {self.path} has {self.cameras}"
            )
        path = self.episode_path(episode.seed)
        arrays = _arrays(episode)
        for name, array in arrays.items():
            require_finite(array, path, name)
        write_whole(path, save(arrays, metadata={"format": EPISODE_FORMAT, "episode": _metadata(episode)}))

    def write_failure(
        self, seed: int, reason: str, skeleton: Iterable[str] = (), info: Mapping[str, Any] | None = None
    ) -> None:
        """Record an attempt that failed, so that it is counted and not tried again."""
        value = {"seed": seed, "reason": reason, "skeleton": list(skeleton), "info": dict(info or {})}
        write_json(self.path / "failures" / f"{seed:08d}.json", value)

    def read_failure(self, seed: int) -> dict[str, Any]:
        """`seed`, `reason`, `skeleton`, `info` of an attempt that failed."""
        return _read_json(self.path / "failures" / f"{seed:08d}.json")

    def header(self, seed: int) -> EpisodeHeader:
        """What episode `seed` says about itself, without its arrays; damage and foreign files are found here."""
        path = self.episode_path(seed)
        if not path.exists():
            raise DatasetError(f"{self.path} holds no episode {seed}; it holds {_range_text(self.seeds)}")
        header = read_header(path)
        if header.task != self.task:
            raise DatasetError(
                f"{path} is an episode of {header.task!r}, not of {self.task!r}; move it out of the dataset"
            )
        return header

    def headers(self) -> list[EpisodeHeader]:
        """All headers, ascending by seed: a check of every file's format and size at the cost of one small read each."""
        return [self.header(seed) for seed in self.seeds]

    def read(self, seed: int) -> Episode:
        """One episode with all its arrays."""
        header = self.header(seed)
        observations = {name: header.read(OBSERVATION_PREFIX + name) for name in header.observation_names}
        episode = Episode(
            task=header.task,
            seed=header.seed,
            agent=header.agent,
            observations=observations,
            actions=header.read("actions"),
            executed=header.read("executed"),
            initial_state=header.read("initial_state"),
            objects=header.read("objects"),
            object_names=header.object_names,
            success=header.success,
            failure=header.failure,
            skeleton=header.skeleton,
            info=header.info,
        )
        for name, array in _arrays(episode).items():
            require_finite(array, header.path, name)
        return episode

    def _require_same(self, wanted: dict[str, Any]) -> None:
        have = {"task": self.task, "cameras": list(self.cameras), **self.config}
        want = {"task": wanted["task"], "cameras": wanted["cameras"], **wanted["config"]}
        for key in sorted(have.keys() | want.keys()):
            if have.get(key) != want.get(key):
                raise DatasetError(
                    f"{self.path} was collected with {key} = {have.get(key)!r}, not {want.get(key)!r}; "
                    "use the same settings or another folder"
                )


def require_finite(array: NDArray[Any], path: Path, name: str) -> None:
    """`DatasetError` if a floating-point array holds NaN or infinity."""
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise DatasetError(f"{path}: {name} holds NaN or infinity; {_REMEDY}")


def read_header(path: Path) -> EpisodeHeader:
    """Parse and check the header of an episode file: format, keys, and that the file is as long as it says."""
    try:
        with path.open("rb") as file:
            prefix = file.read(8)
            length = struct.unpack("<Q", prefix)[0] if len(prefix) == 8 else _MAX_HEADER + 1
            text = file.read(length) if length <= _MAX_HEADER else b""
        entries = json.loads(text)
        meta = entries.pop("__metadata__")
        if meta["format"] != EPISODE_FORMAT:
            raise ValueError(f"format {meta['format']!r}")
        facts = json.loads(meta["episode"])
        if facts["version"] != VERSION:
            raise ValueError(f"version {facts['version']!r}")
        arrays = {name: _slot(entry, 8 + length) for name, entry in entries.items()}
        end = 8 + length + max(entry["data_offsets"][1] for entry in entries.values())
        header = _header(path, facts, arrays)
    except OSError as error:
        raise DatasetError(f"cannot read {path}: {error.strerror or error}") from error
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise DatasetError(f"{path} is not an episode file or is damaged ({error}); {_REMEDY}") from error
    if path.stat().st_size != end:
        raise DatasetError(f"{path} is {path.stat().st_size} bytes long, its header says {end}; {_REMEDY}")
    return header


def installed_versions() -> dict[str, str]:
    """Versions of Python, this package and numpy."""
    return {"python": platform.python_version(), "numpy": np.__version__, "optimus-tamp": _package_version()}


def _package_version() -> str:
    try:
        return metadata.version("optimus-tamp")
    except metadata.PackageNotFoundError:  # run from a source tree that is not installed
        return "unknown"


def _slot(entry: dict[str, Any], data_start: int) -> ArraySlot:
    return ArraySlot(
        np.dtype(_DTYPES[entry["dtype"]]), tuple(entry["shape"]), data_start + entry["data_offsets"][0]
    )


def _header(path: Path, facts: dict[str, Any], arrays: dict[str, ArraySlot]) -> EpisodeHeader:
    names = tuple(facts["observations"])
    steps = arrays["actions"].shape[0]
    for name in ("executed", "objects", *(OBSERVATION_PREFIX + n for n in names)):
        if arrays[name].shape[0] != steps:
            raise ValueError(f"{name} has {arrays[name].shape[0]} steps, actions have {steps}")
    return EpisodeHeader(
        path=path,
        seed=int(facts["seed"]),
        task=facts["task"],
        agent=facts["agent"],
        object_names=tuple(facts["object_names"]),
        observation_names=names,
        success=bool(facts["success"]),
        failure=facts["failure"],
        skeleton=tuple(facts["skeleton"]),
        info=facts["info"],
        arrays=arrays,
    )


def _arrays(episode: Episode) -> dict[str, NDArray[Any]]:
    named = {OBSERVATION_PREFIX + name: array for name, array in episode.observations.items()}
    named |= {"actions": episode.actions, "executed": episode.executed}
    named |= {"initial_state": episode.initial_state, "objects": episode.objects}
    return {name: np.ascontiguousarray(array) for name, array in named.items()}


def _metadata(episode: Episode) -> str:
    return json.dumps(
        {
            "version": VERSION,
            "task": episode.task,
            "seed": int(episode.seed),
            "agent": episode.agent,
            "observations": list(episode.observations),
            "object_names": list(episode.object_names),
            "success": bool(episode.success),
            "failure": episode.failure,
            "skeleton": list(episode.skeleton),
            "info": episode.info,
        }
    )


def _read_description(path: Path) -> dict[str, Any]:
    file = path / "dataset.json"
    if not file.exists():
        raise DatasetError(
            f"{path} is not a dataset (no dataset.json); collect one, or name the folder of one"
        )
    value = _read_json(file)
    if not isinstance(value, dict) or value.get("format") != DATASET_FORMAT:
        raise DatasetError(f"{file} does not describe a dataset of this program; name another folder")
    if value.get("version") != VERSION or not {"task", "cameras", "config"} <= value.keys():
        raise DatasetError(
            f"{file} has version {value.get('version')!r}; this program reads version {VERSION}"
        )
    return value


def _read_json(file: Path) -> Any:
    try:
        return json.loads(file.read_text())
    except OSError as error:
        raise DatasetError(f"cannot read {file}: {error.strerror or error}") from error
    except ValueError as error:
        raise DatasetError(f"{file} is not JSON ({error}); {_REMEDY}") from error


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
    """Whether a folder holds anything but what an interrupted `create` leaves."""
    ours = {"episodes", "failures"}
    return any(p.name not in ours and not is_leftover(p) for p in path.iterdir())


def _range_text(seeds: tuple[int, ...]) -> str:
    return f"{len(seeds)} from {seeds[0]} to {seeds[-1]}" if seeds else "none"
