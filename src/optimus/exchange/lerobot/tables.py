"""The Parquet tables of a LeRobotDataset: frames, episodes and instructions."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray

from optimus.data.atomic import make_folder

CHUNKS = 1000
"""Files in a chunk's folder at most."""
DATA_BYTES = 100 * 2**20
"""A file of frames that is as large as this [bytes] is followed by another: LeRobot's own limit."""
EPISODES_A_FILE = 2000
DATA_PATH = "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
EPISODES_PATH = "meta/episodes/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet"
TASKS_PATH = "meta/tasks.parquet"
IMAGE = pa.struct([("bytes", pa.binary()), ("path", pa.string())])
"""An image within a table, as the library `datasets` has it."""


def place(number: int) -> dict[str, int]:
    """Chunk and file of the files that are counted `number` from 0 on."""
    return {"chunk_index": number // CHUNKS, "file_index": number % CHUNKS}


class FrameTable:
    """The frames, in as many files as they need; `close` when done."""

    def __init__(self, root: Path) -> None:
        self.root, self.number = root, 0
        self._writer: pq.ParquetWriter | None = None

    def add(self, columns: Mapping[str, NDArray[Any]], images: Mapping[str, Sequence[bytes]]) -> int:
        """Append an episode: arrays `(T,)` or `(T, n)`, and PNG files where images are in the table. The number of its file."""
        arrays = {name: _column(values) for name, values in columns.items()}
        for name, files in images.items():
            arrays[name] = pa.array([{"bytes": content, "path": None} for content in files], IMAGE)
        table = pa.table(arrays)
        path = self.root / DATA_PATH.format(**place(self.number))
        if self._writer is not None and path.stat().st_size >= DATA_BYTES:
            self.close()
            self.number += 1
            path = self.root / DATA_PATH.format(**place(self.number))
        if self._writer is None:
            make_folder(path.parent)
            self._writer = pq.ParquetWriter(path, table.schema)
        self._writer.write_table(table)
        return self.number

    def close(self) -> None:
        """End the file that is being written."""
        writer, self._writer = self._writer, None
        if writer is not None:
            writer.close()


def _column(values: NDArray[Any]) -> pa.Array:
    if values.ndim == 1:
        return pa.array(values)
    return pa.FixedSizeListArray.from_arrays(pa.array(np.ascontiguousarray(values).ravel()), values.shape[1])


def write_episodes(root: Path, rows: Sequence[Mapping[str, Any]]) -> None:
    """A row an episode."""
    for number, first in enumerate(range(0, len(rows), EPISODES_A_FILE)):
        where = place(number)
        said = {f"meta/episodes/{key}": value for key, value in where.items()}
        path = root / EPISODES_PATH.format(**where)
        make_folder(path.parent)
        pq.write_table(pa.Table.from_pylist([{**row, **said} for row in rows[first : first + EPISODES_A_FILE]]), path)


def write_tasks(root: Path, tasks: Sequence[str]) -> None:
    """The instructions and their numbers; readers that use pandas find the text as the index."""
    numbers = {"name": "task_index", "field_name": "task_index", "pandas_type": "int64", "numpy_type": "int64", "metadata": None}
    texts = {"name": "task", "field_name": "task", "pandas_type": "unicode", "numpy_type": "object", "metadata": None}
    about = {"index_columns": ["task"], "column_indexes": [], "columns": [numbers, texts], "pandas_version": "2.0.0"}
    table = pa.table({"task_index": pa.array(range(len(tasks)), pa.int64()), "task": pa.array(tasks, pa.string())})
    pq.write_table(table.replace_schema_metadata({"pandas": json.dumps(about)}), root / TASKS_PATH)
