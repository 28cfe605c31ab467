"""Seeded visual randomisation: light, colours, textures and cameras' poses; nothing that physics knows of."""

from __future__ import annotations

import colorsys
from collections.abc import Iterable, Sequence

import mujoco
import numpy as np

from optimus.scene import Scene
from optimus.se3 import quat_from_rotvec, quat_mul

HUE, SHADE = 0.03, 0.25
"""A movable thing keeps its colour's name: its hue (of 1) changes by at most this, saturation and value by at most this share."""
TEXTURED = 0.5
"""Probability that a fixture or the floor has a pattern."""
CAMERA_MOVES, CAMERA_TURNS, WRIST_SHARE = 0.02, 0.03, 0.2
"""Standard deviations of a camera's position [m] and rotation [rad]; the wrist's are this share of the others'."""
PIXELS = 64
"""Side of a pattern."""


def randomise(spec: mujoco.MjSpec, scene: Scene, rng: np.random.Generator) -> None:
    """Change how the world of `scene` looks before it is compiled. A function of the generator alone."""
    _light(spec, rng)
    for movable in scene.movables:
        _tint(spec.body(movable.name), rng)
    for thing in (*scene.fixtures, *scene.doors):
        _repaint(spec, spec.body(thing.name).geoms, thing.name, rng)
    _repaint(spec, [spec.geom("floor")], "floor", rng)
    for texture in spec.textures:
        if texture.type == mujoco.mjtTexture.mjTEXTURE_SKYBOX:
            texture.rgb1, texture.rgb2 = rng.uniform(0.4, 1.0, 3), rng.uniform(0.4, 1.0, 3)
    fixed = {camera.name for camera in scene.cameras}
    for camera in spec.cameras:
        _nudge(camera, 1.0 if camera.name in fixed else WRIST_SHARE, rng)


def _light(spec: mujoco.MjSpec, rng: np.random.Generator) -> None:
    spec.visual.headlight.ambient = [rng.uniform(0.3, 0.55)] * 3
    spec.visual.headlight.diffuse = [rng.uniform(0.25, 0.55)] * 3
    for light in spec.lights:
        light.pos = np.array([*rng.uniform(-1.0, 1.0, 2), rng.uniform(1.2, 2.2)])
        light.dir = np.array([*rng.uniform(-0.4, 0.4, 2), -1.0])
        light.diffuse = rng.uniform(0.2, 0.6) * rng.uniform(0.85, 1.0, 3)


def _tint(body: mujoco.MjsBody, rng: np.random.Generator) -> None:
    hue, (saturation, value) = rng.uniform(-HUE, HUE), 1.0 + rng.uniform(-SHADE, SHADE, 2)
    for geom in body.geoms:
        h, s, v = colorsys.rgb_to_hsv(*geom.rgba[:3])
        geom.rgba = [*colorsys.hsv_to_rgb((h + hue) % 1.0, min(1.0, s * saturation), min(1.0, v * value)), geom.rgba[3]]


def _repaint(spec: mujoco.MjSpec, geoms: Iterable[mujoco.MjsGeom], name: str, rng: np.random.Generator) -> None:
    """One colour, or one pattern of two, for all of them."""
    colours = [_pale(rng), _pale(rng)]
    material = _pattern(spec, name, colours, rng) if rng.uniform() < TEXTURED else None
    for geom in geoms:
        geom.rgba = [*colours[0], geom.rgba[3]]
        if material is not None:
            geom.material = material
            geom.rgba = [1.0, 1.0, 1.0, geom.rgba[3]]


def _pale(rng: np.random.Generator) -> tuple[float, float, float]:
    """A colour that no cube is mistaken against."""
    return colorsys.hsv_to_rgb(rng.uniform(), rng.uniform(0.0, 0.35), rng.uniform(0.35, 1.0))


def _pattern(spec: mujoco.MjSpec, name: str, colours: Sequence[Sequence[float]], rng: np.random.Generator) -> str:
    """The name of a new material: checks, a gradient, or one colour with specks of the other."""
    kinds = (mujoco.mjtBuiltin.mjBUILTIN_CHECKER, mujoco.mjtBuiltin.mjBUILTIN_GRADIENT, mujoco.mjtBuiltin.mjBUILTIN_FLAT)
    kind = kinds[int(rng.integers(len(kinds)))]
    texture = spec.add_texture(
        name=f"pattern/{name}", type=mujoco.mjtTexture.mjTEXTURE_2D, builtin=kind, width=PIXELS, height=PIXELS
    )
    texture.rgb1, texture.rgb2 = list(colours[0]), list(colours[1])
    if kind == mujoco.mjtBuiltin.mjBUILTIN_FLAT:
        texture.mark, texture.markrgb, texture.random = mujoco.mjtMark.mjMARK_RANDOM, list(colours[1]), 0.1
    material = spec.add_material(name=f"pattern/{name}")
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = texture.name
    material.texrepeat = [float(rng.integers(1, 6))] * 2
    return material.name


def _nudge(camera: mujoco.MjsCamera, share: float, rng: np.random.Generator) -> None:
    camera.pos = np.asarray(camera.pos) + share * CAMERA_MOVES * rng.normal(size=3)
    camera.quat = quat_mul(np.asarray(camera.quat), quat_from_rotvec(share * CAMERA_TURNS * rng.normal(size=3)))
