"""Fills a table cell by cell: what is done is not done again, and the table is written after every cell.

Where a GPU trains, the cores are not idle meanwhile: they collect what later cells need, and try the policies of earlier ones.
"""

from __future__ import annotations

import copy
import json
import os
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from optimus.data.atomic import make_folder, read_record, write_json
from optimus.errors import UnknownNameError
from optimus.learn.ranks import device_kind
from optimus.reproduce.site import Site, commit
from optimus.reproduce.tables import TABLES, Cell, Table
from optimus.reproduce.work import PolicyWork
from optimus.reproduce.write import write_table
from optimus.words import slug
from optimus.workers import available_cores


def table_named(name: str) -> Table:
    """The table of that name; `UnknownNameError` lists the others."""
    if name not in TABLES:
        raise UnknownNameError("table", name, TABLES)
    return TABLES[name]


def reproduce(site: Site, rows: Sequence[str] = (), columns: Sequence[str] = ()) -> dict[str, Any]:
    """Fill the table of `site`, or only some of its rows or columns, from wherever an earlier call was stopped. Returns what
    `OUT/results.json` then says: all that is there, of others too. `UnknownNameError` if a row or column is none of the table's."""
    table = table_named(site.table)
    for kind, asked, valid in (("row", rows, table.rows), ("column", columns, table.columns)):
        for name in asked:
            if name not in valid:
                raise UnknownNameError(kind, name, valid)
    device_kind(site.budget.device)  # one that is not there is said before anything is written
    site.open()
    make_folder(site.out / "cells")
    chosen = [c for c in table.cells if (not rows or c.row in rows) and (not columns or c.column in columns)]
    with _ahead(site, [cell for cell in chosen if not _file(site, cell).exists()]) as prepared:
        for i, cell in enumerate(chosen):
            site.progress("cells", i, len(chosen), {"next": cell.name})
            if cell.name in prepared:
                prepared[cell.name].result()
            _filled(site, table, cell)
            _write(site, table, [_filled(site, table, c) for c in table.cells if _file(site, c).exists()])
    site.progress("cells", len(chosen), len(chosen), {})
    return json.loads((site.out / "results.json").read_text())


_NICENESS = 10
"""Of the processes that collect ahead: what feeds the GPU, and above all its compiler, must not wait for them."""


def _give_way() -> None:
    """Lower the priority of this thread, and of the processes that it starts: on Linux it has one of its own."""
    if sys.platform == "linux":
        own = threading.get_native_id()
        os.setpriority(os.PRIO_PROCESS, own, max(_NICENESS, os.getpriority(os.PRIO_PROCESS, own)))


class _StoppedError(Exception):
    """Ends work ahead that nobody waits for any more."""


@contextmanager
def _ahead(site: Site, cells: Sequence[Cell]) -> Iterator[dict[str, Future[None]]]:
    """Cell -> when it is prepared, in the background, one after the other; nothing where no GPU trains, or where there is but one
    worker: that is this process itself, whose GL contexts belong to one thread."""
    taught = any(isinstance(cell.work, PolicyWork) for cell in cells)
    if not taught or device_kind(site.budget.device) != "cuda" or (site.workers or available_cores()) == 1:
        yield {}
        return
    over = threading.Event()

    def progress(stage: str, done: int, total: int, notes: dict[str, str]) -> None:
        if over.is_set():
            raise _StoppedError
        site.progress(stage, done, total, notes)

    def trained(collected: Future[object], train: Callable[[], object]) -> None:
        collected.result()
        train()

    with ThreadPoolExecutor(1, initializer=_give_way) as cores, ThreadPoolExecutor(1) as gpu:
        prepared: dict[str, Future[None]] = {}
        for cell in cells:
            collect, train = cell.work.ahead(replace(site, progress=progress, cell=cell.name))
            prepared[cell.name] = gpu.submit(trained, cores.submit(collect), train)
        try:
            yield prepared
        finally:
            over.set()
            for pool in (cores, gpu):
                pool.shutdown(wait=False, cancel_futures=True)


def _file(site: Site, cell: Cell) -> Path:
    """Where a cell's measurements are put."""
    return site.out / "cells" / f"{slug(cell.name)}.json"


def _filled(site: Site, table: Table, cell: Cell) -> dict[str, Any]:
    """The cell, with its measurements."""
    path = _file(site, cell)
    if path.exists():
        return read_record(path)
    of, own = commit(), replace(site, cell=cell.name)
    measured = cell.work.do(own)
    result = {
        "row": cell.row,
        "column": cell.column,
        "paper": table.papers.get(cell.row, {}).get(cell.column),
        "measured": measured,
        "commands": cell.work.commands(site),
        "hours": own.hours,
        "commit": of,
        "machine": cell.work.machine(site),
    }
    write_json(path, result)
    return result


def _write(site: Site, table: Table, results: list[dict[str, Any]]) -> None:
    with site.lock:
        record = copy.deepcopy(site.record)
    begun = replace(site.budget, device=record["asked"]["budget"]["device"])
    found = {
        "table": table.name,
        "title": table.title,
        "command": f"optimus reproduce {table.name} --budget {site.budget.name} --seed {site.seed}{begun.options} --out DIR",
        **record,
        "hours": site.hours,
        "complete": len(results) == len(table.cells),
        "missing": [cell.name for cell in table.cells if not _file(site, cell).exists()],
        "cells": results,
    }
    write_json(site.out / "results.json", found)
    write_table(site.out, found)
