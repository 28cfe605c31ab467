"""A task in the browser: the problem of a seed, the expert's plan for it or why there is none, and the grasps of an object."""

from __future__ import annotations

import threading
from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from optimus.demonstrate import ExpertConfig, plan_for
from optimus.env import ManipulationEnv
from optimus.motion.plan import Infeasible, Plan
from optimus.se3 import Array, Pose
from optimus.skills import Workspace
from optimus.skills.pick import Pick
from optimus.view import words
from optimus.view.player import Player
from optimus.view.stage import Rgb, Stage
from optimus.view.timeline import RATE, timeline

if TYPE_CHECKING:
    import viser

    from optimus.robots import Robot
    from optimus.task import Task

NOTHING = "none"
IN_THE_WAY, CONCERNED = (214, 48, 49), (240, 170, 40)
ACCEPTED, REFUSED = (40, 160, 80), (205, 70, 60)
FINGER, PALM = 0.045, 0.03
"""A grasp is drawn as a fork: its prongs and its handle are this long [m]."""


class SceneView:
    """One problem of a task at a time, with its plan."""

    def __init__(self, server: viser.ViserServer, task: Task, seed: int, robot: Robot | None = None) -> None:
        self.task, self._server = task, server
        self._lock = threading.RLock()  # what the browser asks for comes on many threads
        self._env = ManipulationEnv(task, images=False, robot=robot)
        self.player = Player(server, self._show)
        gui = server.gui
        self._seed = gui.add_number("seed", seed, min=0, step=1, hint="which problem of the task")
        self._said = gui.add_html("")
        self._ghosts = gui.add_checkbox("ghosts", True, hint="the arm at the end of each skill and where the gripper acts")
        self._grasped = gui.add_dropdown("grasps of", _names(()), hint="where a hand could take the object as it stands now")
        self._about_grasps = gui.add_html("")
        self._seed.on_update(lambda _: self.solve(int(self._seed.value)))
        self._ghosts.on_update(lambda _: self._draw_ghosts())
        self._grasped.on_update(lambda _: self._draw_grasps(self._grasped.value))
        self.solve(seed)

    def solve(self, seed: int) -> None:
        """Draw the problem of `seed`, plan for it, and show either the plan or why there is none."""
        with self._lock:
            self.player.pause()
            self._solve(seed)

    def _solve(self, seed: int) -> None:
        self._env.reset(seed=seed)
        self.stage = Stage(self._server, self._env.world, self.task)
        self.stage.show(self._env.data.qpos)
        self._said.content = words.facts({"planning": "at work"})
        self.found = plan_for(self._env, seed, ExpertConfig()).plan
        self.moments = [] if isinstance(self.found, Infeasible) else timeline(self.found, self._env.world.scene)
        self.player.load(len(self.moments), RATE)
        self._grasped.options = _names(self._env.world.scene.movable_names)
        self._grasped.value = NOTHING
        self._about_grasps.content = ""
        if isinstance(self.found, Infeasible):
            self._explain(self.found)
        else:
            self._draw_ghosts()
            self._show(0)

    def close(self) -> None:
        """End what plays."""
        self.player.close()

    def _explain(self, found: Infeasible) -> None:
        """Say why not; what was in the way stands out in red, what the skill was about in yellow."""
        self._said.content = words.why_not(found)
        known = self.stage.world.body_ids
        for name in found.blockers:
            if name in known:
                self.stage.mark(name, IN_THE_WAY, f"{name}: in the way")
        for name in found.objects[:1]:
            if name in known and name not in found.blockers:
                self.stage.mark(name, CONCERNED, f"{name}: {found.reason}")

    def _show(self, index: int) -> None:
        """The moment of that index, and the words for it."""
        with self._lock:
            if isinstance(self.found, Plan) and self.moments:
                moment = self.moments[min(index, len(self.moments) - 1)]
                self.stage.show(moment.qpos)
                self._said.content = words.skeleton(self.found.steps, moment.step, moment.segment)

    def _draw_ghosts(self) -> None:
        with self._lock:
            self.stage.clear("ghosts")
            if not isinstance(self.found, Plan) or not self._ghosts.value:
                return
            for i, moment in enumerate(self.moments):
                if moment.key:
                    self.stage.ghost(str(i), moment.qpos, words.colour_of(self.found.steps[moment.step].operator.skill))

    def show_grasps(self, thing: str) -> None:
        """Choose what grasps are shown of; `none` takes them away."""
        self._grasped.value = thing

    def _draw_grasps(self, thing: str) -> None:
        """Forks where the hand could take `thing` from the start, those that the arm cannot take in red."""
        with self._lock:
            accepted, refused = ([], []) if thing == NOTHING else self.grasps_of(thing)
        poses = [*accepted, *(pose for pose, _ in refused)]
        forks = np.concatenate([_fork(p) for p in poses]) if poses else np.empty((0, 2, 3))
        each = len(_fork(Pose.of()))
        colours: list[Rgb] = [ACCEPTED] * (each * len(accepted)) + [REFUSED] * (each * len(refused))
        self.stage.lines("grasps", forks, colours)
        if poses:
            self._ghosts.value = False  # they stand where the forks do
        counts = Counter(why for _, why in refused)
        self._about_grasps.content = "" if thing == NOTHING else words.grasps(thing, len(accepted), counts)

    def grasps_of(self, thing: str) -> tuple[list[Pose], list[tuple[Pose, str]]]:
        """Tcp poses that the arm can take at the start, and those that it cannot, each with why."""
        workspace, state = Workspace(self._env.world), self._env.state()
        accepted, refused = [], []
        for pose in Pick().grasps(workspace, state, thing):
            workspace.failures.clear()
            if workspace.fits(state, pose):
                accepted.append(pose)
            else:
                refused.append((pose, _reason(workspace)))
        return accepted, refused


def _names(things: tuple[str, ...]) -> tuple[str, ...]:
    """What grasps can be asked for of."""
    return (NOTHING, *things)


def _reason(workspace: Workspace) -> str:
    if not workspace.failures:
        return "no configuration of the arm"
    _, blocked = workspace.failures[-1]
    if blocked.b == "its joint limits":
        return "out of the joints' reach"
    first, second = sorted((blocked.a, blocked.b), key=lambda name: name != "robot")
    return f"{first} would meet {second}"


def _fork(grasp: Pose) -> Array:
    """Lines `(4, 2, 3)` [m]: two prongs to the fingertips at the tcp, what joins them, and the handle."""
    half = 0.03
    left, right = np.array([0.0, half, 0.0]), np.array([0.0, -half, 0.0])
    back, handle = np.array([0.0, 0.0, -FINGER]), np.array([0.0, 0.0, -FINGER - PALM])
    lines = [(left, left + back), (right, right + back), (left + back, right + back), (back, handle)]
    return np.array([[grasp.transform(a), grasp.transform(b)] for a, b in lines])
