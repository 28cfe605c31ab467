"""Files that are there whole or not at all: written aside in the same folder, then renamed over the target.

A killed process leaves at most a `<name>.tmp-<host>-<pid>` behind, which `remove_leftovers` clears once that process
is gone (of another machine, which may share the folder, once it is an hour old). Nothing is flushed to the platter
(`fsync` would cost more than the simulation of an episode): after
a power cut a file may be short, which readers find by its size.
"""

from __future__ import annotations

import glob
import json
import os
import platform
import re
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from optimus.errors import DatasetError, StorageError

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
        with suppress(StorageError):  # where nothing can be written, nothing can be removed either
            _discard(aside)
        raise StorageError(f"cannot write {path}: {error.strerror or error}; nothing was changed") from error
    except BaseException:
        _discard(aside)
        raise


def write_json(path: Path, value: Any) -> None:
    """Write a JSON-able value, whole or not at all."""
    write_whole(path, (json.dumps(value, indent=2) + "\n").encode())


def read_record(path: Path, keys: tuple[str, ...] = (), remedy: str = "remove it and do again what made it") -> dict[str, Any]:
    """What `write_json` wrote; `DatasetError`, with the `remedy`, where it cannot be read or lacks one of the `keys`."""
    try:
        found = dict(json.loads(path.read_text()))
    except (OSError, ValueError, TypeError) as error:
        raise DatasetError(f"cannot read {path} ({error}); {remedy}") from error
    if missing := [key for key in keys if key not in found]:
        raise DatasetError(f"{path} lacks {', '.join(missing)}: not of this program, or damaged; name another folder, or remove it")
    return found


def require_free(path: Path, overwrite: bool, marker: str = "") -> None:
    """`StorageError` if something is at `path` that must not be replaced: anything unless `overwrite`, and then still what is not
    of the same sort, a file or, with a `marker`, a folder that holds a file of that name."""
    if not path.exists():
        return
    if not overwrite:
        raise StorageError(f"{path} exists; name another, or allow it to be replaced with --overwrite")
    if not (path / marker).is_file():
        raise StorageError(f"{path} is not {f'a folder with {marker}' if marker else 'a file'} and is not replaced; name another")


@contextmanager
def written_aside(path: Path, overwrite: bool = False, marker: str = "") -> Iterator[Path]:
    """Where to write a file (with a `marker` a folder) that becomes `path` when the block ends well, and vanishes when it does not.

    For writers that need a path of their own. One folder cannot take another's place in one step: the old one is renamed to
    `<name>.replaced-<host>-<pid>` first, and stays there should the process be killed at that moment.
    """
    require_free(path, overwrite, marker)
    make_folder(path.parent)
    remove_leftovers(path.parent, path.name)
    made, old = (path.with_name(f"{path.name}.{end}-{_HOST}-{os.getpid()}") for end in ("tmp", "replaced"))
    try:
        yield made
        if path.is_dir():
            path.rename(old)
        made.replace(path)
        _discard(old)
    except OSError as error:
        if old.exists() and not path.exists():
            old.rename(path)
        raise StorageError(f"cannot write {path}: {error.strerror or error}; nothing was changed") from error
    finally:
        _discard(made)


def remove_leftovers(folder: Path, name: str = "*") -> list[str]:
    """Delete the temporary files in `folder` (of that name) whose process is gone; their names are returned."""
    removed = []
    for path in sorted(folder.glob(f"{name if name == '*' else glob.escape(name)}.tmp-*")):
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
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        else:
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
