"""`World`: a scene compiled into the one MuJoCo model that physics, kinematics, collision and rendering share."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from optimus.errors import ModelError
from optimus.robots.model import TCP_SITE, WRIST_EYE
from optimus.scene import WRIST_CAMERA, Scene
from optimus.se3 import Array, Pose
from optimus.spec import BAR_SUFFIX, ROBOT_PREFIX, world_spec
from optimus.state import Held, State

OVERLAP = 0.004
"""Things deeper inside one another than this at the start do not just touch [m]."""


def run_of(numbers: NDArray[np.int_]) -> slice | NDArray[np.int_]:
    """The same indices as a slice where each is one more than the last: what it cuts out is not picked together one by one."""
    first, after = int(numbers[0]), int(numbers[-1]) + 1
    return slice(first, after) if np.array_equal(numbers, np.arange(first, after)) else numbers


class World:
    """A compiled scene: the one `MjModel` and the addresses of everything in it. Build with `compile_scene`."""

    def __init__(self, scene: Scene, look: Callable[[mujoco.MjSpec], None] = lambda spec: None) -> None:
        """`look` may change how it looks before it is compiled."""
        try:
            spec = world_spec(scene)
            look(spec)
            self.model: mujoco.MjModel = spec.compile()
        except ValueError as error:
            raise ModelError(f"the scene does not compile: {error}") from error
        m, robot = self.model, scene.robot
        self.scene = scene
        joints = [m.joint(ROBOT_PREFIX + name) for name in robot.joints]
        fingers = [m.joint(ROBOT_PREFIX + name) for name in robot.fingers]
        self.arm_qpos = np.array([int(j.qposadr[0]) for j in joints])
        self.arm_dof = np.array([int(j.dofadr[0]) for j in joints])
        self.arm_range = np.array([j.range for j in joints])
        self.arm_ctrl = np.array([self._actuator_of(int(j.id)) for j in joints])
        self.finger_qpos = np.array([int(j.qposadr[0]) for j in fingers])
        self.finger_shut, self.finger_signs = np.array(robot.finger_shut), np.array(robot.finger_signs)
        actuators = robot.fingers if robot.gripper_actuator is None else (robot.gripper_actuator,)
        self.gripper_ctrl = np.array([int(m.actuator(ROBOT_PREFIX + name).id) for name in actuators])
        self.tcp_site = int(m.site(ROBOT_PREFIX + TCP_SITE).id)
        self.hand_body = int(m.body(ROBOT_PREFIX + robot.hand).id)
        self.finger_bodies = tuple(int(m.body(ROBOT_PREFIX + n).id) for n in robot.finger_bodies)
        self.movable_qpos = {n: int(m.joint(n).qposadr[0]) for n in scene.movable_names}
        self.movable_dof = {n: int(m.joint(n).dofadr[0]) for n in scene.movable_names}
        doors = [d.name for d in scene.doors]
        self.door_qpos = {n: int(m.joint(n).qposadr[0]) for n in doors}
        self.bar_geoms = {n: int(m.geom(n + BAR_SUFFIX).id) for n in doors}
        self.body_ids = {n: int(m.body(n).id) for n in (*scene.movable_names, *scene.fixture_poses, *doors)}
        self.body_names = {v: k for k, v in self.body_ids.items()}
        root = int(m.body_rootid[self.hand_body])
        self.robot_bodies = frozenset(int(i) for i in np.flatnonzero(m.body_rootid == root))
        self.home = np.array(robot.home)

    def _actuator_of(self, joint_id: int) -> int:
        m = self.model
        is_joint = m.actuator_trntype == mujoco.mjtTrn.mjTRN_JOINT
        return int(np.flatnonzero(is_joint & (m.actuator_trnid[:, 0] == joint_id))[0])

    @property
    def image_cameras(self) -> tuple[str, ...]:
        """The cameras as observations name them; the wrist's last."""
        return (*(c.name for c in self.scene.cameras), WRIST_CAMERA)

    @property
    def views(self) -> dict[str, dict[str, Any]]:
        """The fixed cameras: `pos` [m] and `quat` wxyz in the base frame, `fovy` [deg]."""
        ids = {camera.name: self.camera_id(camera.name) for camera in self.scene.cameras}
        m = self.model
        return {
            name: {"pos": m.cam_pos[i].tolist(), "quat": m.cam_quat[i].tolist(), "fovy": float(m.cam_fovy[i])}
            for name, i in ids.items()
        }

    def camera_id(self, name: str) -> int:
        model_name = ROBOT_PREFIX + WRIST_EYE if name == WRIST_CAMERA else name
        return int(self.model.camera(model_name).id)

    # ---- between MuJoCo's vectors and State

    def write(self, data: mujoco.MjData, state: State) -> None:
        """Put `data` at rest in `state` and bring its kinematics up to date."""
        mujoco.mj_resetData(self.model, data)
        self.write_qpos(data, state)
        data.ctrl[self.gripper_ctrl] = 255.0 * state.opening / (2 * self.scene.robot.finger_travel)
        mujoco.mj_forward(self.model, data)

    def write_qpos(self, data: mujoco.MjData, state: State) -> None:
        """The positions alone: no kinematics, no reset."""
        data.qpos[self.arm_qpos] = state.q
        data.qpos[self.finger_qpos] = self.finger_shut + self.finger_signs * (state.opening / 2)
        for name, pose in state.poses.items():
            at = self.movable_qpos[name]
            data.qpos[at : at + 3] = pose.pos
            data.qpos[at + 3 : at + 7] = pose.quat
        for name, angle in state.doors.items():
            data.qpos[self.door_qpos[name]] = angle

    def tcp(self, data: mujoco.MjData) -> Pose:
        """`base_from_tcp` as of the last kinematics."""
        return Pose.from_matrix(data.site_xpos[self.tcp_site].copy(), data.site_xmat[self.tcp_site].reshape(3, 3))

    def finger_gaps(self, data: mujoco.MjData) -> Array:
        """How far each finger is from where they meet, `(2,)` [m]."""
        return self.finger_signs * (data.qpos[self.finger_qpos] - self.finger_shut)

    def object_pose(self, data: mujoco.MjData, name: str) -> Pose:
        at = self.movable_qpos[name]
        return Pose(data.qpos[at : at + 3].copy(), data.qpos[at + 3 : at + 7].copy())

    def state(self, data: mujoco.MjData) -> State:
        """The kinematic snapshot of a running simulation, with what the fingers hold."""
        poses = {n: self.object_pose(data, n) for n in self.scene.movable_names}
        touched = self._touched_by_fingers(data)
        held = [n for n in poses if len(touched.get(n, ())) == 2]
        tcp = self.tcp(data)
        speeds = {n: float(np.linalg.norm(data.qvel[d : d + 3])) for n, d in self.movable_dof.items()}
        return State(
            q=data.qpos[self.arm_qpos].copy(),
            opening=float(self.finger_gaps(data).sum()),
            poses=poses,
            held=Held(held[0], tcp.inverse @ poses[held[0]]) if held else None,
            touched=frozenset(touched),
            speeds=speeds,
            tcp=tcp,
            doors={n: float(data.qpos[at]) for n, at in self.door_qpos.items()},
        )

    def overlap(self, data: mujoco.MjData) -> str:
        """Which two things stand inside one another, and how deep; empty if none do. For a state that was just written."""
        for (geom_a, geom_b), gap in zip(data.contact.geom[: data.ncon], data.contact.dist[: data.ncon], strict=True):
            a, b = (int(self.model.geom_bodyid[g]) for g in (geom_a, geom_b))
            names = [self.body_names.get(body, "robot") for body in (a, b)]
            if gap < -OVERLAP and any(name in self.movable_qpos for name in names):
                return f"{names[0]} and {names[1]} overlap by {-1e3 * gap:.0f} mm at the start"
        return ""

    def _touched_by_fingers(self, data: mujoco.MjData) -> dict[str, set[int]]:
        """Which movables are in contact with the robot, and with which of its fingers."""
        touched: dict[str, set[int]] = {}
        for geom_a, geom_b in data.contact.geom[: data.ncon]:
            a, b = int(self.model.geom_bodyid[geom_a]), int(self.model.geom_bodyid[geom_b])
            if b in self.robot_bodies:
                a, b = b, a
            if a in self.robot_bodies and self.body_names.get(b) in self.movable_qpos:
                fingers = touched.setdefault(self.body_names[b], set())
                if a in self.finger_bodies:
                    fingers.add(a)
        return touched


@lru_cache(maxsize=8)
def compile_scene(scene: Scene) -> World:
    """The scene's compiled model; equal scenes share one (it is never written to after compiling)."""
    return World(scene)
