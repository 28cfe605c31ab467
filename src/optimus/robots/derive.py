"""What a robot file leaves out, found in the model itself."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np

from optimus.errors import RobotFileError
from optimus.robots.model import robot_spec, weld_others
from optimus.robots.robot import Robot
from optimus.robots.urdf import urdf_speeds
from optimus.se3 import Pose

TORQUE = 100.0
"""The limit of a joint for which neither the file nor the model gives one [N m]."""
SPEED = np.pi
"""Likewise [rad/s]."""
CAMERA_POS, CAMERA_TARGET = (0.07, 0.0, -0.0834), (0.0, 0.0, 0.0266)
"""Where the Panda's wrist camera is, and what it looks at, from the tcp [m]."""


def derive(robot: Robot, spec: mujoco.MjSpec, given: Collection[str]) -> Robot:
    """`robot` with limits, finger travel and contact exclusions from the model `spec`; `given` is what the file itself says of
    the fingers (`shut`, `open`). Its wrist camera comes in the tool's frame and leaves in the hand's. `RobotFileError` where the
    model does not say enough, or where home cannot be."""
    if not robot.torque_limits:
        robot = replace(robot, torque_limits=tuple(_torque(spec, name) for name in robot.joints))
    if not robot.speed_limits:
        known = urdf_speeds(Path(robot.source)) if robot.source.lower().endswith(".urdf") else {}
        robot = replace(robot, speed_limits=tuple(known.get(name, SPEED) for name in robot.joints))
    eye, target = (_from_tool(robot, point) for point in (robot.camera_pos, robot.camera_target))
    robot = replace(robot, camera_pos=eye, camera_target=target)
    if {"shut", "open"} - set(given):
        robot = _with_travel(robot, spec, given)
    if both := sorted({*robot.joints} & {*robot.fingers}):
        raise RobotFileError(f"{', '.join(both)} stands in joints and in gripper.joints: a joint is the arm's or a finger's")
    if min(abs(o - s) for o, s in zip(robot.finger_open, robot.finger_shut, strict=True)) < 1e-4:
        raise RobotFileError("the fingers do not move: gripper.shut and gripper.open are the same")
    model = _compiled(robot_spec(robot))
    data = mujoco.MjData(model)
    _require_a_hand(robot, model, data)
    _require_home_within(robot, model)
    if robot.gripper_actuator is not None:
        robot = replace(robot, actuator_travel=_actuator_travel(robot, robot.gripper_actuator, model, data))
    return replace(robot, untouching=_touching_at_home(robot, model, data))


def _compiled(spec: mujoco.MjSpec) -> mujoco.MjModel:
    """The model of `spec`; `RobotFileError` where MuJoCo finds a fault in it."""
    try:
        return spec.compile()
    except ValueError as error:
        raise RobotFileError(f"the model does not compile: {' '.join(str(error).split())}") from error


def _require_a_hand(robot: Robot, model: mujoco.MjModel, data: mujoco.MjData) -> None:
    """`RobotFileError` unless the hand hangs on the arm's last joint, the fingers on the hand or beside it, and they shut."""
    last = robot.joints[-1]
    moved = int(model.joint(last).bodyid[0])
    for what, bodies in (("hand", [robot.hand]), ("gripper.bodies", robot.finger_bodies)):
        for name in bodies:
            if moved not in _up_from(model, int(model.body(name).id)):
                raise RobotFileError(f"{what}: {name} is not moved by {last}, the arm's last joint")
    for key, values in (("shut", robot.finger_shut), ("open", robot.finger_open)):
        for name, value in zip(robot.fingers, values, strict=True):
            joint = model.joint(name)
            low, high = (float(v) for v in joint.range)
            if low < high and model.jnt_limited[joint.id] and not low - 1e-4 <= value <= high + 1e-4:
                raise RobotFileError(f"gripper.{key}: {value:g} is outside the range of {name}, {low:g} to {high:g} m")
    shut, wide = (_gap(robot, model, data, pair) for pair in (robot.finger_shut, robot.finger_open))
    if wide <= shut:
        raise RobotFileError(f"the fingers are {1000 * shut:.0f} mm apart at gripper.shut and {1000 * wide:.0f} at gripper.open")


def _up_from(model: mujoco.MjModel, body: int) -> set[int]:
    """A body and all that it hangs on, but the world."""
    chain: set[int] = set()
    while body:
        chain.add(body)
        body = int(model.body_parentid[body])
    return chain


def _from_tool(robot: Robot, point: tuple[float, float, float]) -> tuple[float, float, float]:
    x, y, z = (float(c) for c in Pose(np.array(robot.tcp), np.array(robot.tcp_quat)).transform(point))
    return (x, y, z)


