"""The `optimus` command as its users call it, but in this process: what it writes, and its exit status.

A process of its own takes seconds to import everything. What depends on one (signals, pipes, environments) is tested with one.
"""

from __future__ import annotations

import contextlib
import io
import json
import sys
import traceback
from dataclasses import dataclass
from typing import Any
from unittest import mock

from optimus.cli import main


@dataclass(frozen=True)
class Done:
    """A call that has ended."""

    returncode: int
    stdout: str
    stderr: str


def optimus(*args: str) -> Done:
    """Call the program."""
    # what an encoding is asked of, as a terminal is: frames are drawn in ASCII otherwise
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8") for _ in range(2))
    status = 0
    with mock.patch.object(sys, "argv", ["optimus", *args]), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            main()
        except SystemExit as end:
            status = end.code if isinstance(end.code, int) else int(end.code is not None)
        except Exception:  # noqa: BLE001 - as Python itself would show it
            traceback.print_exc()
            status = 1
    return Done(status, _written(out), _written(err))


def _written(stream: io.TextIOWrapper) -> str:
    stream.flush()
    return stream.buffer.getvalue().decode()  # pyright: ignore[reportAttributeAccessIssue] - of a BytesIO


def result_of(*args: str) -> dict[str, Any]:
    """What the program says in JSON, last on standard output."""
    done = optimus(*args, "--json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.strip().splitlines()[-1])


def refused(*args: str) -> str:
    """The one line with which the program refuses."""
    done = optimus(*args)
    assert done.returncode == 2, (done.returncode, done.stderr)
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith("optimus: ") and "Traceback" not in done.stderr
    return last
