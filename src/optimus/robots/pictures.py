"""What a robot is drawn with: a mesh file of any format, as light meshes of one colour each; made once, then cached."""

from __future__ import annotations

import contextlib
import hashlib
import json
import shutil
import tempfile
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from optimus.objects.shapes import Rgba
from optimus.robots import obj
from optimus.robots.menagerie import cache_folder

VERSION = 1  # part of the cache's key: raise it whenever this file or `obj` writes something else
FACES_PER_METRE = 2500.0  # times the square root of a mesh's area [m], as for Menagerie's models
FEWEST = 40
RECORD = "parts.json"


@dataclass(frozen=True)
class Part:
    """A mesh of one colour, as an OBJ file in the source's own units; `rgba` is None where the source has no colours."""

    path: Path
    rgba: Rgba | None


def parts_of(path: Path, scale: float) -> tuple[Part, ...]:
    """The reduced meshes of a file, one a colour; `scale` [m per unit] says how large it will be seen.

    Raises whatever the reader of that format raises when it cannot read it (`ImportError` for one that is not installed).
    """
    key = hashlib.sha256(path.read_bytes() + f"{scale} {VERSION} {path.suffix}".encode()).hexdigest()[:20]
    folder = cache_folder() / "pictures" / key
    if not (folder / RECORD).is_file():
        folder = _build(path, scale, folder)
    record: list[dict[str, Any]] = json.loads((folder / RECORD).read_text(encoding="utf-8"))
    return tuple(Part(folder / part["file"], part["rgba"] and tuple(part["rgba"])) for part in record)


def _build(path: Path, scale: float, target: Path) -> Path:
    """Write the parts beside `target` and rename them into place; without a cache to write to, they stay in a scratch folder."""
    pieces = _pieces(path)
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        stage = Path(tempfile.mkdtemp(prefix=f".{target.name}-", dir=target.parent))
    except OSError:
        stage = _scratch() / target.name
        stage.mkdir(exist_ok=True)
        target = stage
    record = []
    for number, (rgba, mesh) in enumerate(pieces):
        count = max(FEWEST, round(FACES_PER_METRE * scale * float(mesh.areas.sum()) ** 0.5))
        obj.write(obj.reduce(mesh, count), stage / f"{number}.obj")
        record.append({"file": f"{number}.obj", "rgba": rgba})
    (stage / RECORD).write_text(json.dumps(record), encoding="utf-8")
    if stage != target:
        with contextlib.suppress(OSError):  # another process was first
            stage.replace(target)
        shutil.rmtree(stage, ignore_errors=True)
    return target


@lru_cache(maxsize=1)
def _scratch() -> Path:
    return Path(tempfile.mkdtemp(prefix="optimus-pictures-"))


def _pieces(path: Path) -> list[tuple[Rgba | None, obj.Mesh]]:
    """The triangles of a mesh file, joined by colour."""
    import trimesh

    scene = trimesh.load_scene(path)
    joined: dict[Rgba | None, list[obj.Mesh]] = {}
    for mesh in scene.dump():
        if isinstance(mesh, trimesh.Trimesh) and len(mesh.faces):
            joined.setdefault(_colour(mesh), []).append(_welded(mesh))
    return [(rgba, obj.join(meshes)) for rgba, meshes in joined.items()]


def _welded(mesh: Any) -> obj.Mesh:
    """With points at the same place made one: exports repeat them, and the simplifier cannot collapse across the seams."""
    points, index = np.unique(np.asarray(mesh.vertices).round(7), axis=0, return_inverse=True)
    corners = np.asarray(mesh.vertex_normals)[mesh.faces]
    faces = index.reshape(-1)[mesh.faces]
    solid = (faces != np.roll(faces, 1, axis=1)).all(axis=1)
    return obj.Mesh(points, faces[solid], corners[solid])


def _colour(mesh: Any) -> Rgba | None:
    material = getattr(mesh.visual, "material", None)
    if material is None:
        return None
    r, g, b, a = (float(c) / 255 for c in material.main_color)
    return (r, g, b, a)
