"""`view`: scenes, plans, episodes and policies, live in a browser."""

from __future__ import annotations

import sys
import threading
from typing import Annotated

from tyro.conf import Positional, arg

from optimus.cli.options import Json, RobotName, chosen_robot
from optimus.cli.output import say
from optimus.errors import OptimusError

What = Annotated[str, Positional, arg(metavar="TASK|DATASET|RUN", help="a task's name, or a folder of `collect`, `train` or `run`")]


def view(
    what: What,
    seed: int | None = None,
    port: int = 8080,
    host: str = "127.0.0.1",
    robot: RobotName = None,
    json: Json = False,
) -> None:
    """Look into a task, a dataset or a policy in the browser; it is served until this command is interrupted (Ctrl-C).

    Of a task: a problem, its plan with a time slider or why there is none, the grasps of an object. Of a dataset: an episode with
    its pictures and actions. Of a run: the policy at work. Needs the extra `view`: pip install 'optimus-tamp[view]'

    Try:
        optimus view stack --seed 3
        optimus view data/stack
        optimus view runs/stack --port 9000
        optimus view pretrained:pick-place

    Args:
        seed: which problem, or which episode of a dataset; by default the first
        port: of the page; 0 takes any that is free
        host: the address to serve at; the default lets in this machine alone, 0.0.0.0 everybody
    """
    sys.stderr.write("optimus: getting it ready to be seen; the address follows\n")
    try:
        from optimus.pretrained import run_folder
        from optimus.view import Address, open_view
    except ModuleNotFoundError as error:
        if error.name != "viser":
            raise
        raise OptimusError("the viewer needs the package viser: pip install 'optimus-tamp[view]'") from error
    shown = open_view(str(run_folder(what)), seed, Address(host, port), chosen_robot(robot))
    say({"url": shown.url}, json, f"{shown.url}  (Ctrl-C ends it)")
    try:
        threading.Event().wait()
    finally:
        shown.close()
