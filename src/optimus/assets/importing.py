"""Meshes that somebody else made: read, repaired, stood up, and prepared like our own."""

from __future__ import annotations

import re
from collections.abc import Iterable
from concurrent.futures import BrokenExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import trimesh

from optimus.assets.acronym import GraspFile, read_grasps
from optimus.assets.antipodal import Candidate
from optimus.assets.convex import union_of_pieces
from optimus.assets.thing import HEAVIEST, Facts, Thing, prepare
from optimus.errors import AssetError, OptimusError, require_positive
from optimus.objects.shapes import Grasp, Rgba
from optimus.se3 import Pose

SUFFIXES = (".obj", ".stl", ".ply", ".glb", ".gltf", ".off")
DENSITY = 300.0
"""Of a thing about the house, which is mostly hollow, where nothing is said [kg/m^3]."""
LIGHTEST = 0.02
"""[kg]; lighter things are made this heavy unless a mass is given."""
FRICTION = 0.8
GREY: Rgba = (0.62, 0.62, 0.66, 1.0)
MARGIN = np.radians(10.0)
"""A thing stands as modelled if it can be tilted this far without falling over [rad]."""
GENERIC = {"mesh", "model", "textured", "visual", "scene", "object", "collision"}
"""File names that say nothing: the folder's name is taken then."""
Up = Literal["auto", "x", "y", "z"]


PATIENCE = 150.0
"""With one mesh [s of CPU]; most take 5 to 10."""


@dataclass(frozen=True)
class Wish:
    """What the user says of the meshes to be added."""

    name: str | None = None
    category: str = "own"
    mass: float | None = None
    """[kg]"""
    density: float | None = None
    """[kg/m^3]"""
    scale: float = 1.0
    """Metres per unit of the file."""
    up: Up = "auto"
    friction: float = FRICTION

    def __post_init__(self) -> None:
        require_positive(mass=self.mass, density=self.density, scale=self.scale, friction=self.friction)
        if self.mass is not None and self.density is not None:
            raise OptimusError("the mass decides the density: say one of them")
        for what, name in (("name", self.name), ("category", self.category)):
            if name is not None and not re.fullmatch(r"[a-z0-9][a-z0-9_-]*", name):
                raise OptimusError(f"{name!r} cannot be an object's {what}: small letters, digits, - and _ can")


def meshes_in(paths: Iterable[Path]) -> list[Path]:
    """The mesh files among `paths`, folders being searched; `AssetError` names what is no mesh or not there."""
    found: list[Path] = []
    for path in paths:
        if path.is_dir():
            found += sorted(p for p in path.rglob("*") if p.suffix.lower() in SUFFIXES)
        elif not path.exists():
            raise AssetError(f"{path}: no such file")
        elif path.suffix.lower() not in SUFFIXES:
            raise AssetError(f"{path} is not a mesh; readable are {', '.join(SUFFIXES)}")
        else:
            found.append(path)
    if not found:
        raise AssetError(f"no mesh there; readable are {', '.join(SUFFIXES)}")
    return found


def name_for(path: Path) -> str:
    """A name from a file's."""
    stem = path.parent.name if path.stem.lower() in GENERIC else path.stem
    return re.sub(r"[^a-z0-9]+", "-", stem.lower()).strip("-") or "object"


def imported(path: Path, wish: Wish) -> Thing:
    """A thing made of somebody's mesh file; `AssetError` says why it cannot be used."""
    mesh, rgba = read_mesh(path)
    mesh.apply_scale(wish.scale)
    solid = repaired(mesh)
    solid.apply_transform(stood_up(solid, wish.up))
    return prepare(solid, _facts(wish, wish.name or name_for(path), solid, rgba, path.name))


def whole(made: Thing | Exception) -> Thing:
    """What `each_apart` gave back for a mesh; `AssetError` if it is not a thing."""
    if isinstance(made, BrokenExecutor):
        trouble = f"makes the convex decomposition crash, or go on for more than {PATIENCE:g} s of CPU"
        raise AssetError(f"{trouble}: its surface may cut itself; mend or simplify it")
    if isinstance(made, Exception):
        raise made
    return made


def read_mesh(path: Path) -> tuple[trimesh.Trimesh, Rgba]:
    """All triangles of a file as one mesh, in the file's units, and its main colour."""
    try:
        scene = trimesh.load_scene(path)
        mesh = scene.to_mesh()
    except Exception as error:  # readers of many formats raise as they please
        raise AssetError(f"{path} cannot be read as a mesh: {error}") from error
    if len(mesh.faces) == 0 or not np.isfinite(mesh.vertices).all():
        raise AssetError(f"{path} holds no triangles, or points that are no numbers")
    return mesh, _colour(mesh)


def _colour(mesh: trimesh.Trimesh) -> Rgba:
    """Of its material or its faces; grey where it has none."""
    visual: Any = mesh.visual
    try:
        seen = visual.to_color() if hasattr(visual, "to_color") else visual
        r, g, b, a = (float(c) / 255 for c in np.asarray(seen.main_color))
    except (AttributeError, ValueError, IndexError, TypeError):
        return GREY
    return (r, g, b, a) if seen.defined else GREY


