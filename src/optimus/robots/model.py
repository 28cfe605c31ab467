"""From a `Robot` to MuJoCo's description of it, made fit for torque control: motors, a strong gripper, a tcp and a wrist camera."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from optimus.errors import RobotFileError
from optimus.robots.menagerie import fetch
from optimus.robots.robot import GRIPPER_PREFIX, Mount, Robot
from optimus.robots.urdf import UNLIMITED, read_urdf
from optimus.se3 import look_at, matrix_from_quat

MENAGERIE = "menagerie:"
HIDDEN_GROUP = 4
"""Renderers leave this group of sites out: a marker at the tcp would tell the policy what no real camera shows."""
GRIPPER_KP, GRIPPER_KV = 2000.0, 300.0
GRIPPER_FORCE = 60.0
"""Of both fingers together [N]."""
BEYOND = 0.02
"""A hand that shuts aims this far beyond its fingers' meeting [m]."""
TCP_SITE, WRIST_EYE = "optimus-tcp", "optimus-eye"
"""What is added to the hand, by names that no model uses for something of its own."""
FULL_CTRL = 255.0
"""The gripper's control goes from 0, shut, to this, open."""
ARMATURE = 0.1
"""Of a joint whose model gives none: geared motors have some [kg m^2, or kg for a finger]."""


def assemble(source: str, mount: Mount | None) -> mujoco.MjSpec:
    """The model of the arm with the gripper on it, as their files have it. `RobotFileError` when one cannot be read."""
    spec = _read(source)
    if mount is not None:
        body = next((b for b in spec.bodies if b.name == mount.body), None)
        if body is None:
            raise RobotFileError(f"no body {mount.body!r} to mount the gripper on; there are: {names(spec.bodies)}")
        gripper = _read(mount.model)
        root = gripper.worldbody.first_body()
        if root is None:
            raise RobotFileError(f"{mount.model} has no body")
        body.add_frame(pos=mount.pos, quat=mount.quat).attach_body(root, GRIPPER_PREFIX, "")
    for key in list(spec.keys):
        spec.delete(key)
    for light in list(spec.lights):
        spec.delete(light)
    for sensor in list(spec.sensors):  # nothing here reads them, and what they are of may go
        spec.delete(sensor)
    return spec


def _read(source: str) -> mujoco.MjSpec:
    if source.startswith(MENAGERIE):
        return mujoco.MjSpec.from_file(str(fetch(source.removeprefix(MENAGERIE)) / "panda.xml"))
    path = Path(source)
    if not path.is_file():
        raise RobotFileError(f"no model file {path}")
    if path.suffix.lower() == ".urdf":
        return read_urdf(path)
    try:
        return mujoco.MjSpec.from_file(source)
    except ValueError as error:
        raise RobotFileError(f"{path}: {' '.join(str(error).split())}") from error


def names(things: list) -> str:
    """The names of some of a model's elements, for a message."""
    return ", ".join(thing.name for thing in things if thing.name and thing.name != "world") or "none"


def root_body(spec: mujoco.MjSpec, body: str) -> mujoco.MjsBody:
    """The body without a parent that `body` hangs on."""
    at = spec.body(body)
    while at.parent is not None and at.parent.name != "world":
        at = at.parent
    return at


def robot_spec(robot: Robot) -> mujoco.MjSpec:
    """The robot's model with torque motors, a strong gripper, grippy pads, a tcp site and a wrist camera."""
    spec = assemble(robot.source, robot.mount)
    weld_others(spec, {*robot.joints, *robot.fingers})
    _drive_arm(spec, robot)
    _drive_gripper(spec, robot)
    for name in robot.finger_bodies:
        _grip(spec, spec.body(name), robot)
    present = {frozenset((e.bodyname1, e.bodyname2)) for e in spec.excludes}
    for body1, body2 in robot.untouching:
        if frozenset((body1, body2)) not in present:
            spec.add_exclude(bodyname1=body1, bodyname2=body2)
    hand = spec.body(robot.hand)
    hand.add_site(name=TCP_SITE, pos=robot.tcp, quat=robot.tcp_quat, group=HIDDEN_GROUP)
    up = matrix_from_quat(np.array(robot.tcp_quat))[:, 0]
    hand.add_camera(
        name=WRIST_EYE,
        pos=robot.camera_pos,
        quat=look_at(robot.camera_pos, robot.camera_target, up),
        fovy=robot.camera_fovy,
    )
    return spec


def weld_others(spec: mujoco.MjSpec, used: set[str]) -> None:
    """Joints that the robot does not name stay where they are; what refers to them goes with them."""
    gone = {joint.name for joint in spec.joints if joint.name not in used}
    if not gone:
        return
    passing = [t for t in spec.tendons if any(_joint_of(t.path[i]) in gone for i in range(len(t.path)))]
    joints, tendons = gone - {""}, {tendon.name for tendon in passing} - {""}  # names of other kinds of things may be the same
    equalities = {mujoco.mjtEq.mjEQ_JOINT: joints, mujoco.mjtEq.mjEQ_TENDON: tendons}
    drives = {mujoco.mjtTrn.mjTRN_JOINT: joints, mujoco.mjtTrn.mjTRN_JOINTINPARENT: joints, mujoco.mjtTrn.mjTRN_TENDON: tendons}
    for equality in [e for e in spec.equalities if {e.name1, e.name2} & equalities.get(e.type, set())]:
        spec.delete(equality)
    for actuator in [a for a in spec.actuators if a.target in drives.get(a.trntype, set())]:
        spec.delete(actuator)
    for tendon in passing:
        spec.delete(tendon)
    for joint in [j for j in spec.joints if j.name in gone]:
        spec.delete(joint)