def _torque(spec: mujoco.MjSpec, name: str) -> float:
    """What the joint allows, else its actuator: its force, or what a motor is told at most, times its gear."""
    limit = float(np.abs(spec.joint(name).actfrcrange).max())
    drives = [a for a in spec.actuators if a.target == name]
    forces = [float(np.abs(a.forcerange).max() * abs(a.gear[0])) for a in drives]
    motors = [a for a in drives if a.biastype == mujoco.mjtBias.mjBIAS_NONE and a.gaintype == mujoco.mjtGain.mjGAIN_FIXED]
    told = [float(np.abs(a.ctrlrange).max() * abs(a.gainprm[0] * a.gear[0])) for a in motors]
    return next((value for value in (limit, *forces, *told) if value > 0.0), TORQUE)


def _with_travel(robot: Robot, spec: mujoco.MjSpec, given: Collection[str]) -> Robot:
    """Fingers are open at that end of their joint's range at which they are further apart along the tool's y."""
    if not all(any(g.contype for g in spec.body(name).geoms) for name in robot.finger_bodies):
        raise RobotFileError(f"gripper.bodies should be what touches: {' or '.join(robot.finger_bodies)} has no collision shape")
    for name in robot.fingers:
        if spec.joint(name).type != mujoco.mjtJoint.mjJNT_SLIDE:
            raise RobotFileError(f"the finger joint {name} does not slide: only fingers that move along a line are known here")
    ranges = [tuple(float(v) + 0.0 for v in spec.joint(name).range) for name in robot.fingers]
    if any(low == high for low, high in ranges):
        raise RobotFileError("the finger joints have no range: give gripper.shut and gripper.open")
    weld_others(spec, {*robot.joints, *robot.fingers})
    model = _compiled(spec)
    data = mujoco.MjData(model)
    first, second = ranges
    # of the pairs of ends, the widest apart is open; each finger's other end is shut
    ends = [(a, b) for a in first for b in second]
    wide = max(ends, key=lambda pair: _gap(robot, model, data, pair))
    shut = (sum(first) - wide[0], sum(second) - wide[1])
    robot = replace(robot, finger_open=robot.finger_open if "open" in given else wide)
    return replace(robot, finger_shut=robot.finger_shut if "shut" in given else shut)


def _gap(robot: Robot, model: mujoco.MjModel, data: mujoco.MjData, fingers: tuple[float, float]) -> float:
    """How far apart the middles of the fingers' shapes are [m] along the axis on which they close."""
    for name, value in zip(robot.fingers, fingers, strict=True):
        data.qpos[model.joint(name).qposadr[0]] = value
    mujoco.mj_kinematics(model, data)
    hand = model.body(robot.hand).id
    tool = Pose.from_matrix(data.xpos[hand], data.xmat[hand].reshape(3, 3)) @ Pose(np.zeros(3), np.array(robot.tcp_quat))
    solid = model.geom_contype > 0
    bodies = (solid & (model.geom_bodyid == model.body(name).id) for name in robot.finger_bodies)
    first, second = (tool.inverse.transform(data.geom_xpos[of].mean(axis=0)) for of in bodies)
    return float(abs(first[1] - second[1]))


def _require_home_within(robot: Robot, model: mujoco.MjModel) -> None:
    for name, value in zip(robot.joints, robot.home, strict=True):
        low, high = (float(v) for v in model.joint(name).range)
        if not low <= value <= high:
            raise RobotFileError(f"home is outside the range of {name}: {value} is not in {low:.3f} to {high:.3f} rad")


def _actuator_travel(robot: Robot, name: str, model: mujoco.MjModel, data: mujoco.MjData) -> tuple[float, float]:
    """The gripper actuator's length with the hand shut and with it open [m]."""
    lengths = []
    for fingers in (robot.finger_shut, robot.finger_open):
        _take_home(robot, model, data, fingers)
        lengths.append(float(data.actuator_length[model.actuator(name).id]))
    if abs(lengths[1] - lengths[0]) < 1e-6:
        raise RobotFileError(f"the actuator {name} does not move the fingers")
    return (lengths[0], lengths[1])


def _take_home(robot: Robot, model: mujoco.MjModel, data: mujoco.MjData, fingers: tuple[float, float]) -> None:
    """Put the arm at home and the finger joints at `fingers` [m]."""
    for name, value in zip((*robot.joints, *robot.fingers), (*robot.home, *fingers), strict=True):
        data.qpos[model.joint(name).qposadr[0]] = value
    mujoco.mj_forward(model, data)


def _touching_at_home(robot: Robot, model: mujoco.MjModel, data: mujoco.MjData) -> tuple[tuple[str, str], ...]:
    """Bodies of the robot that meet at home, hand shut or open: neighbours whose shapes overlap. The fingers may meet."""
    pairs: set[tuple[str, str]] = set()
    for fingers in (robot.finger_shut, robot.finger_open):
        _take_home(robot, model, data, fingers)
        for geoms in data.contact.geom[: data.ncon]:
            a, b = sorted(model.body(int(model.geom_bodyid[g])).name for g in geoms)
            pairs.add((a, b))
    fingers = frozenset(robot.finger_bodies)
    return tuple(sorted(pair for pair in pairs if frozenset(pair) != fingers))
