"""An episode of a dataset in the browser: the scene, what the policy's cameras saw, and the actions, in step."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING

import mujoco
import numpy as np
from numpy.typing import NDArray
from viser import uplot

from optimus.control import CONTROL_HZ
from optimus.data.episode import BINARY, Episode
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError
from optimus.robots.catalogue import known_robots
from optimus.robots.catalogue import robot as robot_named
from optimus.se3 import Array
from optimus.tasks import task as task_named
from optimus.view import words
from optimus.view.pictures import blank, side_by_side
from optimus.view.player import Player
from optimus.view.stage import Stage

if TYPE_CHECKING:
    import viser

    from optimus.data.store import EpisodeStore
    from optimus.robots import Robot

COLOURS = ("#2f6fb0", "#d9822b", "#2e8b57", "#8c5aaa", "#c2453a", "#8a8a2b", "#00848c")
GRIPPER_COLOUR = "#777777"


class EpisodeView:
    """One episode of a dataset at a time."""

    def __init__(self, server: viser.ViserServer, store: EpisodeStore, seed: int | None = None, robot: Robot | None = None) -> None:
        if not store.seeds:
            raise DatasetError(f"{store.path} holds no episode yet; collect some")
        if robot is None and store.robot in known_robots():
            robot = robot_named(store.robot)
        self._lock = threading.RLock()  # what the browser asks for comes on many threads
        self._store, self._server, self._task = store, server, task_named(store.task)
        gripper = store.config.get("gripper", BINARY)
        self._env = ManipulationEnv(self._task, images=False, control=store.control, robot=robot, gripper=gripper)
        self.player = Player(server, self._show)
        gui = server.gui
        seeds = tuple(map(str, store.seeds))
        first = seeds[0] if seed is None else str(store.header(seed).seed)  # which says what there is instead
        self._chosen = gui.add_dropdown("episode", seeds, initial_value=first, hint="by its seed")
        self._facts = gui.add_html("")
        self._picture = gui.add_image(blank(store.cameras), label=" | ".join(store.cameras)) if store.cameras else None
        self._chart: viser.GuiUplotHandle | None = None
        self._chosen.on_update(lambda _: self.load(int(self._chosen.value)))
        self.load(int(self._chosen.value))

    def load(self, seed: int) -> None:
        """Show the episode of that seed, from its start."""
        with self._lock:
            self.player.pause()
            self._load(seed)

    def _load(self, seed: int) -> None:
        self.episode = self._store.read(seed)
        self.qpos, error = _recorded(self._env, self.episode) or _played_again(self._env, self.episode)
        self.stage = Stage(self._server, self._env.world, self._task)
        self._facts.content = words.facts(
            {
                "task": self.episode.task,
                "steps": f"{len(self.episode)}, {len(self.episode) / CONTROL_HZ:.1f} s",
                "plan": ", ".join(self.episode.skeleton) or "none",
                "variant": str(self.episode.info.get("variant", "")) or "none",
                "objects off the record, at most": f"{1e3 * error:.1f} mm",
            }
        )
        self.player.load(len(self.episode), CONTROL_HZ)
        self._plot(0)
        self._show(0)

    @property
    def picture(self) -> NDArray[np.uint8] | None:
        """What the cameras saw, as it is shown; None where there were none."""
        return None if self._picture is None else self._picture.image

    def close(self) -> None:
        """End what plays."""
        self.player.close()

    def _show(self, index: int) -> None:
        """The scene, pictures and actions of that step; of the last one, where the slider stood further on in another episode."""
        with self._lock:
            index = min(index, len(self.episode) - 1)
            self.stage.show(self.qpos[index])
            with self._server.atomic():
                if self._picture is not None:
                    seen = {name: values[index] for name, values in self.episode.observations.items()}
                    self._picture.image = side_by_side(seen, self.episode.cameras)
                self._plot(index)

    def _plot(self, index: int) -> None:
        """The labels up to the present step as lines, the gripper grey; the rest of the episode is empty."""
        seconds = np.arange(len(self.episode)) / CONTROL_HZ
        actions = self.episode.actions.astype(np.float64).copy()
        actions[index + 1 :] = np.nan
        data = (seconds, *actions.T)
        if self._chart is not None and len(self._chart.data) == len(data):
            self._chart.data = data
            return
        size = actions.shape[1]
        names = [*(f"a{i}" for i in range(size - 1)), "gripper"]
        paint = [*(COLOURS[i % len(COLOURS)] for i in range(size - 1)), GRIPPER_COLOUR]
        series = [uplot.Series(label="s"), *(uplot.Series(label=n, stroke=c, width=1.5) for n, c in zip(names, paint, strict=True))]
        scales = {"x": uplot.Scale(time=False), "y": uplot.Scale(range=(-1.1, 1.1))}
        self._chart = self._server.gui.add_uplot(data, tuple(series), scales=scales, title="actions", aspect=1.6)


def _recorded(env: ManipulationEnv, episode: Episode) -> tuple[Array, float] | None:
    """Positions `(T, nq)` before each action as the episode has them, whatever happened besides what was executed, and how far
    any object is from where it is said to be [m]; None where it did not record them, or in another version's scene."""
    env.reset(seed=episode.seed)
    model, data = env.world.model, env.data
    if episode.states is None or episode.states.shape[1] != 1 + model.nq + model.nv:
        return None
    qpos, error = episode.states[:, 1 : 1 + model.nq], 0.0
    for positions, objects in zip(qpos, episode.objects, strict=True):
        data.qpos[:] = positions
        mujoco.mj_kinematics(model, data)
        error = max(error, float(np.abs(env.object_positions() - objects).max(initial=0.0)))
    return qpos, error


def _played_again(env: ManipulationEnv, episode: Episode) -> tuple[Array, float]:
    """Positions `(T, nq)` before each action, by physics from the recorded start and what was executed; and how far any object was
    then from where the episode says [m], which is next to nothing on the machine that recorded it."""
    env.reset(seed=episode.seed, options={"state": episode.initial_state})
    qpos, error = [], 0.0
    for action, objects in zip(episode.executed, episode.objects, strict=True):
        qpos.append(env.data.qpos.copy())
        error = max(error, float(np.abs(env.object_positions() - objects).max(initial=0.0)))
        env.step(action)
    return np.array(qpos), error


