"""A fingerprint of plain data, so that a dataset can tell that what its task draws has been edited since."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from optimus.robots.robot import Mount, Robot


def fingerprint(value: Any) -> str:
    """Sixteen hexadecimal digits that are others for another value: dataclasses by their fields, mappings and sets in any order,
    numbers to nine digits, as processors differ beyond. Of a robot's model counts what its file says, not where it lies."""
    digest = hashlib.sha256()
    for piece in _pieces(value):
        digest.update(len(piece).to_bytes(8) + piece)
    return digest.hexdigest()[:16]


def _pieces(value: Any) -> Iterator[bytes]:
    if isinstance(value, Robot):
        value = replace(value, source=_content(value.source))
    elif isinstance(value, Mount):
        value = replace(value, model=_content(value.model))
    if is_dataclass(value):
        yield type(value).__name__.encode()
        for field in fields(value):
            yield field.name.encode()
            yield from _pieces(getattr(value, field.name))
    elif isinstance(value, np.ndarray):
        yield str(value.shape).encode()
        yield (np.round(value, 9) + 0.0 if value.dtype.kind == "f" else value).tobytes()  # no zero below zero
    elif isinstance(value, (Mapping, tuple, list, frozenset, set)):
        yield f"{len(value)} in".encode()
        in_order = value.items() if isinstance(value, Mapping) else value
        for item in in_order if isinstance(value, (tuple, list)) else sorted(in_order):
            yield from _pieces(item)
    else:
        yield (f"{round(value, 9) + 0.0:.9g}" if isinstance(value, float) else str(value)).encode()


def _content(source: str) -> str:
    """What is in the file and in those that it includes; the name, where it is that of a model that is fetched, whose hash is
    pinned."""
    path = Path(source)
    if not path.is_file():
        return source
    digest = hashlib.sha256()
    for file in _with_included(path, path.parent, set()):
        digest.update(file.read_bytes())
    return digest.hexdigest()


def _with_included(file: Path, beside: Path, seen: set[Path]) -> Iterator[Path]:
    """An MJCF file, and those it includes, which lie beside the first."""
    if file.resolve() in seen or not file.is_file():
        return
    seen.add(file.resolve())
    yield file
    for name in re.findall(rb"<include\s+file\s*=\s*[\"']([^\"']+)[\"']", file.read_bytes()):
        yield from _with_included(beside / name.decode(), beside, seen)
