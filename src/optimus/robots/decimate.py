"""Make a robot's model fast to draw: less of what is only seen, nothing changed in what is touched."""

import xml.etree.ElementTree as ET
from collections.abc import Collection, Iterable
from pathlib import Path

from optimus.robots import obj

VERSION = 2  # part of the cache's key: raise it whenever this file or `obj` writes something else
FACES_PER_METRE = 2500.0  # times the square root of a mesh's area [m]: 800 for 0.1 m^2
FEWEST = 40
PREFIX = "visual_"

CHANGES = """\
This folder is a copy of {upstream} ({license}, see LICENSE), changed by optimus:
- visual meshes reduced, and those of one body and material joined (collision meshes are as they were)
- contacts between {pairs} excluded, as upstream does since 2025
"""


def prepare(
    folder: Path, entry: str, *, exclude: Iterable[tuple[str, str]] = (), keep: Collection[str] = ()
) -> None:
    """Reduce and join the visual meshes of the model in `folder`, in place, and exclude some contacts.

    `exclude` names pairs of bodies. Meshes named in `keep` stay whole: those a camera sees from close by.
    """
    path = folder / entry
    tree = ET.parse(path)
    root = tree.getroot()
    _exclude_contacts(root, exclude)
    compiler = root.find("compiler")
    _join_visuals(root, folder / (compiler.get("meshdir", "") if compiler is not None else ""), keep)
    ET.indent(tree)
    tree.write(path, encoding="unicode")


def _exclude_contacts(root: ET.Element, pairs: Iterable[tuple[str, str]]) -> None:
    """The base is fixed to the world, so MuJoCo does not filter its contacts with the first link."""
    present = {frozenset((e.get("body1"), e.get("body2"))) for e in root.iter("exclude")}
    for body1, body2 in pairs:
        if frozenset((body1, body2)) not in present:
            contact = root.find("contact")
            contact = ET.SubElement(root, "contact") if contact is None else contact
            ET.SubElement(contact, "exclude", body1=body1, body2=body2)


def _join_visuals(root: ET.Element, folder: Path, keep: Collection[str]) -> None:
    """Give every body one visual geom a material, with a mesh of its own, and drop the meshes it replaces."""
    asset = root.find("asset")
    assert asset is not None
    elements = {mesh.get("name") or Path(mesh.get("file", "")).stem: mesh for mesh in asset.findall("mesh")}
    touched = {g.get("mesh", "") for g in root.iter("geom") if g.get("class") != "visual"}
    joined: dict[tuple[str, ...], str] = {}  # both fingers are made of the same meshes
    for body in root.iter("body"):
        for geoms in _groups(body):
            names = tuple(geom.get("mesh", "") for geom in geoms)
            if names not in joined:
                joined[names] = PREFIX + names[0]
                meshes = [_reduced(folder / elements[n].get("file", ""), whole=n in keep) for n in names]
                obj.write(obj.join(meshes), folder / f"{joined[names]}.obj")
                ET.SubElement(asset, "mesh", name=joined[names], file=f"{joined[names]}.obj")
            geoms[0].set("mesh", joined[names])
            for geom in geoms[1:]:
                body.remove(geom)
    for name in {name for names in joined for name in names} - touched:
        (folder / elements[name].get("file", "")).unlink()
        asset.remove(elements[name])


def _groups(body: ET.Element) -> list[list[ET.Element]]:
    """The visual mesh geoms of a body that differ in nothing but their mesh."""
    groups: dict[tuple[tuple[str, str], ...], list[ET.Element]] = {}
    for geom in body.findall("geom"):
        if geom.get("class") == "visual" and geom.get("mesh"):
            others = tuple(sorted(item for item in geom.attrib.items() if item[0] != "mesh"))
            groups.setdefault(others, []).append(geom)
    return list(groups.values())


def _reduced(path: Path, whole: bool) -> obj.Mesh:
    mesh = obj.read(path)
    if whole:
        return mesh
    return obj.reduce(mesh, max(FEWEST, round(FACES_PER_METRE * float(mesh.areas.sum()) ** 0.5)))
