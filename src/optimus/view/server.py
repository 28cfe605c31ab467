"""What there is to look at, and the server that shows it."""

from __future__ import annotations

import io
import socket
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import dataclass
from pathlib import Path

import viser

from optimus.data.store import EpisodeStore
from optimus.errors import OptimusError, UnknownNameError, require_at_least
from optimus.learn.checkpoint import CONFIG_FILE
from optimus.robots import Robot
from optimus.tasks import TASKS
from optimus.tasks import task as task_named
from optimus.view.episode_view import EpisodeView
from optimus.view.policy_view import PolicyView
from optimus.view.scene_view import SceneView


@dataclass(frozen=True)
class Address:
    """Where the page is served. The default lets nobody in from other machines; port 0 takes any that is free."""

    host: str = "127.0.0.1"
    port: int = 8080


class View:
    """A page that is being served: `url`, and the view on it. Close it when done."""

    def __init__(self, server: viser.ViserServer, address: Address, shown: SceneView | EpisodeView | PolicyView) -> None:
        self._server, self.shown = server, shown
        self.url = f"http://{address.host}:{server.get_port()}"

    def close(self) -> None:
        """Stop what plays, and the server."""
        self.shown.close()
        self._server.stop()


Shower = Callable[[viser.ViserServer], SceneView | EpisodeView | PolicyView]


def open_view(target: str, seed: int | None = None, address: Address | None = None, robot: Robot | None = None) -> View:
    """Serve a view of a task's name, a dataset's folder, or the folder of a policy or of the main job.

    `seed` says which problem, or which episode; None: the first. `UnknownNameError` if it is none of these, `OptimusError` if the
    port is taken."""
    address = address or Address()
    require_at_least(0, seed=seed, port=address.port)
    show = _shower(target, seed, robot)
    _require_free(address)
    with redirect_stdout(io.StringIO()):  # its banner; what is said on standard output is for the command line to say
        server = viser.ViserServer(host=address.host, port=address.port, label=f"optimus: {Path(target).name}", verbose=False)
    server.gui.configure_theme(show_logo=False, show_share_button=False, control_width="medium")
    try:
        return View(server, address, show(server))
    except BaseException:
        server.stop()
        raise


def _shower(target: str, seed: int | None, robot: Robot | None) -> Shower:
    """What shows `target`; errors about it are raised here, before there is a server."""
    folder = Path(target)
    if folder.is_dir():
        if (folder / "dataset.json").exists():
            store = EpisodeStore.open(folder)
            return lambda server: EpisodeView(server, store, seed, robot)
        for run in (folder, folder / "policy"):
            if (run / CONFIG_FILE).exists():
                return lambda server, run=run: PolicyView(server, run, seed or 0, robot)
        raise OptimusError(f"{folder} holds neither a dataset (dataset.json) nor a policy ({CONFIG_FILE}, or policy/{CONFIG_FILE})")
    try:
        task = task_named(target)
    except UnknownNameError:
        raise UnknownNameError("task, dataset or run", target, TASKS) from None
    return lambda server: SceneView(server, task, seed or 0, robot)


def _require_free(address: Address) -> None:
    """viser would take another port without a word."""
    try:
        with socket.create_server((address.host, address.port)):
            pass
    except (OSError, OverflowError) as error:
        why = getattr(error, "strerror", None) or error
        raise OptimusError(f"cannot serve at {address.host}:{address.port}: {why}; choose another --port") from error
