"""The simulated world as a Gymnasium environment: reset, step at 20 Hz, observe, render. No planning in here."""

from __future__ import annotations

import threading
import time
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

import gymnasium
import mujoco
import numpy as np
from numpy.typing import NDArray

from optimus.control import CONTROL_HZ, controller, require_control
from optimus.data.episode import (
    BINARY,
    CONTINUOUS,
    DOOR_ANGLES,
    GRIPPER,
    IMAGE_SIZE,
    IMAGE_SUFFIX,
    INSTRUCTION,
    OBJECT_POSITIONS,
    OBJECT_TURNS,
    OSC,
    Observation,
)
from optimus.data.turns import as_columns
from optimus.errors import ActionError, ModelError, UnknownNameError, require_at_least
from optimus.render import Rig
from optimus.robots import Robot
from optimus.robots.catalogue import robot as robot_named
from optimus.scene import Camera, Scene
from optimus.se3 import Array, Pose
from optimus.spec import PHYSICS_DT
from optimus.state import State
from optimus.task import Problem, Task
from optimus.world import World, compile_scene

SUBSTEPS = round(1 / (CONTROL_HZ * PHYSICS_DT))
FULL_STATE = mujoco.mjtState.mjSTATE_INTEGRATION
RECORDED_STATE = mujoco.mjtState.mjSTATE_FULLPHYSICS
"""Time, positions, velocities: what episodes keep of every step."""
SETTLE_SECONDS = 0.25
"""Physics run after placing the objects, before the first observation."""
STAYS = 0.03
"""How far a thing may come away from its start until it is at rest [m]."""


class _Rigs(threading.local):
    """The renderers of this thread: a GL context belongs to the one that made it."""

    def __init__(self) -> None:
        self.of = lru_cache(maxsize=8)(Rig)


_RIGS = _Rigs()


