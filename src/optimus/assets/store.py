"""Where prepared things lie: a folder each, with what it is (JSON), its meshes (npz), its grasps (HDF5) and a picture."""

from __future__ import annotations

import io
import json
import os
import shutil
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from optimus.assets.acronym import read_grasps, write_grasps
from optimus.errors import AssetError, StorageError
from optimus.objects.shapes import Grasp, Inertia, Mesh, Part, Shape

if TYPE_CHECKING:
    from optimus.assets.thing import Thing

FORMAT = 1
RECORD, MESHES, GRASPS, PICTURE = "object.json", "meshes.npz", "grasps.h5", "picture.png"


def save(thing: Thing, folder: Path, picture: bytes, replace: bool = True) -> None:
    """Write a thing to `folder`, whole or not at all; a thing that stood there is replaced, anything else is let be. Without
    `replace` one that somebody else has put there meanwhile stays."""
    if folder.exists() and not (folder / RECORD).is_file():
        raise StorageError(f"{folder} holds something that is not an object")
    aside = folder.with_name(f".{folder.name}.tmp-{os.getpid()}")
    try:
        shutil.rmtree(aside, ignore_errors=True)
        aside.mkdir(parents=True)
        _write(thing, aside, picture)
        if replace:
            shutil.rmtree(folder, ignore_errors=True)
        try:
            aside.replace(folder)
        except OSError:
            if replace or not (folder / RECORD).is_file():
                raise
    except OSError as error:
        raise StorageError(f"cannot write {folder}: {error.strerror or error}") from error
    finally:
        shutil.rmtree(aside, ignore_errors=True)


def _write(thing: Thing, folder: Path, picture: bytes) -> None:
    shape = thing.shape
    assert shape.look is not None and shape.inertia is not None
    meshes = {"look": shape.look, **{f"part{k:02d}": p.mesh for k, p in enumerate(shape.parts) if p.mesh is not None}}
    arrays = {f"{n}_{kind}": getattr(m, kind) for n, m in meshes.items() for kind in ("vertices", "faces")}
    buffer = io.BytesIO()
    np.savez_compressed(buffer, **arrays)
    (folder / MESHES).write_bytes(buffer.getvalue())
    (folder / PICTURE).write_bytes(picture)
    record = {
        "format": FORMAT,
        **asdict(thing.facts),
        "half_extents": shape.half_extents,
        "size": [2 * half for half in shape.half_extents],
        "rest": {"speed": thing.rest[0], "lean": thing.rest[1]},
        "inertia": asdict(shape.inertia),
        "watertight": thing.watertight,
        "volume": thing.volume,
        "parts": len(shape.parts),
        "grasps": len(shape.grasps),
        "grasps_from_above": thing.from_above,
        "grasps_from_the_side": thing.from_the_side,
    }
    (folder / RECORD).write_text(json.dumps(record, indent=2) + "\n")
    about = {"file": f"{thing.facts.name}/{MESHES}", "scale": 1.0, "mass": thing.facts.mass, "friction": thing.facts.friction}
    about |= {"volume": thing.volume, "com": shape.inertia.com, "density": thing.facts.mass / thing.volume}
    write_grasps(folder / GRASPS, shape.grasps, thing.outcomes, about)


def record(folder: Path) -> dict[str, Any]:
    """What the folder's JSON says; `AssetError` if it is none of ours."""
    try:
        found = json.loads((folder / RECORD).read_text())
    except (OSError, ValueError) as error:
        raise AssetError(f"{folder} holds no prepared object: {error}") from error
    if not isinstance(found, dict) or found.get("format") != FORMAT:
        raise AssetError(f"{folder / RECORD}: not of format {FORMAT}")
    return found


def load(folder: Path) -> Shape:
    """The shape of a prepared thing, with its grasps."""
    about = record(folder)
    try:
        with np.load(folder / MESHES, allow_pickle=False) as arrays:
            read = {n: _read(arrays, n) for n in ("look", *(f"part{k:02d}" for k in range(about["parts"])))}
        inertia = {k: tuple(v) for k, v in about["inertia"].items()}
        found = read_grasps(folder / GRASPS)
        return Shape(
            kind=about["name"],
            parts=tuple(Part("mesh", mesh=mesh) for name, mesh in read.items() if name != "look"),
            half_extents=tuple(about["half_extents"]),
            mass=float(about["mass"]),
            rgba=tuple(about["rgba"]),
            grasps=tuple(_grasp(pose.pos, pose.quat) for pose, held in zip(found.grasps, found.held, strict=True) if held),
            symmetric=bool(about["symmetric"]),
            friction=float(about["friction"]),
            look=read["look"],
            inertia=Inertia(**inertia),
            verified=True,
        )
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise AssetError(f"{folder} is damaged: {error}") from error


def _read(arrays: Any, name: str) -> Mesh:
    return Mesh(np.asarray(arrays[f"{name}_vertices"], float), np.asarray(arrays[f"{name}_faces"], np.int32))


def _grasp(pos: np.ndarray, quat: np.ndarray) -> Grasp:
    x, y, z = (float(v) for v in pos)
    qw, qx, qy, qz = (float(v) for v in quat)
    return Grasp((x, y, z), (qw, qx, qy, qz))
