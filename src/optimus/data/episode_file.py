"""One episode as one safetensors file: its arrays, and everything else as JSON in the header.

The header is parsed here, not by a library, because the windows of training map the arrays where they lie in
the file.
"""

from __future__ import annotations

import hashlib
import json
import math
import struct
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from safetensors.numpy import save

from optimus.data.episode import Episode
from optimus.errors import DatasetError

EPISODE_FORMAT = "optimus-episode"
VERSION = 1
OBSERVATION_PREFIX = "obs."
STATES = "states"
"""The physics states before every action, in files that have them."""

_DTYPES = {"U8": np.uint8, "F32": np.float32, "F64": np.float64, "I64": np.int64, "BOOL": np.bool_}
_MAX_HEADER = 100_000_000  # [bytes], the format's own limit
_REMEDY = "delete it and collect again to replace it"


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

    @cached_property
    def start(self) -> str:
        """Which initial state this is (see `start_digest`)."""
        return start_digest(self.read("initial_state"))

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


def start_digest(state: NDArray[Any]) -> str:
    """A name of a physics state: the same one for the same numbers alone."""
    return hashlib.sha256(np.ascontiguousarray(state, np.float64).tobytes()).hexdigest()[:12]


def episode_bytes(episode: Episode, path: Path) -> bytes:
    """The content of an episode's file; `path` is where it will be, for the message if something is not as readers need it."""
    arrays = _arrays(episode)
    for name, array in arrays.items():
        require_finite(array, path, name)
        if array.dtype.type not in _DTYPES.values():
            raise DatasetError(f"{path}: {name} is of {array.dtype}; an episode's arrays are of {', '.join(map(_name, _DTYPES))}")
        if name != "initial_state" and array.shape[:1] != (len(episode),):
            raise DatasetError(f"{path}: {name} has shape {array.shape}, but there are {len(episode)} actions")
    if episode.seed < 0:
        raise DatasetError(f"{path}: an episode's seed is 0 or more, not {episode.seed}")
    if episode.objects.shape[1:] != (len(episode.object_names), 3):
        raise DatasetError(f"{path}: objects has shape {episode.objects.shape}, not (steps, {len(episode.object_names)}, 3)")
    try:
        metadata = _metadata(episode)
    except TypeError as error:
        raise DatasetError(f"{path}: info holds what JSON cannot say: {error}") from error
    return _in_order(save(arrays, metadata={"format": EPISODE_FORMAT, "episode": metadata}))


def _name(dtype: str) -> str:
    return np.dtype(_DTYPES[dtype]).name


def _in_order(payload: bytes) -> bytes:
    """The same file with its header's entries sorted: the writer leaves the metadata in an order that changes from process to
    process, and the same episode has to be the same bytes."""
    length = int.from_bytes(payload[:8], "little")
    header = json.dumps(json.loads(payload[8 : 8 + length]), sort_keys=True, separators=(",", ":")).encode()
    header += b" " * (-len(header) % 8)
    return len(header).to_bytes(8, "little") + header + payload[8 + length :]


def read_episode(header: EpisodeHeader) -> Episode:
    """The episode with all its arrays."""
    episode = Episode(
        task=header.task,
        seed=header.seed,
        agent=header.agent,
        observations={name: header.read(OBSERVATION_PREFIX + name) for name in header.observation_names},
        actions=header.read("actions"),
        executed=header.read("executed"),
        initial_state=header.read("initial_state"),
        objects=header.read("objects"),
        object_names=header.object_names,
        success=header.success,
        failure=header.failure,
        skeleton=header.skeleton,
        info=header.info,
        states=header.read(STATES) if STATES in header.arrays else None,
    )
    for name, array in _arrays(episode).items():
        require_finite(array, header.path, name)
    return episode


def require_finite(array: NDArray[Any], path: Path, name: str) -> None:
    """`DatasetError` if a floating-point array holds NaN or infinity."""
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise DatasetError(f"{path}: {name} holds NaN or infinity; {_REMEDY}")


def read_header(path: Path) -> EpisodeHeader:
    """Parse and check the header of an episode file: format, keys, and that the file is as long as it
    says."""
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
    except (ValueError, KeyError, TypeError, AttributeError, IndexError) as error:
        raise DatasetError(f"{path} is not an episode file or is damaged ({error}); {_REMEDY}") from error
    if path.stat().st_size != end:
        raise DatasetError(f"{path} is {path.stat().st_size} bytes long, its header says {end}; {_REMEDY}")
    return header


def _slot(entry: dict[str, Any], data_start: int) -> ArraySlot:
    dtype, shape, (begin, end) = np.dtype(_DTYPES[entry["dtype"]]), tuple(map(int, entry["shape"])), entry["data_offsets"]
    if math.prod(shape) * dtype.itemsize != end - begin:
        raise ValueError(f"{end - begin} bytes for an array of shape {shape} and {dtype}")
    return ArraySlot(dtype, shape, data_start + begin)


def _header(path: Path, facts: dict[str, Any], arrays: dict[str, ArraySlot]) -> EpisodeHeader:
    names = tuple(facts["observations"])
    steps = arrays["actions"].shape[0]
    for name in ("executed", "objects", *{STATES} & arrays.keys(), *(OBSERVATION_PREFIX + n for n in names)):
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
    named |= {} if episode.states is None else {STATES: episode.states}
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
