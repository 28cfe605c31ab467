"""Where a run's figures can be watched: TensorBoard event files in `RUN/tensorboard`, or Weights & Biases."""

from __future__ import annotations

import hashlib
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Literal, Protocol, get_args

from tensorboardX import SummaryWriter

from optimus.errors import OptimusError

BOARD_FOLDER = "tensorboard"
BoardName = Literal["tensorboard", "wandb", "none"]


class BoardError(OptimusError):
    """A place for figures that is not installed."""


class Board(Protocol):
    """Takes a run's figures as they come."""

    def add(self, metrics: dict[str, float]) -> None:
        """The figures of the step `metrics["step"]`."""
        ...

    def close(self) -> None:
        """Write what is still to be written."""
        ...


class _Nowhere:
    def add(self, metrics: dict[str, float]) -> None: ...

    def close(self) -> None: ...


class _TensorBoard:
    def __init__(self, run: Path, step: int) -> None:
        # a reader forgets what an earlier session, killed later on, had reported of the steps that are taken again
        # the suffix: files are named by the second, and one of the same second would be written over
        self._writer = SummaryWriter(str(run / BOARD_FOLDER), purge_step=step + 1, filename_suffix=f".{step:09d}")

    def add(self, metrics: dict[str, float]) -> None:
        for name, value in metrics.items():
            if name not in ("step", "steps"):
                self._writer.add_scalar(_tag(name), value, int(metrics["step"]))
        self._writer.flush()

    def close(self) -> None:
        self._writer.close()


class _Wandb:
    def __init__(self, run: Path) -> None:
        wandb: Any = import_module("wandb")  # optional, heavy, and none of this program's dependencies
        name = hashlib.sha256(str(run.resolve()).encode()).hexdigest()[:16]
        self._run = wandb.init(project="optimus", name=run.name, id=name, resume="allow", dir=str(run))

    def add(self, metrics: dict[str, float]) -> None:
        self._run.log({_tag(name): value for name, value in metrics.items()}, step=int(metrics["step"]))

    def close(self) -> None:
        self._run.finish()


def _tag(name: str) -> str:
    """`held_out_likelihood` -> `held_out/likelihood`, the rest under `train/`."""
    return f"held_out/{name.removeprefix('held_out_')}" if name.startswith("held_out_") else f"train/{name}"


def require_board(name: str) -> None:
    """`BoardError` if there is no such board here."""
    if name not in get_args(BoardName):
        raise BoardError(f"unknown board {name!r}; valid: {', '.join(get_args(BoardName))}")
    if name == "wandb" and find_spec("wandb") is None:
        raise BoardError("wandb is not installed; pip install wandb, or use --board tensorboard")


def board(name: BoardName, run: Path, step: int) -> Board:
    """The board of that name for a run that goes on after `step` steps."""
    if name == "tensorboard":
        return _TensorBoard(run, step)
    if name == "wandb":
        return _Wandb(run)
    return _Nowhere()
