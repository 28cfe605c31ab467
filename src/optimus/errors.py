"""Named errors. Every one is a child of `OptimusError`, which the command line prints as one line (exit status 2)."""

import math
import shlex
from collections.abc import Iterable


class OptimusError(Exception):
    """The root of every error that a user can cause and mend."""


def require_at_least(least: float, **numbers: float | None) -> None:
    """`OptimusError` that names the first of the numbers which is less, or none at all; what is None was not asked for."""
    for name, number in numbers.items():
        if number is not None and not number >= least:
            raise OptimusError(f"{name.replace('_', ' ')}: {number} is not {least} or more")


def require_finite(**numbers: float | None) -> None:
    """`OptimusError` that names the first of the numbers which has no end; what is None was not asked for."""
    for name, number in numbers.items():
        if number is not None and not math.isfinite(number):
            raise OptimusError(f"{name.replace('_', ' ')}: {number} is no number to count to")


def require_positive(**numbers: float | None) -> None:
    """`OptimusError` that names the first of the numbers which is not above zero, or has no end; what is None was not asked for."""
    for name, number in numbers.items():
        if number is not None and not 0 < number < math.inf:
            raise OptimusError(f"{name.replace('_', ' ')}: {number} is not a number above 0")


def require_below_one(**shares: float) -> None:
    """`OptimusError` that names the first of the shares which is not at least 0 and less than 1."""
    for name, share in shares.items():
        if not 0 <= share < 1:
            raise OptimusError(f"{name.replace('_', ' ')}: {share} is not 0 or more and less than 1")


class UnknownNameError(OptimusError):
    """A name that is not one of the known ones; the message lists them."""

    def __init__(self, kind: str, name: str, valid: Iterable[str]) -> None:
        # the arguments as they came, so that the error survives the way back from a worker process
        super().__init__(kind, name, tuple(sorted(valid)))

    def __str__(self) -> str:
        kind, name, valid = self.args
        told = (shlex.quote(each) if {" ", ","} & set(each) else each for each in valid)
        return f"unknown {kind} {name!r}; valid: {', '.join(told)}"


class AssetError(OptimusError):
    """A model or mesh that could not be fetched, verified or read."""


class DatasetError(OptimusError):
    """A dataset folder or file that is foreign, damaged, or does not fit what is asked of it."""


class CheckpointError(OptimusError):
    """A checkpoint that is foreign, damaged, or was trained for something else."""


class StorageError(OptimusError):
    """A folder that cannot be written, or a full disk."""


class ModelError(OptimusError):
    """A scene that does not compile, or a task whose start cannot be sampled."""


class ActionError(OptimusError):
    """Something given to an environment as an action that is none."""


class RobotFileError(OptimusError):
    """A robot file, or the model it names, that is missing, does not fit together or cannot be read."""


class WorkerError(OptimusError):
    """Worker processes that keep being killed, or a cluster that cannot be reached."""
