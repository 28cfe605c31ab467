"""The pictures of one camera in an episode's file, read where they lie.

No file stays open and none is mapped: a dataset may have more episodes than a process may have files. Nothing is decoded, and the
operating system's page cache is the only cache.
"""

from __future__ import annotations

import os
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.data.episode_file import ArraySlot
from optimus.errors import DatasetError


class _Scratch(threading.local):
    """A buffer for each thread: memory that is new each time costs more than what is read into it."""

    def __init__(self) -> None:
        self.bytes = np.empty(0, np.uint8)

    def of(self, size: int) -> NDArray[np.uint8]:
        if len(self.bytes) < size:
            self.bytes = np.empty(size, np.uint8)
        return self.bytes[:size]


_scratch = _Scratch()


@dataclass(frozen=True)
class Frames:
    """`(T, h, w, 3)` uint8 in the file `path`."""

    path: Path
    slot: ArraySlot

    @property
    def shape(self) -> tuple[int, ...]:
        return self.slot.shape

    @property
    def nbytes(self) -> int:
        return int(np.prod(self.shape))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        """All frames, as numpy takes them."""
        out = np.empty(self.shape, np.uint8)
        self.crop(out, 0, np.zeros(2, np.int64))
        return out if dtype is None else out.astype(dtype, copy=False)

    def crop(self, out: NDArray[np.uint8], first: int, corner: NDArray[np.integer[Any]]) -> None:
        """Fill `out` `(n, a, b, 3)` with frames from `first` on, cut out at `corner` `(2,)`: the first row and column."""
        count, height, width = out.shape[:3]
        frame = int(np.prod(self.shape[1:]))
        whole = _scratch.of(count * frame)
        try:
            file = os.open(self.path, os.O_RDONLY)
            try:
                read = os.preadv(file, [whole.data], self.slot.offset + first * frame)
            finally:
                os.close(file)
        except OSError as error:
            raise DatasetError(f"cannot read {self.path}: {error.strerror or error}") from error
        if read != len(whole):
            raise DatasetError(f"{self.path} is cut short at frame {first}; delete it and collect again to replace it")
        top, left = (int(i) for i in corner)
        out[:] = whole.reshape(count, *self.shape[1:])[:, top : top + height, left : left + width]
