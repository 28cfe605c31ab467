"""Try things in the physics they will be used in: does it stand still when dropped, does a grasp hold it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import mujoco
import numpy as np

from optimus.objects.shapes import Grasp, Shape
from optimus.robots import Robot
from optimus.robots.model import robot_spec
from optimus.se3 import Array, Pose, rotvec_from_quat
from optimus.spec import PHYSICS_DT, add_shape, physics

DROP = 0.05
"""Height that a thing is let fall from [m]."""
REST_SECONDS, REST_SPEED, REST_LEAN = 2.0, 0.01, 0.08
"""After this long [s] it moves more slowly than this [m/s], and leans less than this [rad]."""
CLOSE_SECONDS = 0.5
SHAKE_SECONDS, SHAKE = 0.3, 4.0
"""Each jolt: how long [s] and how hard [m/s^2], in six directions, on top of gravity."""
SLIP, TURN = 0.010, 0.20
"""A grasp holds if the thing moves less than this in the hand [m], and turns less than this [rad], after the fingers closed."""
DRAG, TIP = 0.015, 0.20
"""... and while they close [m], [rad]."""
NUDGES = ((0.0, 0.0, 0.0), (0.004, 0.003, 0.003), (-0.004, -0.003, -0.008))
"""Errors of the hand's place, in its own frame [m], that a grasp has to stand."""
TOUCH = 0.0005
"""Contacts shallower than this are none [m]."""


@dataclass(frozen=True)
class Outcome:
    """What came of a grasp: held or why not, and how far the thing moved while the fingers closed and while it was shaken."""

    failure: str
    """Empty when it held."""
    closing: tuple[float, float] = (0.0, 0.0)
    """[m], [rad]"""
    shaking: tuple[float, float] = (0.0, 0.0)

    @property
    def held(self) -> bool:
        return not self.failure


def _ground(spec: mujoco.MjSpec, shape: Shape) -> None:
    ground = spec.worldbody.add_geom(name="ground", type=mujoco.mjtGeom.mjGEOM_BOX, size=[0.5, 0.5, 0.02], pos=[0, 0, -0.02])
    ground.condim, ground.friction = 4, [1.0, 0.02, 0.0005]
    body = spec.worldbody.add_body(name="thing")
    body.add_freejoint()
    add_shape(spec, body, shape)


def dropped(shape: Shape) -> tuple[float, float]:
    """Let it fall upright from `DROP` on a table: its speed [m/s] and how far it leans [rad] after `REST_SECONDS`."""
    spec = mujoco.MjSpec()
    physics(spec)
    _ground(spec, shape)
    model = spec.compile()
    data = mujoco.MjData(model)
    data.qpos[:7] = [0.0, 0.0, shape.half_extents[2] + DROP, 1.0, 0.0, 0.0, 0.0]
    mujoco.mj_step(model, data, nstep=round(REST_SECONDS / PHYSICS_DT))
    upright = Pose(data.qpos[:3].copy(), data.qpos[3:7].copy()).matrix[2, 2]
    return float(np.linalg.norm(data.qvel[:3])), float(np.arccos(np.clip(upright, -1.0, 1.0)))


@lru_cache(maxsize=4)
def _hand_spec(robot: Robot) -> mujoco.MjSpec:
    return robot_spec(robot)


