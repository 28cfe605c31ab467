"""The command line: one verb a stage, folders in, folders out. The only place that parses arguments and catches errors."""

from __future__ import annotations

import logging
import os
import sys

import tyro

from optimus import __version__
from optimus.cli.datasets import dataset
from optimus.cli.demonstrations import collect, curate, imitability
from optimus.cli.exchange import export, import_
from optimus.cli.health import doctor
from optimus.cli.live import view
from optimus.cli.main_job import run
from optimus.cli.measurements import bench
from optimus.cli.objects import objects
from optimus.cli.output import QUIET
from optimus.cli.pages import report
from optimus.cli.policies import evaluate, export_policy
from optimus.cli.rendering import render
from optimus.cli.reproduction import reproduce
from optimus.cli.scenes import show, tasks
from optimus.cli.training import train
from optimus.errors import OptimusError, UnknownNameError

_SEEING = (tasks, objects, show, view)
_DATA = (collect, render, curate, imitability, dataset, export, import_)
_LEARNING = (train, evaluate, export_policy, run, report)
VERBS = {f.__name__.rstrip("_").replace("_", "-"): f for f in (*_SEEING, *_DATA, *_LEARNING, bench, reproduce, doctor)}

DESCRIPTION = """From a manipulation task to curated demonstrations and a trained policy: one verb a stage, folders in, folders out.

Every verb has a --help with examples; --quiet goes with every one and leaves out the progress bars.
--version says which this is."""


def main() -> None:
    """The `optimus` command. Exit status: 0; 1 when `doctor` finds something broken; 2 for an error that the user can mend;
    130 when interrupted; 141 when what reads the output, as `head` does, has seen enough."""
    try:
        try:
            _main()
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # else Python tries once more as it ends, and complains
        raise SystemExit(141) from None


def _main() -> None:
    logging.basicConfig(level=logging.WARNING, format="%(levelname)s %(name)s: %(message)s")
    if sys.argv[1:] == ["--version"]:
        sys.stdout.write(f"optimus {__version__}\n")
        return
    try:
        if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and sys.argv[1] not in VERBS:
            raise UnknownNameError("verb", sys.argv[1], VERBS)
        if "--quiet" in sys.argv:
            sys.argv.remove("--quiet")
            os.environ[QUIET] = "1"
        tyro.extras.subcommand_cli_from_dict(VERBS, prog="optimus", description=DESCRIPTION)
    except OptimusError as error:
        sys.stderr.write(f"optimus: {error}\n")
        raise SystemExit(2) from None
    except RuntimeError as error:
        if "MUJOCO_GL" not in str(error):  # MuJoCo's own word for a GL library that there is not, as it is imported
            raise
        sys.stderr.write(f"optimus: {error}; `optimus doctor` says what to do\n")
        raise SystemExit(2) from None
    except KeyboardInterrupt:
        sys.stderr.write("optimus: interrupted; the same command goes on from here\n")
        raise SystemExit(130) from None
