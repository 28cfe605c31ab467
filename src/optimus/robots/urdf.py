"""From a URDF file to MuJoCo's description: meshes found, pictures reduced, links without inertia given some."""

from __future__ import annotations

import logging
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco
import numpy as np

from optimus.errors import RobotFileError
from optimus.robots.paths import find_mesh
from optimus.robots.pictures import Part, parts_of

log = logging.getLogger(__name__)

COLLISION_FORMATS = {".stl", ".obj", ".msh"}
"""What MuJoCo reads itself."""
PREFIX = re.compile(r"[<\s]/?([A-Za-z_][\w.-]*):[A-Za-z_][\w.-]*[\s=>/]")
"""The namespace of an element or an attribute, before its colon."""
SHOWN_GROUP, HIDDEN_GROUP = 2, 3
"""MuJoCo's groups of geoms: which of them renderers draw."""
SPHERE_RADIUS = 0.03
"""Of the solid sphere that stands in for a link of which only the mass is given [m]."""
UNLIMITED = 2 * np.pi
"""The range of a continuous joint, to either side [rad]."""


def read_urdf(path: Path) -> mujoco.MjSpec:
    """The robot of a URDF, every link a body. `RobotFileError` when it cannot be read or a mesh is missing.

    Visual meshes come reduced and in their colours; those in a format that nothing here reads (COLLADA without `pycollada`) are
    left out, and a link that has lost all of them is drawn by its collision shape.
    """
    root = _parse(path)
    for link in root.findall("link"):
        _complete_inertia(link, path)
        for shape in [*link.findall("visual"), *link.findall("collision")]:
            _resolve_mesh(link, shape, path)
    for joint in root.findall("joint"):
        _close_range(joint)
    for old in root.findall("mujoco"):
        root.remove(old)
    options = {"strippath": "false", "fusestatic": "false", "discardvisual": "false", "balanceinertia": "true"}
    ET.SubElement(ET.SubElement(root, "mujoco"), "compiler", options)
    try:
        spec = mujoco.MjSpec.from_string(ET.tostring(root, encoding="unicode"))
    except ValueError as error:
        raise RobotFileError(f"{path}: {' '.join(str(error).split())}") from error
    _choose_what_is_seen(spec)
    return spec


def urdf_speeds(path: Path) -> dict[str, float]:
    """The speed limits [rad/s] that a URDF gives, by joint; MuJoCo has no place for them."""
    limits = ((joint.get("name", ""), joint.find("limit")) for joint in _parse(path).findall("joint"))
    speeds = {name: _number(limit, "velocity", f"joint {name}", path) for name, limit in limits if limit is not None}
    return {name: speed for name, speed in speeds.items() if speed > 0.0}


def _number(element: ET.Element, key: str, of: str, urdf: Path) -> float:
    """An attribute, 0 if there is none; `RobotFileError` if it is no number."""
    text = element.get(key, "0")
    try:
        return float(text)
    except ValueError as error:
        raise RobotFileError(f"{urdf}: {key} of {of} is {text!r}, no number; is this a xacro? Expand it first") from error


def _parse(path: Path) -> ET.Element:
    """The root of a URDF, without comments and without what belongs to other programs."""
    try:
        text = path.read_text(encoding="utf-8")
        # other programs' extensions (drake:acceleration, ...) are often left undeclared
        used = sorted(set(PREFIX.findall(text)) - {"xml", "xmlns"})
        declared = "".join(f' xmlns:{p}="{p}"' for p in used if f"xmlns:{p}=" not in text)
        root = ET.fromstring(re.sub(r"<robot\b", f"<robot{declared}", text, count=1))
    except (ET.ParseError, OSError, UnicodeDecodeError) as error:
        raise RobotFileError(f"{path} is not a URDF: {error}") from error
    if root.tag != "robot":
        raise RobotFileError(f"{path} is not a URDF: its root is <{root.tag}>, not <robot>")
    for element in root.iter():
        for child in [c for c in element if not isinstance(c.tag, str) or c.tag.startswith("{")]:
            element.remove(child)
        for key in [k for k in element.attrib if k.startswith("{")]:
            del element.attrib[key]
    return root


def _complete_inertia(link: ET.Element, urdf: Path) -> None:
    """MuJoCo asks for mass and inertia or neither."""
    inertial = link.find("inertial")
    if inertial is None:
        return
    mass = inertial.find("mass")
    value = 0.0 if mass is None else _number(mass, "value", f"the mass of link {link.get('name')}", urdf)
    if value <= 0.0:
        link.remove(inertial)
    elif inertial.find("inertia") is None:
        moment = str(0.4 * value * SPHERE_RADIUS**2)
        ET.SubElement(inertial, "inertia", ixx=moment, iyy=moment, izz=moment, ixy="0", ixz="0", iyz="0")


def _resolve_mesh(link: ET.Element, shape: ET.Element, urdf: Path) -> None:
    """Name the mesh file of a visual or a collision, or put the shapes of its parts in its place."""
    mesh = shape.find("geometry/mesh")
    if mesh is None:
        return
    path = find_mesh(mesh.get("filename", ""), urdf)
    if shape.tag == "collision" and path.suffix.lower() in COLLISION_FORMATS:
        mesh.set("filename", str(path))
        return
    link.remove(shape)
    said = mesh.get("scale", "1 1 1").split()
    scale = float(np.abs([_number(ET.Element("s", s=s), "s", f"the scale of {path.name}", urdf) for s in said]).mean())
    try:
        parts = parts_of(path, scale)
    except Exception as error:
        if shape.tag == "collision":
            raise RobotFileError(f"cannot read the collision mesh {path}: {error or type(error).__name__}") from error
        log.info("no picture from %s: %s", path, error)
        return
    link.extend(_piece(shape, mesh, part) for part in parts)


def _piece(shape: ET.Element, mesh: ET.Element, part: Part) -> ET.Element:
    """The visual or collision `shape` with one part of its mesh alone, in that part's colour."""
    piece = ET.Element(shape.tag)
    piece.extend(child for child in shape if child.tag == "origin" or (child.tag == "material" and part.rgba is None))
    ET.SubElement(ET.SubElement(piece, "geometry"), "mesh", {**mesh.attrib, "filename": str(part.path)})
    if part.rgba is not None and shape.tag == "visual":
        colour = " ".join(f"{c:.3f}" for c in part.rgba)
        ET.SubElement(ET.SubElement(piece, "material", name=f"colour {colour}"), "color", rgba=colour)
    return piece


def _close_range(joint: ET.Element) -> None:
    """A continuous joint becomes one that turns far enough: planning needs bounds."""
    if joint.get("type") == "continuous":
        joint.set("type", "revolute")
        limit = joint.find("limit")
        limit = ET.SubElement(joint, "limit", effort="0", velocity="0") if limit is None else limit
        limit.set("lower", str(-UNLIMITED))
        limit.set("upper", str(UNLIMITED))


def _choose_what_is_seen(spec: mujoco.MjSpec) -> None:
    """Show a body's pictures, and its collision shapes only where it has none."""
    for body in spec.bodies:
        pictures = [g for g in body.geoms if g.contype == 0 and g.conaffinity == 0]
        for geom in body.geoms:
            shown = geom in pictures or not pictures
            geom.group = SHOWN_GROUP if shown else HIDDEN_GROUP
            if geom in pictures:
                geom.mass = 0.0
