"""From a `Scene` to MuJoCo's own description of it: bodies, contacts, cameras, light, and the robot made fit for torque control."""

from __future__ import annotations

import mujoco
import numpy as np

from optimus.objects.shapes import Shape, Vec3
from optimus.robots import Robot, model_path
from optimus.scene import Door, Scene
from optimus.se3 import Array, quat_from_matrix

PHYSICS_DT = 0.005
"""[s]; stable under implicitfast with torque control (docs/performance.md)."""

HAND_PREFIX = "robot/"
BAR_SUFFIX = "/bar"
HIDDEN_GROUP = 4
"""Renderers leave this group of sites out: a marker at the tcp would tell the policy what no real camera shows."""


def look_at(pos: Vec3, target: Vec3, up: Vec3 = (0.0, 0.0, 1.0)) -> Array:
    """The quaternion `(4,) wxyz` of a MuJoCo camera (it looks along -z) at `pos` that sees `target` in its centre."""
    z = np.asarray(pos, float) - np.asarray(target, float)
    z /= np.linalg.norm(z)
    x = np.cross(up, z)
    x /= np.linalg.norm(x)
    return quat_from_matrix(np.column_stack([x, np.cross(z, x), z]))


def _add_shape(body: mujoco.MjsBody, shape: Shape) -> None:
    kinds = {
        "box": mujoco.mjtGeom.mjGEOM_BOX,
        "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
        "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    }
    for part in shape.parts:
        size = np.zeros(3)
        size[: len(part.size)] = part.size
        geom = body.add_geom(type=kinds[part.kind], size=size, pos=part.pos, quat=part.quat, rgba=shape.rgba)
        # stiff, high-friction contacts: softer ones let a stack creep (docs/architecture.md, "Physics")
        geom.condim = 4
        geom.friction = [1.0, 0.02, 0.0005]
        geom.solref = [0.01, 1.0]
        geom.solimp = [0.95, 0.99, 0.001, 0.5, 2.0]
        geom.mass = shape.mass / len(shape.parts)


def _add_door(root: mujoco.MjsBody, door: Door) -> None:
    body = root.add_body(name=door.name, pos=door.hinge)
    hinge = body.add_joint(name=door.name, type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0.0, 0.0, door.turns])
    hinge.limited = mujoco.mjtLimited.mjLIMITED_TRUE
    hinge.range = [0.0, door.widest]
    # it stays where it is left
    hinge.damping = np.array([0.5, 0.0, 0.0])
    hinge.frictionloss = 0.2
    _add_shape(body, door.shape)
    cylinder, bar = mujoco.mjtGeom.mjGEOM_CYLINDER, door.bar
    body.add_geom(
        name=door.name + BAR_SUFFIX,
        type=cylinder,
        size=[bar.radius, bar.length / 2, 0.0],
        pos=bar.pos,
        rgba=[0.75, 0.77, 0.80, 1.0],
        mass=0.1,
        condim=4,
        friction=[1.0, 0.02, 0.0005],
    )


def _robot_spec(robot: Robot) -> mujoco.MjSpec:
    """The robot's model with torque motors, a strong gripper, grippy pads, a tcp site and a wrist camera."""
    spec = mujoco.MjSpec.from_file(str(model_path(robot)))
    for key in list(spec.keys):
        spec.delete(key)
    for light in list(spec.lights):
        spec.delete(light)
    arm = set(robot.joints)
    for actuator in spec.actuators:
        if actuator.target in arm:
            limit = robot.torque_limits[robot.joints.index(actuator.target)]
            actuator.set_to_motor()
            actuator.forcerange = actuator.ctrlrange = [-limit, limit]
        elif actuator.name == robot.gripper_actuator:
            # as shipped the fingers press with 1 N; ctrl stays 0..255 over the finger travel
            kp, kv = 2000.0, 300.0
            actuator.gainprm[:3] = [kp * robot.finger_travel / 255.0, 0.0, 0.0]
            actuator.biasprm[:3] = [0.0, -kp, -kv]
            actuator.forcerange = [-60.0, 60.0]
    for name in robot.finger_bodies:
        for geom in [g for g in spec.body(name).geoms if g.type == mujoco.mjtGeom.mjGEOM_BOX]:
            spec.delete(geom)
        box = mujoco.mjtGeom.mjGEOM_BOX
        spec.body(name).add_geom(type=box, pos=robot.pad_pos, size=robot.pad_half, mass=0.0, group=3)
        for geom in spec.body(name).geoms:
            geom.friction = [1.5, 0.02, 0.0005]
            geom.condim = 4
            geom.priority = 1
            geom.solref = [0.01, 1.0]
            geom.solimp = [0.95, 0.99, 0.001, 0.5, 2.0]
    hand = spec.body(robot.hand)
    hand.add_site(name="tcp", pos=robot.tcp, group=HIDDEN_GROUP)
    up = (1.0, 0.0, 0.0)
    hand.add_camera(
        name="eye_in_hand",
        pos=robot.camera_pos,
        quat=look_at(robot.camera_pos, robot.camera_target, up),
        fovy=robot.camera_fovy,
    )
    return spec


def world_spec(scene: Scene) -> mujoco.MjSpec:
    """The scene with its robot attached, ready to compile."""
    spec = mujoco.MjSpec()
    spec.compiler.degree = False
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.timestep = PHYSICS_DT
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10.0
    spec.visual.headlight.ambient = [0.45, 0.45, 0.45]
    spec.visual.headlight.diffuse = [0.45, 0.45, 0.45]
    spec.visual.headlight.specular = [0.1, 0.1, 0.1]
    spec.visual.quality.offsamples = 0
    spec.visual.map.znear = 0.01
    spec.visual.map.zfar = 10.0
    sky = spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        width=32,
        height=192,
    )
    sky.rgb1, sky.rgb2 = [0.86, 0.90, 0.94], [0.70, 0.76, 0.82]
    root = spec.worldbody
    root.add_light(pos=[0.3, -0.6, 2.0], dir=[0.1, 0.3, -1.0], diffuse=[0.4, 0.4, 0.4], castshadow=False)
    root.add_geom(
        name="floor",
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[3, 3, 0.1],
        pos=[0, 0, -0.8],
        rgba=[0.93, 0.94, 0.95, 1],
        contype=0,
        conaffinity=0,
    )
    for fixture in scene.fixtures:
        body = root.add_body(name=fixture.name, pos=fixture.pose.pos, quat=fixture.pose.quat)
        _add_shape(body, fixture.shape)
    for i, movable in enumerate(scene.movables):
        body = root.add_body(name=movable.name, pos=[0.5 + i, 3.0, 0.5])
        body.add_freejoint(name=movable.name)
        _add_shape(body, movable.shape)
    for door in scene.doors:
        _add_door(root, door)
        for fixture in scene.fixtures:
            if fixture.door == door.name:  # it hangs on the box that it shuts
                spec.add_exclude(bodyname1=door.name, bodyname2=fixture.name)
    for camera in scene.cameras:
        quat = look_at(camera.pos, camera.target)
        root.add_camera(name=camera.name, pos=camera.pos, quat=quat, fovy=camera.fovy)
    frame = root.add_frame()
    frame.attach_body(_robot_spec(scene.robot).worldbody.first_body(), HAND_PREFIX, "")
    return spec
