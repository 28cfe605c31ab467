"""From a `Scene` to MuJoCo's own description of it: bodies, contacts, cameras, light and the robot."""

from __future__ import annotations

import mujoco
import numpy as np

from optimus.objects.shapes import Mesh, Shape
from optimus.robots.model import robot_spec, root_body
from optimus.scene import Door, Scene
from optimus.se3 import look_at

PHYSICS_DT = 0.005
"""[s]; stable under implicitfast with torque control (docs/performance.md)."""

ROBOT_PREFIX = "robot/"
"""Before every name of the robot's model."""
BAR_SUFFIX = "/bar"
"""After a door's name: the geom of its bar."""
SEEN_GROUP, HIDDEN_GROUP = 2, 3
"""MuJoCo draws geoms of groups 0 to 2."""


KINDS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "mesh": mujoco.mjtGeom.mjGEOM_MESH,
}


def add_shape(spec: mujoco.MjSpec, body: mujoco.MjsBody, shape: Shape) -> None:
    """Give `body` the parts of a shape: what touches, what is seen, what it weighs."""
    for part in shape.parts:
        size = np.zeros(3)
        size[: len(part.size)] = part.size
        geom = body.add_geom(type=KINDS[part.kind], size=size, pos=part.pos, quat=part.quat, rgba=shape.rgba)
        # stiff, high-friction contacts: softer ones let a stack creep (docs/architecture.md, "Physics")
        geom.condim = 4
        geom.friction = [shape.friction, 0.02, 0.0005]
        geom.solref = [0.01, 1.0]
        geom.solimp = [0.95, 0.99, 0.001, 0.5, 2.0]
        geom.mass = shape.mass / len(shape.parts)
        if part.mesh is not None:
            geom.meshname = _mesh(spec, part.mesh)
        if shape.look is not None:
            geom.group = HIDDEN_GROUP
    if shape.look is not None:
        seen = body.add_geom(type=KINDS["mesh"], meshname=_mesh(spec, shape.look), rgba=shape.rgba, group=SEEN_GROUP)
        seen.contype, seen.conaffinity, seen.mass = 0, 0, 0.0
    if shape.inertia is not None:
        body.explicitinertial = True
        body.mass, body.ipos, body.iquat, body.inertia = shape.mass, shape.inertia.com, shape.inertia.quat, shape.inertia.moments


def _mesh(spec: mujoco.MjSpec, mesh: Mesh) -> str:
    """The name of a mesh, which is added once however many bodies have it."""
    name = f"mesh-{mesh.digest}"
    if all(known.name != name for known in spec.meshes):
        added = spec.add_mesh(name=name, uservert=mesh.vertices.ravel().tolist(), userface=mesh.faces.ravel().tolist())
        added.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX  # small hulls are too thin for the exact one
    return name


def _add_door(spec: mujoco.MjSpec, root: mujoco.MjsBody, door: Door) -> None:
    body = root.add_body(name=door.name, pos=door.hinge)
    hinge = body.add_joint(name=door.name, type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0.0, 0.0, door.turns])
    hinge.limited = mujoco.mjtLimited.mjLIMITED_TRUE
    hinge.range = [0.0, door.widest]
    # it stays where it is left
    hinge.damping = np.array([0.5, 0.0, 0.0])
    hinge.frictionloss = 0.2
    add_shape(spec, body, door.shape)
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


_OPTIONS = tuple(name for name in dir(mujoco.MjSpec().option) if not name.startswith("_"))


def world_spec(scene: Scene) -> mujoco.MjSpec:
    """The scene with its robot attached, ready to compile."""
    spec = mujoco.MjSpec()
    physics(spec)
    _set_picture(spec)
    _add_backdrop(spec)
    _add_things(spec, scene)
    for camera in scene.cameras:
        quat = look_at(camera.pos, camera.target)
        spec.worldbody.add_camera(name=camera.name, pos=camera.pos, quat=quat, fovy=camera.fovy)
    frame = spec.worldbody.add_frame(pos=scene.robot.base_pos, quat=scene.robot.base_quat)
    robot = robot_spec(scene.robot)
    for name in _OPTIONS:  # the world's hold for both; where they differ MuJoCo says so every time
        setattr(robot.option, name, getattr(spec.option, name))
    frame.attach_body(root_body(robot, scene.robot.hand), ROBOT_PREFIX, "")
    return spec


def physics(spec: mujoco.MjSpec) -> None:
    """How all worlds are simulated."""
    spec.compiler.degree = False
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.timestep = PHYSICS_DT
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 10.0


def _set_picture(spec: mujoco.MjSpec) -> None:
    spec.visual.headlight.ambient = [0.45, 0.45, 0.45]
    spec.visual.headlight.diffuse = [0.45, 0.45, 0.45]
    spec.visual.headlight.specular = [0.1, 0.1, 0.1]
    spec.visual.quality.offsamples = 0
    spec.visual.map.znear = 0.01
    spec.visual.map.zfar = 10.0


def _add_backdrop(spec: mujoco.MjSpec) -> None:
    """Sky, light, and a floor that is seen and not felt."""
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


def _add_things(spec: mujoco.MjSpec, scene: Scene) -> None:
    """Fixtures, movables (for the time being out of the way) and doors."""
    root = spec.worldbody
    for fixture in scene.fixtures:
        body = root.add_body(name=fixture.name, pos=fixture.pose.pos, quat=fixture.pose.quat)
        add_shape(spec, body, fixture.shape)
    for i, movable in enumerate(scene.movables):
        body = root.add_body(name=movable.name, pos=[0.5 + i, 3.0, 0.5])
        body.add_freejoint(name=movable.name)
        add_shape(spec, body, movable.shape)
    for door in scene.doors:
        _add_door(spec, root, door)
        for fixture in scene.fixtures:
            if fixture.door == door.name:  # it hangs on the box that it shuts
                spec.add_exclude(bodyname1=door.name, bodyname2=fixture.name)
