"""`Stage`: a scene in the browser, moved by writing positions; ghosts, marks and lines beside it."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence

import mujoco
import numpy as np
import viser

from optimus.se3 import Array
from optimus.task import Task
from optimus.view.meshes import Colour, Surface, surfaces
from optimus.world import World

SMOOTH_FROM = 200
"""Surfaces of that many triangles and more are curved: shaded smoothly."""
MARK_SCALE = 1.03
"""A mark is that much larger than what it marks."""
BACK = 1.4
"""A browser's window starts from that many times as far as pictures are taken: it is wide, and people turn it about."""
HALF_SEEN = 0.25
"""Opacity of ghosts."""

Rgb = tuple[int, int, int]


class Stage:
    """A world drawn in the browser. One at a time: a new one clears what was there."""

    def __init__(self, server: viser.ViserServer, world: World, task: Task) -> None:
        self.world, self._server, self._data = world, server, mujoco.MjData(world.model)
        self._surfaces = surfaces(world.model)
        self._extras: dict[str, list[viser.SceneNodeHandle]] = defaultdict(list)
        server.scene.reset()
        camera = task.people_camera
        server.scene.set_up_direction("+z")
        server.scene.configure_default_lights(cast_shadow=False)
        server.scene.configure_environment_map(environment_intensity=0.3)
        server.initial_camera.position = tuple(np.array(camera.target) + BACK * np.subtract(camera.pos, camera.target))
        server.initial_camera.look_at = camera.target
        self._frames = {body: self._frame(body) for body in sorted({s.body for s in self._surfaces})}
        for i, surface in enumerate(self._surfaces):
            self._add(f"/body{surface.body}/{i}", surface)

    def _frame(self, body: int) -> viser.FrameHandle:
        return self._server.scene.add_frame(f"/body{body}", show_axes=False)

    def _add(self, name: str, surface: Surface, colour: Colour | None = None, scale: float = 1.0) -> viser.SceneNodeHandle:
        *rgb, opacity = colour or surface.colour
        return self._server.scene.add_mesh_simple(
            name,
            surface.vertices.astype(np.float32),
            surface.faces,
            color=_rgb255(rgb),
            opacity=None if opacity >= 1 else opacity,
            flat_shading=len(surface.faces) < SMOOTH_FROM,
            side="double",
            scale=scale,
        )

    def show(self, qpos: Array) -> None:
        """Put everything where `qpos` `(nq,)` says."""
        with self._server.atomic():
            for body, frame in self._frames.items():
                position, quat = self._pose(qpos, body)
                frame.position, frame.wxyz = position, quat

    def _pose(self, qpos: Array, body: int) -> tuple[Array, Array]:
        if not np.array_equal(self._data.qpos, qpos) or not self._data.xquat.any():
            self._data.qpos[:] = qpos
            mujoco.mj_kinematics(self.world.model, self._data)
        return self._data.xpos[body].copy(), self._data.xquat[body].copy()

    def ghost(self, name: str, qpos: Array, colour: Rgb) -> None:
        """The arm as it is in `qpos` `(nq,)`, half seen, in one colour; without its foot, which is where it always is."""
        model = self.world.model
        parts = [s for s in self._surfaces if s.body in self.world.robot_bodies and model.body_weldid[s.body]]
        points, faces, offset = [], [], 0
        for part in parts:
            position, quat = self._pose(qpos, part.body)
            turn = np.empty(9)
            mujoco.mju_quat2Mat(turn, quat)
            points.append(part.vertices @ turn.reshape(3, 3).T + position)
            faces.append(part.faces + offset)
            offset += len(part.vertices)
        whole = Surface(0, (*(c / 255 for c in colour), HALF_SEEN), np.concatenate(points), np.concatenate(faces))  # pyright: ignore[reportArgumentType]
        self._extras["ghosts"].append(self._add(f"/ghosts/{name}", whole))

    def mark(self, body: str, colour: Rgb, text: str) -> None:
        """Wrap a thing of the scene in a colour, and say what it is."""
        number = self.world.body_ids[body]
        paint: Colour = (colour[0] / 255, colour[1] / 255, colour[2] / 255, 0.6)
        handles = [
            self._add(f"/body{number}/mark{i}", surface, paint, MARK_SCALE)
            for i, surface in enumerate(self._surfaces)
            if surface.body == number
        ]
        label = self._server.scene.add_label(f"/body{number}/text", text, position=(0.0, 0.0, 0.08))
        self._extras["marks"] += [*handles, label]

    def lines(self, kind: str, ends: Sequence[Array] | Array, colours: Iterable[Rgb], thickness: float = 0.003) -> None:
        """Straight lines `(n, 2, 3)` [m], each of its colour, in place of those of that kind before."""
        self.clear(kind)
        if len(ends) == 0:
            return
        paint = np.repeat(np.array(list(colours), np.uint8)[:, None], 2, axis=1)
        points = np.asarray(ends, np.float32)
        self._extras[kind].append(self._server.scene.add_line_segments(f"/{kind}", points, paint, thickness=thickness))

    def segments(self, kind: str) -> Array:
        """The lines of that kind, `(n, 2, 3)` [m]."""
        shown = [np.asarray(h.points, np.float64) for h in self._extras.get(kind, []) if isinstance(h, viser.LineSegmentsHandle)]
        return np.concatenate([np.empty((0, 2, 3)), *shown])

    def clear(self, kind: str) -> None:
        """Take away the `ghosts`, the `marks`, or the lines of a kind."""
        for handle in self._extras.pop(kind, []):
            handle.remove()

    def count(self, kind: str) -> int:
        """How many of them there are."""
        return len(self._extras.get(kind, []))


def _rgb255(rgb: Sequence[float]) -> Rgb:
    r, g, b = (round(255 * min(1.0, max(0.0, c))) for c in rgb)
    return (r, g, b)