class ManipulationEnv(gymnasium.Env[Observation, NDArray[np.float32]]):
    """One task, under one way of `control`. Actions in [-1, 1]: for `osc` and `ik` `(7,)`, delta position and delta rotation
    vector of the target pose (base frame), for `joint` `(dof + 1,)`, delta of the joint target, both scaled as
    `optimus.control` says; then the gripper: above 0 shut, else open (or in between, see `gripper`). The reward is 1 on strict
    success, the end."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": CONTROL_HZ}  # noqa: RUF012 - Gymnasium's own convention

    def __init__(
        self,
        task: Task,
        images: bool = True,
        render_mode: str | None = None,
        control: str = OSC,
        robot: Robot | str | None = None,
        positions: bool = False,
        gripper: str = BINARY,
        worlds: Callable[[Scene], World] = compile_scene,
        image_size: int = IMAGE_SIZE,
        cameras: Sequence[str | Camera] | None = None,
    ) -> None:
        """`robot`, or the one of that name or robot file, takes the place of the task's own; with `positions`, agents are told how
        the movables lie; `gripper` is `BINARY` or `CONTINUOUS`; `worlds` makes a scene's world, where that is not the usual one;
        `image_size` [pixels] is the side of what the `cameras` see: those of the scene, by name, and new ones; None: all of the
        scene's."""
        if gripper not in (BINARY, CONTINUOUS):
            raise UnknownNameError("gripper", gripper, (BINARY, CONTINUOUS))
        if isinstance(robot, str):
            robot = robot_named(robot)
        self.gripper, self._worlds = gripper, worlds
        self.task, self.images, self.render_mode, self._robot = task, images, render_mode, robot
        self.positions, self.image_size = positions, image_size
        if isinstance(cameras, str):
            raise UnknownNameError("list of cameras", cameras, [f"[{cameras!r}]"])
        self._views = tuple(camera for camera in cameras or () if isinstance(camera, Camera))
        self._seen_by = None if cameras is None else tuple(c.name if isinstance(c, Camera) else c for c in cameras)
        self.control = require_control(control)
        self.cpu: defaultdict[str, float] = defaultdict(float)
        """CPU seconds spent so far, by `physics` and `rendering`."""
        self._start(task.problem(0, robot), 0)
        for name in self.image_cameras:
            if name not in self.world.image_cameras:
                raise UnknownNameError("camera", name, self.world.image_cameras)
        self.action_space = gymnasium.spaces.Box(-1.0, 1.0, (self.action_size,), np.float32)
        self.observation_space = gymnasium.spaces.Dict(self._spaces())  # pyright: ignore[reportAttributeAccessIssue]

    def _spaces(self) -> dict[str, gymnasium.Space[Any]]:
        spaces: dict[str, gymnasium.Space[Any]] = {
            # generous: within reach, unit quaternions, rotation vectors up to pi, joints that turn once around
            name: gymnasium.spaces.Box(*((-7.0, 7.0) if name == "robot0_joint_pos" else (-4.0, 4.0)), seen.shape, np.float32)
            for name, seen in self._proprioception().items()
        }
        if self.positions:
            count = len(self.world.scene.movable_names)
            spaces[OBJECT_POSITIONS] = gymnasium.spaces.Box(-np.inf, np.inf, (3 * count,), np.float32)
            spaces[OBJECT_TURNS] = gymnasium.spaces.Box(-1.01, 1.01, (6 * count,), np.float32)
            if doors := len(self.world.door_qpos):
                spaces[DOOR_ANGLES] = gymnasium.spaces.Box(-4.0, 4.0, (doors,), np.float32)
        if self.images:
            for camera in self.image_cameras:
                shape = (self.image_size, self.image_size, 3)
                spaces[camera + IMAGE_SUFFIX] = gymnasium.spaces.Box(0, 255, shape, np.uint8)
        return spaces

    def _start(self, problem: Problem, seed: int) -> None:
        self.problem, self.episode_seed = problem, seed
        self.world: World = self._worlds(replace(problem.scene, cameras=(*problem.scene.cameras, *self._views)))
        self.data = mujoco.MjData(self.world.model)
        self.controller = controller(self.control, self.world)
        self._steps = 0

    @property
    def action_size(self) -> int:
        """Numbers in an action: the arm's, then the gripper's."""
        return self.controller.size + 1

    @property
    def image_cameras(self) -> tuple[str, ...]:
        """The cameras of the observations, as these name them."""
        return self.world.image_cameras if self._seen_by is None else self._seen_by

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Start the problem of `seed` (drawn at random without one). `options["state"]` `(n,)`: a physics state as
        `snapshot()` gives it, to start from instead of the problem's own."""
        if seed is not None:
            require_at_least(0, seed=seed)
        super().reset(seed=seed)
        drawn = int(self.np_random.integers(2**31)) if seed is None else seed
        self._start(self.task.problem(drawn, self._robot), drawn)
        opening = 2 * self.world.scene.robot.finger_travel
        state = State(self.world.home, opening, self.problem.poses, tcp=self.world.tcp(self.data))
        self.world.write(self.data, state)
        if overlap := self.world.overlap(self.data):
            raise ModelError(f"{self.task.name}, seed {drawn}: {overlap}; let the task draw starts that are apart")
        self.controller.reset(self.data)
        self._advance(gripper=-1.0, substeps=round(SETTLE_SECONDS / PHYSICS_DT))
        if moved := self._moved_from(self.problem.poses):
            raise ModelError(f"{self.task.name}, seed {drawn}: {moved}; let the task draw starts that are at rest")
        if options and "state" in options:
            mujoco.mj_setState(self.world.model, self.data, np.asarray(options["state"], np.float64), FULL_STATE)
        mujoco.mj_forward(self.world.model, self.data)
        self.controller.reset(self.data)
        return self.observe(), self._info()

    def _moved_from(self, poses: Mapping[str, Pose]) -> str:
        """Which thing did not stay where the problem puts it; empty if all did."""
        for name, now in self.state().poses.items():
            away = float(np.linalg.norm(now.pos - poses[name].pos))
            if not away < STAYS:
                return f"{name} rests on nothing at the start: it came {away:.2f} m away in {SETTLE_SECONDS} s"
        return ""

    def step(
        self, action: NDArray[np.float32]
    ) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        wanted = np.asarray(action, np.float64)
        if wanted.shape != (self.action_size,) or not np.isfinite(wanted).all():
            raise ActionError(f"an action is {self.action_size} finite numbers, not {wanted.tolist()}")
        command = np.clip(wanted, -1.0, 1.0)
        self.controller.move_target(command[:GRIPPER], self.data)
        self._advance(gripper=float(command[GRIPPER]), substeps=SUBSTEPS)
        self._steps += 1
        state = self.state()
        success = self.problem.success(state)
        truncated = self._steps >= self.task.horizon
        info = {"success": success, "paper_success": self.problem.paper_success(state)}
        return self.observe(), float(success), success, truncated, info

    def _advance(self, gripper: float, substeps: int) -> None:
        model, data, world = self.world.model, self.data, self.world
        began = time.process_time()
        shut = (1.0 + gripper) / 2 if self.gripper == CONTINUOUS else float(gripper > 0)
        data.ctrl[world.gripper_ctrl] = 255.0 * (1.0 - shut)
        for _ in range(substeps):
            mujoco.mj_step1(model, data)
            data.ctrl[world.arm_ctrl] = self.controller.torque(data)
            mujoco.mj_step2(model, data)
        mujoco.mj_step1(model, data)
        self.cpu["physics"] += time.process_time() - began

    def _info(self) -> dict[str, Any]:
        return {"seed": self.episode_seed, "variant": self.problem.variant, INSTRUCTION: self.problem.instruction}

    def state(self) -> State:
        """The kinematic snapshot, with what is held."""
        return self.world.state(self.data)

    def snapshot(self, kind: mujoco.mjtState = FULL_STATE) -> Array:
        """The physics state `(n,)`; from the full one, `reset(options={"state": ...})` starts again: with the arm at rest where it
        is, for where it was told to go, and how many steps there were, is not of the physics."""
        out = np.empty(mujoco.mj_stateSize(self.world.model, kind))
        mujoco.mj_getState(self.world.model, self.data, out, kind)
        return out

    def observe(self) -> Observation:
        """What an agent may see, under robosuite's names (`robot0_eef_quat` is xyzw, as there)."""
        seen: Observation = dict(self._proprioception())
        if self.positions:
            seen[OBJECT_POSITIONS] = self.object_positions().astype(np.float32).ravel()
            seen[OBJECT_TURNS] = self._object_turns().ravel()
            if self.world.door_qpos:
                seen[DOOR_ANGLES] = self.data.qpos[sorted(self.world.door_qpos.values())].astype(np.float32)
        if self.images:
            began = time.process_time()
            rig = _RIGS.of(self.world, self.image_size)
            for camera in self.image_cameras:
                seen[camera + IMAGE_SUFFIX] = rig.image(self.data, camera)
            self.cpu["rendering"] += time.process_time() - began
        return seen

    def _proprioception(self) -> dict[str, NDArray[np.float32]]:
        tcp = self.world.tcp(self.data)
        quat = tcp.quat if tcp.quat[1] >= 0 else -tcp.quat
        fingers = self.world.finger_gaps(self.data)
        told = self.controller.proprioception(self.data)
        return {
            "robot0_eef_pos": tcp.pos.astype(np.float32),
            "robot0_eef_quat": np.array([*quat[1:], quat[0]], np.float32),
            "robot0_gripper_qpos": np.array([fingers[0], -fingers[1]], np.float32),
            **{name: value.astype(np.float32) for name, value in told.items()},
        }

    def object_positions(self) -> Array:
        """`(k, 3)` [m], as the scene orders its movables."""
        names = self.world.scene.movable_names
        return np.array([self.world.object_pose(self.data, n).pos for n in names]).reshape(-1, 3)

    def _object_turns(self) -> NDArray[np.float32]:
        """`(k, 6)`, in the same order."""
        names = self.world.scene.movable_names
        return as_columns(np.array([self.world.object_pose(self.data, n).matrix for n in names]).reshape(-1, 3, 3))

    def render(self) -> NDArray[np.uint8]:  # type: ignore[override]
        """A larger picture `(480, 480, 3)` for people."""
        return self.picture(480)

    def picture(self, size: int) -> NDArray[np.uint8]:
        """The people's view, `(size, size, 3)`."""
        return _RIGS.of(self.world, size).view(self.data, self.task.people_camera)

    def close(self) -> None:
        """Nothing to do: renderers are shared between environments and end with the thread."""
