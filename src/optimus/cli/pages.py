"""`report`: one run, or several beside one another, as a page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from tyro.conf import Positional, arg

from optimus.cli.options import Json
from optimus.cli.output import say
from optimus.errors import OptimusError

Runs = Annotated[tuple[Path, ...], Positional, arg(metavar="RUN", help="folders of `optimus run` or `optimus train`")]


def report(runs: Runs, out: Path = Path("report.html"), json: Json = False) -> None:
    """Write a run as one HTML page that needs nothing beside itself; of several runs, a page that compares them.

    Try:
        optimus report runs/stack --out stack.html
        optimus report runs/stack runs/stack-ik runs/stack-joint --out control.html

    Args:
        out: the page to write
    """
    from optimus.pretrained import run_folder
    from optimus.report import write_comparison, write_report
    from optimus.summary import summary_of

    if not runs:
        raise OptimusError("name at least one RUN, a folder of `optimus run` or `optimus train`")
    found = {str(run): summary_of(run_folder(run)) for run in runs}
    if len(found) == 1:
        write_report(next(iter(found.values())), out)
    else:
        write_comparison(found, f"optimus report {' '.join(found)} --out {out}", out)
    say({"report": str(out), "runs": list(found)}, json, str(out))
