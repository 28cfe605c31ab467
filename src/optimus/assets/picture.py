"""A picture of one thing by itself."""

from __future__ import annotations

import io

import mujoco
import numpy as np
from numpy.typing import NDArray
from PIL import Image

from optimus.objects.shapes import Shape
from optimus.spec import add_shape, physics

SIZE = 160
FOVY, AZIMUTH, ELEVATION = 30.0, 145.0, -22.0
"""Of the camera [degrees]."""


def picture(shape: Shape, size: int = SIZE) -> NDArray[np.uint8]:
    """The thing as it stands, `(size, size, 3)`, filling the frame whatever its size."""
    spec = mujoco.MjSpec()
    physics(spec)
    spec.visual.headlight.ambient, spec.visual.headlight.diffuse = [0.45] * 3, [0.5] * 3
    spec.visual.headlight.specular = [0.1] * 3
    spec.visual.map.znear = 0.01
    sky = spec.add_texture(name="sky", type=mujoco.mjtTexture.mjTEXTURE_SKYBOX, width=8, height=48)
    sky.builtin, sky.rgb1 = mujoco.mjtBuiltin.mjBUILTIN_FLAT, [0.96, 0.96, 0.97]
    spec.worldbody.add_light(pos=[-0.4, -0.5, 1.0], dir=[0.4, 0.5, -1.0], diffuse=[0.5, 0.5, 0.5], castshadow=False)
    add_shape(spec, spec.worldbody.add_body(name="thing"), shape)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    camera = mujoco.MjvCamera()
    radius = float(np.linalg.norm(shape.half_extents))
    camera.distance = 1.15 * radius / np.sin(np.radians(FOVY / 2))
    camera.azimuth, camera.elevation = AZIMUTH, ELEVATION
    model.vis.global_.fovy = FOVY
    with mujoco.Renderer(model, size, size) as renderer:
        renderer.update_scene(data, camera)
        return renderer.render()


def png(pixels: NDArray[np.uint8]) -> bytes:
    """The pixels as a PNG file."""
    buffer = io.BytesIO()
    Image.fromarray(pixels).save(buffer, format="PNG", optimize=True)
    return buffer.getvalue()
