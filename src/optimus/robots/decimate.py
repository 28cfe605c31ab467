"""Make a robot's model fast to draw: fewer triangles in what is seen, not one changed in what is touched."""

import itertools
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np

from optimus.errors import AssetError

VERSION = 1  # part of the cache's key: raise it whenever this file writes something else
FACES = 400  # a mesh; no difference is seen against the full meshes at 84 x 84, at 100 there is one

CHANGES = """\
This folder is a copy of {upstream} ({license}, see LICENSE), changed by optimus:
- visual meshes reduced to at most {faces} triangles each (collision meshes are as they were)
- contacts between {pairs} excluded, as upstream does since 2025
"""


def prepare(folder: Path, entry: str, exclude: tuple[tuple[str, str], ...]) -> None:
    """Decimate the visual meshes in `folder` and exclude contacts between the pairs of bodies, in place."""
    path = folder / entry
    tree = ET.parse(path)
    root = tree.getroot()
    _exclude_contacts(root, exclude)
    compiler = root.find("compiler")
    mesh_folder = folder / (compiler.get("meshdir", "") if compiler is not None else "")
    for name in sorted(_visual_only(root)):
        _decimate(mesh_folder / name)
    ET.indent(tree)
    tree.write(path, encoding="unicode")


def _exclude_contacts(root: ET.Element, pairs: tuple[tuple[str, str], ...]) -> None:
    """The base is fixed to the world, so MuJoCo does not filter its contacts with the first link."""
    present = {frozenset((e.get("body1"), e.get("body2"))) for e in root.iter("exclude")}
    missing = [pair for pair in pairs if frozenset(pair) not in present]
    if missing:
        contact = ET.SubElement(root, "contact")
        for body1, body2 in missing:
            ET.SubElement(contact, "exclude", body1=body1, body2=body2)


def _visual_only(root: ET.Element) -> set[str]:
    """Mesh files drawn by a geom of class `visual` and used by no other."""
    meshes = [(mesh.get("name"), mesh.get("file", "")) for mesh in root.iter("mesh")]
    files = {name or Path(file).stem: file for name, file in meshes}
    seen: set[str] = set()
    touched: set[str] = set()
    for geom in root.iter("geom"):
        if name := geom.get("mesh"):
            (seen if geom.get("class") == "visual" else touched).add(files[name])
    return seen - touched


def _decimate(path: Path) -> None:
    """Rewrite an OBJ file with at most `FACES` triangles; normals are left to MuJoCo."""
    import fast_simplification

    points, faces = read_obj(path)
    if len(faces) > FACES:
        points, faces = fast_simplification.simplify(points, faces, target_count=FACES)
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in points]
    lines += [f"f {a} {b} {c}" for a, b, c in faces + 1]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """The points (n, 3) [m] and triangles (m, 3) of an OBJ file; points at the same place become one."""
    points: list[list[float]] = []
    faces: list[list[int]] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "v":
            points.append([float(x) for x in rest.split()[:3]])
        elif kind == "f":
            corners = [int(corner.split("/")[0]) - 1 for corner in rest.split()]
            faces += [[corners[0], b, c] for b, c in itertools.pairwise(corners[1:])]
    if not faces:
        raise AssetError(f"{path} holds no triangles")
    # exports repeat a point once a face; joined up, the simplifier can collapse the edges between faces
    unique, index = np.unique(np.asarray(points), axis=0, return_inverse=True)
    joined = index.reshape(-1)[np.asarray(faces)]
    degenerate = (joined == np.roll(joined, 1, axis=1)).any(axis=1)
    return unique, joined[~degenerate].astype(np.int32)
