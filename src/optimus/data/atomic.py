"""Files that are there whole or not at all: written aside in the same folder, then renamed over the target.

A killed process leaves at most a `<name>.tmp-<host>-<pid>` behind, which `remove_leftovers` clears once that process
is gone (of another machine, which may share the folder, once it is an hour old). Nothing is flushed to the platter
(`fsync` would cost more than the simulation of an episode): after
a power cut a file may be short, which readers find by its size.
"""

from __future__ import annotations

import json
import os
import platform
import re
import time
from pathlib import Path
from typing import Any

from optimus.errors import StorageError

_LEFTOVER = re.compile(r"\.tmp-(.*)-(\d+)$")
_HOST = re.sub(r"[^\w.]", "_", platform.node())
_LONG_AGO = 3600.0
"""[s]; no file takes so long to write."""


def is_leftover(path: Path) -> bool:
    """Whether this is a temporary file of `write_whole`."""
    return _LEFTOVER.search(path.name) is not None


def make_folder(path: Path) -> None:
    """Create a folder and its parents; `StorageError` says why not."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(f"cannot create {path}: {error.strerror or error}") from error


def write_whole(path: Path, payload: bytes | memoryview) -> None:
    """Write `payload` to `path`, whole or not at all; what stood there before is replaced in one step."""
    aside = path.with_name(f"{path.name}.tmp-{_HOST}-{os.getpid()}")
    try:
        with aside.open("wb") as file:
            file.write(payload)
        aside.replace(path)
    except OSError as error:
        _discard(aside)
        raise StorageError(f"cannot write {path}: {error.strerror or error}; nothing was changed") from error
    except BaseException:
        _discard(aside)
        raise


def write_json(path: Path, value: Any) -> None:
    """Write a JSON-able value, whole or not at all."""
    write_whole(path, (json.dumps(value, indent=2) + "\n").encode())


def remove_leftovers(folder: Path) -> list[str]:
    """Delete the temporary files in `folder` whose process is gone; their names are returned."""
    removed = []
    for path in sorted(folder.glob("*.tmp-*")):
        match = _LEFTOVER.search(path.name)
        if match and _is_abandoned(path, *match.groups()):
            _discard(path)
            removed.append(path.name)
    return removed


def _is_abandoned(path: Path, host: str, pid: str) -> bool:
    if host == _HOST:
        return not _is_alive(int(pid))
    try:
        return time.time() - path.stat().st_mtime > _LONG_AGO
    except FileNotFoundError:  # renamed meanwhile
        return False


def _discard(path: Path) -> None:
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise StorageError(f"cannot remove {path}: {error.strerror or error}") from error


def _is_alive(pid: int) -> bool:
    try:
        os.kill(pid, 0)
    except (ProcessLookupError, OverflowError):
        return False
    except PermissionError:  # somebody else's process: alive
        return True
    return True
