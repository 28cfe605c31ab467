"""`Scene` (plain data) -> `World` (one compiled MuJoCo model, shared by physics, kinematics, collision and rendering)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import mujoco
import numpy as np

from optimus.errors import ModelError
from optimus.objects.shapes import Shape, Vec3
from optimus.robots import Robot, model_path
from optimus.se3 import Array, Pose, quat_from_matrix
from optimus.state import Held, State

PHYSICS_DT = 0.005
"""[s]; stable under implicitfast with torque control (docs/performance.md)."""

HAND_PREFIX = "robot/"
HIDDEN_GROUP = 4
"""Renderers leave this group of sites out: a marker at the tcp would tell the policy what no real camera shows."""


@dataclass(frozen=True)
class Fixture:
    """A thing that never moves."""

    name: str
    shape: Shape
    pos: Vec3
    yaw: float = 0.0

    @property
    def pose(self) -> Pose:
        return Pose.of(self.pos, (0.0, 0.0, self.yaw))


@dataclass(frozen=True)
class Movable:
    """A thing that can be picked up."""

    name: str
    shape: Shape


@dataclass(frozen=True)
class Camera:
    """A fixed camera: where it stands and what it looks at, in the base frame [m]; vertical field of view [deg]."""

    name: str
    pos: Vec3
    target: Vec3
    fovy: float = 45.0


@dataclass(frozen=True)
class Scene:
    """Everything that a model is built from. The base frame is the world frame; the table's top is z = 0."""

    robot: Robot
    fixtures: tuple[Fixture, ...]
    movables: tuple[Movable, ...]
    cameras: tuple[Camera, ...]

    def shape_of(self, name: str) -> Shape:
        for thing in (*self.movables, *self.fixtures):
            if thing.name == name:
                return thing.shape
        raise KeyError(name)

    @cached_property
    def movable_names(self) -> tuple[str, ...]:
        return tuple(m.name for m in self.movables)

    @cached_property
    def fixture_poses(self) -> dict[str, Pose]:
        return {f.name: f.pose for f in self.fixtures}


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


def _world_spec(scene: Scene) -> mujoco.MjSpec:
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
    for camera in scene.cameras:
        quat = look_at(camera.pos, camera.target)
        root.add_camera(name=camera.name, pos=camera.pos, quat=quat, fovy=camera.fovy)
    frame = root.add_frame()
    frame.attach_body(_robot_spec(scene.robot).worldbody.first_body(), HAND_PREFIX, "")
    return spec


class World:
    """A compiled scene: the one `MjModel` and the addresses of everything in it. Build with `compile_scene`."""

    def __init__(self, scene: Scene) -> None:
        try:
            self.model: mujoco.MjModel = _world_spec(scene).compile()
        except ValueError as error:
            raise ModelError(f"the scene does not compile: {error}") from error
        m, robot = self.model, scene.robot
        self.scene = scene
        joints = [m.joint(HAND_PREFIX + name) for name in robot.joints]
        fingers = [m.joint(HAND_PREFIX + name) for name in robot.fingers]
        self.arm_qpos = np.array([int(j.qposadr[0]) for j in joints])
        self.arm_dof = np.array([int(j.dofadr[0]) for j in joints])
        self.arm_range = np.array([j.range for j in joints])
        self.arm_ctrl = np.array([self._actuator_of(int(j.id)) for j in joints])
        self.finger_qpos = np.array([int(j.qposadr[0]) for j in fingers])
        self.gripper_ctrl = int(m.actuator(HAND_PREFIX + robot.gripper_actuator).id)
        self.tcp_site = int(m.site(HAND_PREFIX + "tcp").id)
        self.hand_body = int(m.body(HAND_PREFIX + robot.hand).id)
        self.finger_bodies = tuple(int(m.body(HAND_PREFIX + n).id) for n in robot.finger_bodies)
        self.movable_qpos = {n: int(m.joint(n).qposadr[0]) for n in scene.movable_names}
        self.movable_dof = {n: int(m.joint(n).dofadr[0]) for n in scene.movable_names}
        self.body_ids = {n: int(m.body(n).id) for n in (*scene.movable_names, *scene.fixture_poses)}
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
        return (*(c.name for c in self.scene.cameras), "robot0_eye_in_hand")

    def camera_id(self, name: str) -> int:
        model_name = HAND_PREFIX + "eye_in_hand" if name == "robot0_eye_in_hand" else name
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
        data.qpos[self.finger_qpos] = state.opening / 2
        for name, pose in state.poses.items():
            at = self.movable_qpos[name]
            data.qpos[at : at + 3] = pose.pos
            data.qpos[at + 3 : at + 7] = pose.quat

    def tcp(self, data: mujoco.MjData) -> Pose:
        """`base_from_tcp` as of the last kinematics."""
        return Pose.from_matrix(data.site_xpos[self.tcp_site].copy(), data.site_xmat[self.tcp_site].reshape(3, 3))

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
            opening=float(data.qpos[self.finger_qpos].sum()),
            poses=poses,
            held=Held(held[0], tcp.inverse @ poses[held[0]]) if held else None,
            touched=frozenset(touched),
            speeds=speeds,
            tcp=tcp,
        )

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
