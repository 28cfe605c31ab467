"""`metrics.jsonl`: what a training run reports, one JSON object a line."""

from __future__ import annotations

import json
from pathlib import Path

from optimus.data.atomic import write_whole
from optimus.errors import CheckpointError, StorageError

METRICS_FILE = "metrics.jsonl"


def append(run: Path, metrics: dict[str, float]) -> None:
    """Add a line."""
    file = run / METRICS_FILE
    try:
        with file.open("a") as out:
            out.write(json.dumps(metrics) + "\n")
    except OSError as error:
        raise StorageError(f"cannot write {file}: {error.strerror or error}") from error


def read(run: Path) -> list[dict[str, float]]:
    """All lines; a last one that was cut off by a kill is left out."""
    file = run / METRICS_FILE
    if not file.exists():
        return []
    lines = file.read_text().split("\n")[:-1]
    try:
        return [json.loads(line) for line in lines]
    except ValueError as error:
        raise CheckpointError(f"{file} is damaged ({error}); delete it") from error


def forget_after(run: Path, step: int) -> None:
    """Drop the lines of steps that will be taken again."""
    if (run / METRICS_FILE).exists():
        kept = [json.dumps(line) + "\n" for line in read(run) if line["step"] <= step]
        write_whole(run / METRICS_FILE, "".join(kept).encode())


def lowest(run: Path, name: str) -> dict[str, float] | None:
    """The line with the lowest value of that name, the first of them; None if no line has one."""
    measured = [line for line in read(run) if name in line]
    return min(measured, key=lambda line: line[name], default=None)