def repaired(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    """The same surface closed, its faces outward. Closed bodies that overlap, as many meshes are put together, become one: faces
    inside it would mislead grasps, masses and the decomposition alike. What cannot be mended becomes the union of its convex
    pieces."""
    mended = mesh.copy()
    mended.merge_vertices(merge_tex=True, merge_norm=True)
    mended.update_faces(mended.nondegenerate_faces() & mended.unique_faces())
    mended.remove_unreferenced_vertices()
    bodies = list(mended.split(only_watertight=False))
    for body in bodies:
        trimesh.repair.fill_holes(body)
        trimesh.repair.fix_normals(body)
    if bodies and all(body.is_watertight and body.volume > 0 for body in bodies):
        return _plain(trimesh.boolean.union(bodies) if len(bodies) > 1 else bodies[0])
    if len(mended.faces) == 0 or np.linalg.matrix_rank(mended.vertices - mended.vertices.mean(axis=0), tol=1e-6) < 3:
        raise AssetError("is flat: it encloses nothing")
    solid = union_of_pieces(mended)
    if not solid.is_watertight or solid.volume <= 0:
        raise AssetError("is broken: its surface cannot be closed")
    return _plain(solid)


def _plain(mesh: trimesh.Trimesh) -> trimesh.Trimesh:
    return trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)


def stood_up(mesh: trimesh.Trimesh, up: Up) -> np.ndarray:
    """The rotation `(4, 4)` that makes the mesh stand: the axis that is said to point up; or as it is modelled (z up, then y up) if
    that is steady; or its likeliest resting pose."""
    if up != "auto":
        return _upright("xyz".index(up))
    for axis in (2, 1):
        turned = mesh.copy()
        turned.apply_transform(_upright(axis))
        if steadiness(turned) > MARGIN:
            return _upright(axis)
    poses, _ = trimesh.poses.compute_stable_poses(mesh.convex_hull)
    return np.asarray(poses[0])


def steadiness(mesh: trimesh.Trimesh) -> float:
    """How far a standing mesh can be tilted before it falls over [rad]; negative if it does not stand.

    Tilted by an angle `t` about the rim of a foot that reaches `b` to that side, its centre of mass, at the height `z`, comes to
    be at `b sin t + z cos t`. So its height when tilted by `MARGIN` tells `b`, however rough the foot is; what rolls has next to
    none.
    """
    around = np.linspace(0.0, 2 * np.pi, 72, endpoint=False)
    up = np.column_stack([np.sin(MARGIN) * np.cos(around), np.sin(MARGIN) * np.sin(around), np.full(72, np.cos(MARGIN))])
    from_lowest = np.asarray(mesh.center_mass) - np.asarray(mesh.convex_hull.vertices)
    z, tilted = float(from_lowest[:, 2].max()), (from_lowest @ up.T).max(axis=0)
    reach = (float(tilted.min()) - z * np.cos(MARGIN)) / np.sin(MARGIN)
    return float(np.arctan2(reach, z))


def _upright(axis: int) -> np.ndarray:
    """The rotation that turns that axis of the mesh into z."""
    return np.asarray(trimesh.geometry.align_vectors(np.eye(3)[axis], [0.0, 0.0, 1.0]) if axis != 2 else np.eye(4))


def _facts(wish: Wish, name: str, solid: trimesh.Trimesh, rgba: Rgba, source: str) -> Facts:
    mass = wish.mass or max(LIGHTEST, (wish.density or DENSITY) * float(solid.volume))
    if mass > HEAVIEST:
        raise AssetError(f"weighs {mass:.2f} kg; the hand lifts {HEAVIEST} kg (--mass and --scale change it)")
    return Facts(name, wish.category, name.replace("-", " "), mass, wish.friction, rgba, False, source)


def from_acronym(path: Path, meshes: Path, wish: Wish) -> Thing:
    """A thing whose grasps come from an ACRONYM file: its mesh is looked for under `meshes`, at the file's scale, and those of its
    grasps that it says held are verified again here."""
    found = read_grasps(path)
    mesh, rgba = read_mesh(_mesh_of(found, path, meshes))
    mesh.apply_scale(found.scale * wish.scale)
    solid = repaired(mesh)
    turn = stood_up(solid, wish.up)
    solid.apply_transform(turn)
    object_from_file = Pose.of(-solid.bounds.mean(axis=0)) @ Pose.from_matrix(turn[:3, 3], turn[:3, :3])
    said = [pose for pose, held in zip(found.grasps, found.held, strict=True) if held]
    given = [_candidate(object_from_file @ Pose(pose.pos * wish.scale, pose.quat), solid) for pose in said]
    facts = _facts(wish, wish.name or name_for(path), solid, rgba, path.name)
    return prepare(solid, facts, given)


def _mesh_of(found: GraspFile, path: Path, meshes: Path) -> Path:
    """The mesh that a grasp file names: by its whole path under `meshes`, else by its name anywhere there."""
    named = meshes / found.mesh
    if named.is_file():
        return named
    others = sorted(meshes.rglob(Path(found.mesh).name))
    if not others:
        raise AssetError(f"{path} is of {found.mesh}, which is not under {meshes}")
    return others[0]


def _candidate(object_from_tcp: Pose, solid: trimesh.Trimesh) -> Candidate:
    x, y, z = (float(v) for v in object_from_tcp.pos)
    qw, qx, qy, qz = (float(v) for v in object_from_tcp.quat)
    away = float(np.linalg.norm(object_from_tcp.pos - (solid.center_mass - solid.bounds.mean(axis=0))))
    return Candidate(Grasp((x, y, z), (qw, qx, qy, qz)), away)
