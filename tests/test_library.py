"""The library of objects: every solid is a sound mesh of the right size that stands where it is put."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from functools import cache

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from optimus.objects.library import LIBRARY, SMALL

NAMES = list(LIBRARY)


@cache
def solid(name: str) -> trimesh.Trimesh:
    return LIBRARY[name].solid()


def test_it_holds_72_objects_of_many_categories() -> None:
    assert len(LIBRARY) == 72
    assert len({thing.words for thing in LIBRARY.values()}) == 72
    categories = [thing.category for thing in LIBRARY.values()]
    assert len(set(categories)) >= 24
    assert all(2 <= categories.count(category) <= 5 for category in categories)
    assert {"basket", "vase", "magnet", "cup", "mug", "bowl", "bottle", "can", "box", "book", "hammer", "fruit"} <= set(categories)


def test_the_small_set_is_spread_over_the_categories() -> None:
    assert len(SMALL) == 19
    assert len({LIBRARY[name].category for name in SMALL}) == 19


def test_importing_it_builds_nothing() -> None:
    code = "import sys, optimus.objects.library; print('trimesh' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "False"


@pytest.mark.parametrize("name", NAMES)
def test_its_entry_is_plausible(name: str) -> None:
    thing = LIBRARY[name]
    assert thing.name == name == name.lower()
    assert name.rsplit("-", 1)[0] == thing.category
    assert not thing.words.startswith(("a ", "an ", "the "))
    assert 0.03 <= thing.mass <= 0.35
    assert 0.5 <= thing.friction <= 1.0
    assert all(0.0 <= c <= 1.0 for c in thing.rgba)


@pytest.mark.parametrize("name", NAMES)
def test_it_is_one_closed_body(name: str) -> None:
    mesh = solid(name)
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume > 0
    assert len(trimesh.graph.connected_components(mesh.face_adjacency, nodes=np.arange(len(mesh.faces)))) == 1
    assert 300 <= len(mesh.faces) <= 4000


@pytest.mark.parametrize("name", NAMES)
def test_its_size_suits_the_hand(name: str) -> None:
    points = np.asarray(solid(name).vertices)
    low, high = points.min(axis=0), points.max(axis=0)
    assert np.linalg.norm((points - (low + high) / 2)[:, :2], axis=1).max() <= 0.07
    assert 0.02 <= high[2] - low[2] <= 0.16
    assert (high - low).max() >= 0.03
    assert abs(low[2]) < 1e-9


@pytest.mark.parametrize("name", NAMES)
def test_it_stands(name: str) -> None:
    """The centre of mass lies well inside the hull of the lowest points, and the object may tilt by 12 degrees before it falls."""
    mesh = solid(name)
    points = np.asarray(mesh.vertices)
    feet = ConvexHull(points[points[:, 2] < 2e-4][:, :2])
    centre = np.asarray(mesh.center_mass)
    margin = -(feet.equations[:, :2] @ centre[:2] + feet.equations[:, 2]).max()
    assert margin >= 0.004
    assert np.degrees(np.arctan2(margin, centre[2])) >= 12


@pytest.mark.parametrize("name", NAMES)
def test_a_symmetric_one_is_as_wide_in_all_directions(name: str) -> None:
    flat = np.asarray(solid(name).vertices)[:, :2]
    assert not LIBRARY[name].symmetric or np.ptp(np.ptp(flat @ _directions(), axis=0)) < 1e-3


def _directions() -> np.ndarray:
    angles = np.linspace(0, np.pi, 24, endpoint=False)
    return np.stack([np.cos(angles), np.sin(angles)])


def test_another_process_makes_the_same_meshes() -> None:
    code = (
        "import hashlib; from optimus.objects.library import LIBRARY\n"
        "for thing in LIBRARY.values():\n"
        "    mesh = thing.solid(); print(hashlib.sha256(mesh.vertices.tobytes() + mesh.faces.tobytes()).hexdigest())"
    )
    there = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    here = [hashlib.sha256(solid(name).vertices.tobytes() + solid(name).faces.tobytes()).hexdigest() for name in NAMES]
    assert there == here
    assert len(set(here)) == 72
