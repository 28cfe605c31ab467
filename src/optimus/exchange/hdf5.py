"""Reading an HDF5 file that others made, without trust: plain arrays and text only.

HDF5 can point at other files (external links, external and virtual storage), name filters that are loaded as plug-ins, and hold
types that are read by running code elsewhere (pickled objects in opaque or variable-length data). None of these is followed.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from optimus.errors import DatasetError

PLAIN_KINDS = "biuf"
"""Booleans, integers and floating-point numbers, as numpy calls them."""
BUILT_IN = {h5py.h5z.FILTER_DEFLATE, h5py.h5z.FILTER_SHUFFLE, h5py.h5z.FILTER_FLETCHER32, h5py.h5z.FILTER_SZIP, h5py.h5z.FILTER_LZF}
"""Filters that need no plug-in."""


@contextmanager
def created(path: Path) -> Iterator[h5py.File]:
    """A new file, of a kind that may be read by several at once. `OSError` says why it cannot be written, also in closing it."""
    try:
        with h5py.File(path, "w", libver="v110") as file:
            yield file
    except (OSError, RuntimeError) as error:  # HDF5's own messages run over many lines, the reason in between
        number = re.search(r"errno = (\d+)", str(error))
        raise OSError(int(number[1]), os.strerror(int(number[1]))) if number else error from error


@contextmanager
def opened(path: Path) -> Iterator[h5py.File]:
    """The file, for reading; what is wrong with it, also further in, is a `DatasetError` with its name."""
    try:
        with h5py.File(path, "r") as file:
            yield file
    except FileNotFoundError as error:
        raise DatasetError(f"{path} does not exist") from error
    except (OSError, RuntimeError, KeyError) as error:
        raise DatasetError(f"{path} is not an HDF5 file, or is damaged ({error})") from error


def names_in(group: h5py.Group) -> list[str]:
    """The names of what is in a group, links to elsewhere not among them."""
    return [str(name) for name in group if isinstance(group.get(name, getlink=True), h5py.HardLink)]


def group_in(group: h5py.Group, name: str) -> h5py.Group:
    """A group within a group; `DatasetError` lists what there is."""
    found = group[name] if name in names_in(group) else None
    if not isinstance(found, h5py.Group):
        raise DatasetError(f"{_place(group)} has no group {name!r}; it has {', '.join(names_in(group)) or 'nothing'}")
    return found


def plain_dataset(group: h5py.Group, name: str) -> h5py.Dataset:
    """A dataset of numbers that lies in the file itself; its values are not read yet."""
    found = _dataset(group, name)
    if found.dtype.kind not in PLAIN_KINDS or found.ndim == 0:
        raise DatasetError(f"{_place(found)} holds {found.dtype} values of shape {found.shape}; only plain numbers are read")
    return found


def _dataset(group: h5py.Group, name: str) -> h5py.Dataset:
    found = group[name] if name in names_in(group) else None
    if not isinstance(found, h5py.Dataset):
        raise DatasetError(f"{_place(group)} has no array {name!r}; it has {', '.join(names_in(group)) or 'nothing'}")
    if found.external or found.is_virtual:
        raise DatasetError(f"{_place(found)} lies in another file; only what is in the file itself is read")
    pipeline = found.id.get_create_plist()
    filters = {pipeline.get_filter(i)[0] for i in range(pipeline.get_nfilters())}
    if filters - BUILT_IN:
        raise DatasetError(f"{_place(found)} is compressed by a plug-in (filter {min(filters - BUILT_IN)}); repack it with gzip")
    return found


def numbers(group: h5py.Group, name: str, steps: int | None = None) -> NDArray[Any]:
    """An array of finite numbers, with `steps` rows if that is given."""
    found = plain_dataset(group, name)
    if steps is not None and found.shape[0] != steps:
        raise DatasetError(f"{_place(found)} has {found.shape[0]} rows, the actions have {steps}")
    array = np.asarray(found[()])
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise DatasetError(f"{_place(found)} holds NaN or infinity")
    return array


def names(group: h5py.Group, name: str) -> list[str]:
    """An array of names, as fixed-length bytes or as text of any length."""
    found = _dataset(group, name)
    if h5py.check_string_dtype(found.dtype) is None:
        raise DatasetError(f"{_place(found)} holds {found.dtype} values, not names")
    return [v.decode() if isinstance(v, bytes) else str(v) for v in np.atleast_1d(found[()])]


def facts(thing: h5py.Group, name: str) -> dict[str, Any]:
    """The JSON object in an attribute; empty without one."""
    text = thing.attrs.get(name, "{}") if name not in thing.attrs or _is_text(thing, name) else None
    try:
        found = json.loads(text) if isinstance(text, str | bytes) else None
    except ValueError:
        found = None
    if not isinstance(found, dict):
        raise DatasetError(f"{_place(thing)}: its attribute {name} is not a JSON object")
    return found


def _is_text(thing: h5py.Group, name: str) -> bool:
    return h5py.check_string_dtype(thing.attrs.get_id(name).dtype) is not None


def _place(thing: h5py.Group | h5py.Dataset) -> str:
    return f"{thing.file.filename}: {thing.name}"