class GraspTrial:
    """A robot's real hand, floating over a table on which the thing stands. Holds one simulation; try grasps one by one."""

    def __init__(self, shape: Shape, robot: Robot) -> None:
        self.shape, self.robot = shape, robot
        spec = mujoco.MjSpec()
        physics(spec)
        _ground(spec, shape)
        arm = _hand_spec(robot).copy()
        hand = spec.worldbody.add_frame().attach_body(arm.body(robot.hand), "hand/", "")
        hand.mocap = True
        hand.pos, hand.quat = [0, 0, 1], [1, 0, 0, 0]
        model = self._model = spec.compile()
        self._data = mujoco.MjData(model)
        self._gravity = model.opt.gravity.copy()
        self._hand_from_tcp = Pose(np.array(robot.tcp), np.array(robot.tcp_quat))
        self._thing = int(model.joint(int(model.body("thing").jntadr[0])).qposadr[0])
        self._fingers = [int(model.joint("hand/" + n).qposadr[0]) for n in robot.fingers]
        actuators = robot.fingers if robot.gripper_actuator is None else (robot.gripper_actuator,)
        self._ctrl = [int(model.actuator("hand/" + n).id) for n in actuators]
        self._wide = model.actuator_ctrlrange[self._ctrl, 1].copy()
        thing = int(model.body("thing").id)
        self._thing_geom = model.geom_bodyid == thing
        self._ground_geom = int(model.geom("ground").id)
        roots = [int(model.body("hand/" + n).id) for n in robot.finger_bodies]
        self._finger_geoms = [np.isin(model.geom_bodyid, _below(model, root)) for root in roots]
        self._hand_geom = ~self._thing_geom & (np.arange(model.ngeom) != self._ground_geom)

    def run(self, grasp: Grasp, nudges: tuple[tuple[float, float, float], ...] = NUDGES) -> Outcome:
        """Close on the standing thing, take the table away, shake; once for each error of the hand's place."""
        worst = Outcome("")
        for nudge in nudges:
            outcome = self._once(grasp.pose @ Pose.of(nudge), free=nudge == nudges[0])
            if not outcome.held:
                return outcome
            worst = max(worst, outcome, key=lambda o: o.shaking)
        return worst

    def is_clear(self, grasp: Grasp) -> bool:
        """Whether the open hand is clear of the thing and of the table there, and 6 cm before it along its approach."""
        table_from_tcp = Pose.of((0.0, 0.0, self.shape.half_extents[2])) @ grasp.pose
        for back in (0.0, 0.02, 0.04, 0.06):
            self._place(table_from_tcp.shifted(-back * table_from_tcp.matrix[:, 2]))
            if self._meets():
                return False
        return True

    def _place(self, table_from_tcp: Pose) -> None:
        """The thing upright on the table, the open hand where it is to be."""
        model, data = self._model, self._data
        mujoco.mj_resetData(model, data)
        model.opt.gravity[:] = self._gravity
        model.geom_conaffinity[self._ground_geom] = model.geom_contype[self._ground_geom] = 1
        data.qpos[self._thing : self._thing + 7] = [0.0, 0.0, self.shape.half_extents[2], 1.0, 0.0, 0.0, 0.0]
        data.qpos[self._fingers] = self.robot.finger_open
        data.ctrl[self._ctrl] = self._wide
        hand = table_from_tcp @ self._hand_from_tcp.inverse
        data.mocap_pos[0], data.mocap_quat[0] = hand.pos, hand.quat
        mujoco.mj_kinematics(model, data)
        mujoco.mj_collision(model, data)

    def _meets(self) -> bool:
        data = self._data
        geoms, depth = data.contact.geom[: data.ncon], -data.contact.dist[: data.ncon]
        return bool((self._hand_geom[geoms].any(axis=1) & ~self._hand_geom[geoms].all(axis=1) & (depth > TOUCH)).any())

    def _once(self, object_from_tcp: Pose, free: bool) -> Outcome:
        model, data = self._model, self._data
        self._place(Pose.of((0.0, 0.0, self.shape.half_extents[2])) @ object_from_tcp)
        if free and self._meets():
            return Outcome("the open hand meets it")
        before = self._pose()
        data.ctrl[self._ctrl] = 0.0
        mujoco.mj_step(model, data, nstep=round(CLOSE_SECONDS / PHYSICS_DT))
        closing = _apart(before, self._pose())
        if not self._held():
            return Outcome("the fingers miss it", closing)
        if closing[0] > DRAG or closing[1] > TIP:
            return Outcome("it moves as the fingers close", closing)
        model.geom_conaffinity[self._ground_geom] = model.geom_contype[self._ground_geom] = 0  # the table is gone
        before = self._pose()
        for jolt in (np.zeros(3), *(s * SHAKE * axis for axis in np.eye(3) for s in (1.0, -1.0))):
            model.opt.gravity[:] = self._gravity + jolt  # in the hand's frame, to be jolted is to be heavy another way
            mujoco.mj_step(model, data, nstep=round(SHAKE_SECONDS / PHYSICS_DT))
        shaking = _apart(before, self._pose())
        if not self._held() or shaking[0] > SLIP or shaking[1] > TURN:
            return Outcome("it slips", closing, shaking)
        return Outcome("", closing, shaking)

    def _pose(self) -> Pose:
        at = self._thing
        return Pose(self._data.qpos[at : at + 3].copy(), self._data.qpos[at + 3 : at + 7].copy())

    def _held(self) -> bool:
        """Whether both fingers touch it."""
        geoms = self._data.contact.geom[: self._data.ncon]
        with_thing = self._thing_geom[geoms].any(axis=1)
        return all(bool((finger[geoms].any(axis=1) & with_thing).any()) for finger in self._finger_geoms)


def _below(model: mujoco.MjModel, root: int) -> list[int]:
    """The bodies of the subtree at `root`."""
    bodies = [root]
    for body in range(root + 1, model.nbody):
        if int(model.body_parentid[body]) in bodies:
            bodies.append(body)
    return bodies


def _apart(a: Pose, b: Pose) -> tuple[float, float]:
    """How far apart two poses of the thing are [m], [rad]."""
    turn: Array = (a.inverse @ b).quat
    return float(np.linalg.norm(a.pos - b.pos)), float(np.linalg.norm(rotvec_from_quat(turn)))


