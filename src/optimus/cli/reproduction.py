"""`reproduce`: the paper's tables and figures."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

from tyro.conf import Positional, arg

from optimus.cli.options import Json, Workers
from optimus.cli.output import StageBars, say

TableName = Annotated[
    str,
    Positional,
    arg(metavar="NAME", help="table-b1, table-b2, table-b3, figure-a1, long-horizon, multitask or four-tasks"),
]


def reproduce(
    name: TableName,
    out: Path,
    rows: tuple[str, ...] = (),
    columns: tuple[str, ...] = (),
    budget: Literal["smoke", "cpu", "gpu"] = "smoke",
    seed: int = 0,
    seeds: int | None = None,
    device: Literal["auto", "cpu", "cuda"] | None = None,
    workers: Workers = 0,
    json: Json = False,
) -> None:
    """Reproduce a table or figure of the paper: collect, train, try and write, the paper's figures beside ours. A second call goes
    on where the first was stopped.

    Try:
        optimus reproduce table-b3 --out results/b3 --budget cpu
        optimus reproduce figure-a1 --out results/a1 --budget smoke
        optimus reproduce table-b2 --out results/b2 --budget cpu --rows PickPlace Stack
        optimus reproduce table-b2 --out results/b2 --budget cpu --columns TAMP-joint TAMP-task

    Args:
        out: the folder for everything; `table.md`, `table.csv`, `plot.png` and `results.json` in it are the answer
        rows: only these, named as the table names them; a later call may fill others
        columns: only these, likewise
        budget: smoke proves the path in minutes and says nothing of success; cpu is for two cores overnight; gpu for one large GPU
        seed: of the first demonstration, of the split, and of the first policy
        seeds: policies trained for each row, from one seed after another, in place of the budget's
        device: what to train on, in place of the budget's
    """
    from optimus.reproduce import Site
    from optimus.reproduce import budget as budget_named
    from optimus.reproduce import reproduce as run_all

    chosen = budget_named(budget)
    chosen = replace(chosen, seeds=chosen.seeds if seeds is None else seeds, device=device or chosen.device)
    bars = StageBars(several=True)
    found = run_all(Site(name, out, chosen, seed, workers, bars), rows, columns)
    bars.close()
    say(found, json, (out / "table.md").read_text())
