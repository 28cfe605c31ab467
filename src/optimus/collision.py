"""Is this configuration free, and if not, what is in the way."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from optimus.se3 import Array, Pose
from optimus.state import State
from optimus.world import World, run_of

ROBOT_DEPTH = 0.0005
"""Contacts of the robot shallower than this are touches, not collisions [m]."""
HELD_DEPTH = 0.003
"""Likewise of what is held with what is below, on which it rests when it is taken and when it is let go [m] ..."""
ASIDE_DEPTH = 0.001
"""... and with what is beside it [m]."""
UPRIGHT = 0.7
"""The least vertical component of a contact's normal that is still of something below."""

BOX_SLACK = 0.003
"""The tcp may be this far outside the scene's box [m]."""


@dataclass(frozen=True)
class Blocked:
    """Why a configuration is not free: the two things that meet (`robot` for any link)."""

    a: str
    b: str


class CollisionChecker:
    """Collision queries against a state's surroundings. Holds one scratch `MjData`."""

    def __init__(self, world: World) -> None:
        self.world = world
        self._data = mujoco.MjData(world.model)
        self.effort = 0
        """Configurations checked so far."""
        bodies = world.model.geom_bodyid
        self._robot_geom = np.isin(bodies, list(world.robot_bodies))
        self._finger_geom = np.isin(bodies, [*world.finger_bodies, world.hand_body])
        self._door_geom = np.isin(bodies, [world.body_ids[door.name] for door in world.scene.doors])
        self._held_geom = np.zeros_like(self._robot_geom)
        self._held: tuple[int, Pose] | None = None
        self._bar_geom = -1
        self._low, self._high = [x - BOX_SLACK for x in world.scene.low], [x + BOX_SLACK for x in world.scene.high]
        self._arm_qpos = run_of(world.arm_qpos)

    def look_at(self, state: State, pulled: str | None = None) -> None:
        """Take the surroundings, the hand's opening and what it holds from `state`; the queries then vary only `q`.

        `pulled` is a door whose bar the fingers have hold of: they may touch it, and it may touch nothing else."""
        self.world.write_qpos(self._data, state)
        self._held, self._bar_geom = None, -1
        self._held_geom[:] = False
        if pulled is not None:
            self._held_geom = self.world.model.geom_bodyid == self.world.body_ids[pulled]
            self._bar_geom = self.world.bar_geoms[pulled]
        if state.held is not None:
            self._held = (self.world.movable_qpos[state.held.name], state.held.tcp_from_object)
            self._held_geom = self.world.model.geom_bodyid == self.world.body_ids[state.held.name]

    def check(self, q: Array) -> Blocked | None:
        """None if `q` `(dof,)` [rad] is free, else one pair that meets."""
        self.effort += 1
        data, model = self._data, self.world.model
        data.qpos[self._arm_qpos] = q
        mujoco.mj_kinematics(model, data)
        if self._held is not None:
            at, tcp_from_object = self._held
            pose = self.world.tcp(data) @ tcp_from_object
            data.qpos[at : at + 3], data.qpos[at + 3 : at + 7] = pose.pos, pose.quat
            mujoco.mj_kinematics(model, data)
        mujoco.mj_collision(model, data)
        return self._worst() or self._outside()

    def _outside(self) -> Blocked | None:
        """The controller keeps the hand within the scene's box: no path may leave it."""
        tcp = self._data.site_xpos[self.world.tcp_site].tolist()
        inside = all(low <= x <= high for x, low, high in zip(tcp, self._low, self._high, strict=True))
        return None if inside else Blocked("robot", "the workspace's edge")

    def _worst(self) -> Blocked | None:
        contact, n = self._data.contact, self._data.ncon
        if n == 0:
            return None
        depth = -contact.dist[:n]
        if depth.max() <= ROBOT_DEPTH:  # no limit is lower
            return None
        geoms = contact.geom[:n]
        robot, held = self._robot_geom[geoms], self._held_geom[geoms]
        if not robot.any() and not held.any():
            return None
        with_held = held.any(axis=1)
        gripped = with_held & self._finger_geom[geoms].any(axis=1)
        if self._bar_geom >= 0:  # of a door, only the bar is there to be gripped
            gripped &= (geoms == self._bar_geom).any(axis=1)
        resting = (np.abs(contact.frame[:n, 2]) > UPRIGHT) & ~self._door_geom[geoms].any(axis=1)  # nothing rests on a door
        limit = np.where(with_held & (self._bar_geom < 0), np.where(resting, HELD_DEPTH, ASIDE_DEPTH), ROBOT_DEPTH)
        bad = (robot | held).any(axis=1) & ~gripped & (depth > limit)
        if not bad.any():
            return None
        a, b = geoms[int(np.flatnonzero(bad)[0])]
        return Blocked(self._name(int(a)), self._name(int(b)))

    def _name(self, geom: int) -> str:
        return self.world.body_names.get(int(self.world.model.geom_bodyid[geom]), "robot")
