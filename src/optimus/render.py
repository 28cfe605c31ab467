"""Pictures of a world: the policies' 84 x 84 cameras, and larger ones for people."""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise

import mujoco
import numpy as np
from numpy.typing import NDArray

from optimus.errors import ModelError
from optimus.objects.shapes import Rgba
from optimus.scene import Camera, Scene
from optimus.se3 import Array
from optimus.world import World


class Rig:
    """One off-screen renderer for a world. The GL context belongs to the thread that made it."""

    def __init__(self, world: World, height: int, width: int | None = None, shadows: bool = False) -> None:
        self.world = world
        try:
            self._renderer = mujoco.Renderer(world.model, height, width or height)
        except (mujoco.FatalError, ImportError, RuntimeError, AttributeError) as error:  # pyright: ignore[reportAttributeAccessIssue]
            remedy = "install Mesa's EGL (Debian: libegl1 libgl1-mesa-dri) or set MUJOCO_GL to a library you have"
            raise ModelError(f"no GL library for off-screen rendering: {error}; {remedy}") from error
        self._renderer.scene.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows
        self._renderer.scene.flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = False
        self._option = mujoco.MjvOption()

    def image(self, data: mujoco.MjData, camera: str) -> NDArray[np.uint8]:
        """`(height, width, 3)` from a camera of the scene (or `robot0_eye_in_hand`); `data` must be up to date."""
        self._renderer.update_scene(data, self.world.camera_id(camera), self._option)
        return self._renderer.render()

    def depth(self, data: mujoco.MjData, camera: str) -> NDArray[np.float32]:
        """`(height, width)` [m], along the camera's axis."""
        self._renderer.enable_depth_rendering()
        try:
            self._renderer.update_scene(data, self.world.camera_id(camera), self._option)
            return self._renderer.render()
        finally:
            self._renderer.disable_depth_rendering()

    def segmentation(self, data: mujoco.MjData, camera: str) -> NDArray[np.uint8]:
        """`(height, width)`: 1 + the index into `seen_names` of what is seen, 0 for the backdrop."""
        self._renderer.enable_segmentation_rendering()
        try:
            self._renderer.update_scene(data, self.world.camera_id(camera), self._option)
            geoms, kinds = np.moveaxis(self._renderer.render(), -1, 0)
        finally:
            self._renderer.disable_segmentation_rendering()
        return np.where(kinds == int(mujoco.mjtObj.mjOBJ_GEOM), self._numbers[geoms], 0).astype(np.uint8)

    @cached_property
    def _numbers(self) -> NDArray[np.uint8]:
        """The number of each geom in segmentation images; the last entry, which -1 finds, is the backdrop's."""
        names = seen_names(self.world.scene)
        bodies = {body: names.index(name) + 1 for body, name in self.world.body_names.items()}
        bodies |= dict.fromkeys(self.world.robot_bodies, len(names))
        return np.array([*(bodies.get(int(body), 0) for body in self.world.model.geom_bodyid), 0], np.uint8)

    def view(
        self, data: mujoco.MjData, camera: Camera, paths: tuple[tuple[Array, Rgba], ...] = ()
    ) -> NDArray[np.uint8]:
        """`(height, width, 3)` from a free camera, with polylines `(points (n, 3) [m], colour)` drawn into the scene."""
        free = mujoco.MjvCamera()
        offset = np.subtract(camera.target, camera.pos)
        free.type = mujoco.mjtCamera.mjCAMERA_FREE
        free.lookat[:] = camera.target
        free.distance = float(np.linalg.norm(offset))
        free.azimuth = float(np.degrees(np.arctan2(offset[1], offset[0])))
        free.elevation = float(np.degrees(np.arcsin(offset[2] / free.distance)))
        self._renderer.update_scene(data, free, self._option)
        for points, colour in paths:
            self._draw(points, colour)
        return self._renderer.render()

    def _draw(self, points: Array, colour: Rgba, radius: float = 0.0035) -> None:
        scene = self._renderer.scene
        for a, b in pairwise(points):
            if scene.ngeom >= scene.maxgeom:
                return
            geom = scene.geoms[scene.ngeom]
            kind = mujoco.mjtGeom.mjGEOM_CAPSULE
            mujoco.mjv_initGeom(geom, kind, np.zeros(3), np.zeros(3), np.zeros(9), np.array(colour, np.float32))
            mujoco.mjv_connector(geom, kind, radius, a, b)
            scene.ngeom += 1

    def close(self) -> None:
        """Free the GL context."""
        self._renderer.close()


def seen_names(scene: Scene) -> tuple[str, ...]:
    """What segmentation tells apart, in the order of its numbers from 1."""
    return (*scene.movable_names, *scene.fixture_poses, *(door.name for door in scene.doors), "robot")
