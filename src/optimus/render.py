"""Pictures of a world: the policies' 84 x 84 cameras, and larger ones for people."""

from __future__ import annotations

import os

# one software-rendering thread a process: rollouts are parallel across processes, and threads would fight (docs/performance.md)
os.environ.setdefault("MUJOCO_GL", "egl")
os.environ.setdefault("LP_NUM_THREADS", "1")

import mujoco
import numpy as np
from numpy.typing import NDArray

from optimus.scene import Camera, World


class Rig:
    """One off-screen renderer for a world. The GL context belongs to the process that made it."""

    def __init__(self, world: World, height: int, width: int | None = None, shadows: bool = False) -> None:
        self.world = world
        self._renderer = mujoco.Renderer(world.model, height, width or height)
        self._renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows
        self._renderer.scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = False
        self._option = mujoco.MjvOption()

    def image(self, data: mujoco.MjData, camera: str) -> NDArray[np.uint8]:
        """`(height, width, 3)` from a camera of the scene (or `robot0_eye_in_hand`); `data` must be up to date."""
        self._renderer.update_scene(data, self.world.camera_id(camera), self._option)
        return self._renderer.render()

    def view(self, data: mujoco.MjData, camera: Camera) -> NDArray[np.uint8]:
        """`(height, width, 3)` from a free camera."""
        free = mujoco.MjvCamera()
        offset = np.subtract(camera.target, camera.pos)
        free.type = mujoco.mjtCamera.mjCAMERA_FREE
        free.lookat[:] = camera.target
        free.distance = float(np.linalg.norm(offset))
        free.azimuth = float(np.degrees(np.arctan2(offset[1], offset[0])))
        free.elevation = float(np.degrees(np.arcsin(offset[2] / free.distance)))
        self._renderer.update_scene(data, free, self._option)
        return self._renderer.render()

    def close(self) -> None:
        self._renderer.close()