def _joint_of(passed: Any) -> str | None:
    """The name of what a tendon passes, if that is a joint."""
    return passed.target.name if passed.type == mujoco.mjtWrap.mjWRAP_JOINT else None


def _drive_arm(spec: mujoco.MjSpec, robot: Robot) -> None:
    """A torque motor a joint. Control makes up for gravity itself, so nothing else may: neither the model's own compensation nor
    springs."""
    for body in spec.bodies:
        body.gravcomp = 0.0
    limits = dict(zip(robot.joints, robot.torque_limits, strict=True))
    for actuator in list(spec.actuators):
        if actuator.target in limits:
            actuator.set_to_motor()
            actuator.gear = [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]  # its force is the joint's torque
            actuator.forcerange = actuator.ctrlrange = [-limits[actuator.target], limits[actuator.target]]
        elif actuator.name != robot.gripper_actuator:
            spec.delete(actuator)
    driven = {actuator.target for actuator in spec.actuators}
    for name in [n for n in robot.joints if n not in driven]:
        limit = limits[name]
        motor = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        motor.set_to_motor()
        motor.forcerange = motor.ctrlrange = [-limit, limit]
    for name in (*robot.joints, *robot.fingers):
        joint = spec.joint(name)
        if joint.armature == 0.0:
            joint.armature = ARMATURE
        if name in robot.joints:
            joint.stiffness = np.zeros_like(joint.stiffness)  # of a polynomial
            joint.actfrclimited = mujoco.mjtLimited.mjLIMITED_FALSE  # the robot's own limits are the motors'
        if name in robot.fingers or joint.type != mujoco.mjtJoint.mjJNT_HINGE:
            continue
        unsaid = joint.limited == mujoco.mjtLimited.mjLIMITED_AUTO and joint.range[0] >= joint.range[1]
        if unsaid or joint.limited == mujoco.mjtLimited.mjLIMITED_FALSE:  # it turns far enough: planning needs bounds
            far = float(np.degrees(UNLIMITED)) if spec.compiler.degree else UNLIMITED
            joint.limited, joint.range = mujoco.mjtLimited.mjLIMITED_TRUE, [-far, far]


def _drive_gripper(spec: mujoco.MjSpec, robot: Robot) -> None:
    """Position control of the fingers' opening, from 0 to `FULL_CTRL`; as shipped, most press too little or not at all."""
    if robot.gripper_actuator is not None:
        _drive(spec.actuator(robot.gripper_actuator), *robot.actuator_travel)
    else:
        for name, shut, wide in zip(robot.fingers, robot.finger_shut, robot.finger_open, strict=True):
            # the model's own limit may be that of a gentle controller
            spec.joint(name).actfrclimited = mujoco.mjtLimited.mjLIMITED_FALSE
            actuator = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
            _drive(actuator, shut, wide, share=0.5)
    if not any({e.name1, e.name2} == set(robot.fingers) for e in spec.equalities):
        _gear(spec, robot)


def _drive(actuator: mujoco.MjsActuator, shut: float, wide: float, share: float = 1.0) -> None:
    """Make an actuator hold its length between `shut` and `wide` [m], with a share of the gripper's force."""
    kp, kv, force = share * GRIPPER_KP, share * GRIPPER_KV, share * GRIPPER_FORCE
    shut -= np.sign(wide - shut) * BEYOND  # thin walls, too, are held with force
    actuator.gaintype, actuator.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_AFFINE
    actuator.dyntype = mujoco.mjtDyn.mjDYN_NONE
    actuator.gainprm[:3] = [kp * (wide - shut) / FULL_CTRL, 0.0, 0.0]
    actuator.biasprm[:3] = [kp * shut, -kp, -kv]
    actuator.ctrlrange = [0.0, FULL_CTRL]
    actuator.forcerange = [-force, force]


def _gear(spec: mujoco.MjSpec, robot: Robot) -> None:
    """Both fingers move alike, as a parallel gripper's do; without it a thing held could be pushed to and fro between them."""
    first, second = robot.fingers
    gear = spec.add_equality(type=mujoco.mjtEq.mjEQ_JOINT, objtype=mujoco.mjtObj.mjOBJ_JOINT, name1=second, name2=first)
    ratio = robot.finger_signs[0] * robot.finger_signs[1]
    gear.data[:2] = [robot.finger_shut[1] - ratio * robot.finger_shut[0], ratio]
    gear.solref = [0.005, 1.0]
    gear.solimp = [0.95, 0.99, 0.001, 0.5, 2.0]


def _grip(spec: mujoco.MjSpec, finger: mujoco.MjsBody, robot: Robot) -> None:
    """Make the finger's contacts stiff and rough, and give it the robot's pad, if that has one: the primitive shapes that touched
    before are still seen, and weigh what they did."""
    if robot.pad_pos is not None:
        for geom in [g for g in finger.geoms if g.type != mujoco.mjtGeom.mjGEOM_MESH]:
            geom.contype = geom.conaffinity = 0
        box = mujoco.mjtGeom.mjGEOM_BOX
        finger.add_geom(type=box, pos=robot.pad_pos, size=robot.pad_half, mass=0.0, group=3)
    for geom in finger.geoms:
        geom.friction = [1.5, 0.02, 0.0005]
        geom.condim = 4
        geom.priority = 1
        geom.solref = [0.01, 1.0]
        geom.solimp = [0.95, 0.99, 0.001, 0.5, 2.0]
