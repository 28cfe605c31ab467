"""From a mesh to a thing that can be handled: pieces, grasps, files, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pytest
import trimesh

from optimus.assets import catalogue, store
from optimus.assets.acronym import read_grasps, write_grasps
from optimus.assets.antipodal import candidates
from optimus.assets.convex import convex_pieces
from optimus.assets.importing import Wish, from_acronym
from optimus.assets.thing import Facts, Thing, prepare, shape_of
from optimus.assets.trial import GraspTrial, dropped
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import AssetError, ModelError, UnknownNameError
from optimus.objects.shapes import Grasp, block, top_grasp
from optimus.robots import PANDA
from optimus.tasks import task, with_objects

FACTS = Facts("thing", "own", "grey thing", 0.1, 0.8, (0.6, 0.6, 0.6, 1.0))
BOX = (0.04, 0.06, 0.10)


def box() -> trimesh.Trimesh:
    return trimesh.creation.box(BOX)


def cup() -> trimesh.Trimesh:
    outline = [[0, 0], [0.03, 0], [0.035, 0.08], [0.029, 0.08], [0.025, 0.006], [0, 0.006]]
    return trimesh.creation.revolve(np.array(outline))


@pytest.fixture(scope="module")
def thing() -> Thing:
    return prepare(box(), FACTS)


# ---- convex pieces


@pytest.mark.parametrize("symmetric", [False, True])
def test_pieces_are_convex_and_cover_the_mesh_and_no_more(symmetric: bool) -> None:
    mesh = cup()
    pieces = convex_pieces(mesh, symmetric)
    assert all(piece.is_convex for piece in pieces)
    lows, highs = zip(*(p.bounds for p in pieces), strict=True)
    np.testing.assert_allclose([np.min(lows, 0), np.max(highs, 0)], mesh.bounds, atol=0.002)
    rng = np.random.default_rng(0)
    points = rng.uniform(mesh.bounds[0], mesh.bounds[1], (3000, 3))
    inside = np.any([piece.contains(points) for piece in pieces], axis=0)
    far = np.abs(trimesh.proximity.signed_distance(mesh, points)) > 0.003
    assert (inside == mesh.contains(points))[far].mean() > 0.98
    assert not any(piece.contains([[0.0, 0.0, 0.05]])[0] for piece in pieces), "the cavity stays open"


# ---- grasps


def test_candidates_close_on_opposite_faces_with_the_open_hand_around_them() -> None:
    mesh = cup()
    found = candidates(mesh, mesh.center_mass, 0.08, (400, 40), np.random.default_rng(0))
    assert len(found) > 100
    for candidate in found[::7]:
        pose = candidate.grasp.pose
        axis = pose.matrix[:, 1]
        hits, _, faces = mesh.ray.intersects_location([pose.pos, pose.pos], [axis, -axis])
        ends = [((h - pose.pos) @ axis, mesh.face_normals[f] @ axis) for h, f in zip(hits, faces, strict=True)]
        outward = [e for e in ends if e[0] * e[1] > 0.8 * abs(e[0])]
        pairs = [(a, b) for a in outward for b in outward if a[0] > 0 > b[0]]
        assert any(a[0] == pytest.approx(-b[0], abs=0.001) and a[0] < 0.04 for a, b in pairs), "midway between outward faces"
        assert pose.matrix[2, 2] < 0.01, "the hand never comes from below"


def test_a_trial_tells_good_grasps_from_bad_ones() -> None:
    trial = GraspTrial(block(0.045, (1.0, 0.0, 0.0, 1.0)), PANDA)
    assert trial.run(top_grasp(0.0, 0.0)).held
    assert trial.run(top_grasp(0.0, 0.10)).failure == "the fingers miss it"
    assert trial.run(top_grasp(0.0, -0.02)).failure == "the open hand meets it"
    assert trial.run(top_grasp(0.0, 0.0, y=0.03)).failure, "one finger within the block"
    heavy = GraspTrial(replace(block(0.045, (1.0, 0.0, 0.0, 1.0)), mass=30.0), PANDA)
    assert heavy.run(top_grasp(0.0, 0.0)).failure == "it slips"


def test_a_thing_stands_and_a_ball_on_a_point_does_not() -> None:
    speed, lean = dropped(shape_of(box(), FACTS))
    assert speed < 0.01 and lean < 0.05
    top = trimesh.creation.cone(0.03, 0.06)
    top.apply_transform(trimesh.transformations.rotation_matrix(np.pi, [1, 0, 0]))
    with pytest.raises(AssetError, match="does not stand still"):
        prepare(top, FACTS)


def test_every_grasp_that_is_kept_holds_again_under_other_errors_of_the_hand(thing: Thing) -> None:
    assert len(thing.shape.grasps) >= 20 and thing.from_above >= 5 and thing.from_the_side >= 5
    trial = GraspTrial(thing.shape, PANDA)
    nudges = ((0.0, 0.0, 0.0), (0.003, -0.002, 0.002))
    assert np.mean([trial.run(grasp, nudges).held for grasp in thing.shape.grasps]) > 0.95


# ---- ACRONYM's schema


def published(path: Path, transforms: np.ndarray, held: np.ndarray, mesh: str = "meshes/Box/box.obj", scale: float = 0.01) -> Path:
    """A file as the published data has it, by h5py alone."""
    with h5py.File(path, "w") as file:
        file["grasps/transforms"] = transforms
        file["grasps/qualities/flex/object_in_gripper"] = held
        file["gripper/type"] = "panda"
        file["object/file"], file["object/scale"], file["object/mass"] = mesh, scale, 0.1
    return path


def from_above(z: float, along: str) -> np.ndarray:
    """A gripper pointing down whose fingertips reach to `z`, its x axis, on which the fingers open, along x or y of the object."""
    x = np.array([1.0, 0.0, 0.0]) if along == "x" else np.array([0.0, 1.0, 0.0])
    down = np.array([0.0, 0.0, -1.0])
    matrix = np.eye(4)
    matrix[:3, :3] = np.column_stack([x, np.cross(down, x), down])
    matrix[2, 3] = z + 0.1122
    return matrix


def test_a_grasp_of_the_published_frame_is_the_same_grasp_in_physics(tmp_path: Path) -> None:
    plank = shape_of(trimesh.creation.box((0.04, 0.14, 0.08)), FACTS)  # across x it fits the hand, across y it does not
    trial = GraspTrial(plank, PANDA)
    for along, fits in (("x", True), ("y", False)):
        path = published(tmp_path / f"{along}.h5", np.array([from_above(0.02, along)]), np.array([1]))
        pose = read_grasps(path).grasps[0]
        (x, y, z), quat = pose.pos.tolist(), tuple(pose.quat.tolist())
        assert z == pytest.approx(0.02 + 0.0088, abs=1e-6)
        assert trial.run(Grasp((x, y, z), quat)).held == fits


def test_an_acronym_object_is_used_with_those_of_its_grasps_that_hold_here(tmp_path: Path) -> None:
    folder = tmp_path / "meshes/Box"
    folder.mkdir(parents=True)
    mesh = trimesh.creation.box((4.0, 6.0, 10.0))  # in units of a centimetre, its middle elsewhere
    mesh.apply_translation((20.0, 0.0, 5.0))
    mesh.export(folder / "box.obj")
    offset = np.array([0.2, 0.0, 0.05])
    good = [from_above(0.03 - 0.001 * k, "x") for k in range(24)]
    bad = [from_above(0.2, "x"), from_above(0.02, "y") @ trimesh.transformations.translation_matrix([0.0, 0.1, 0.0])]
    transforms = np.array(good + bad)
    transforms[:, :3, 3] += offset
    path = published(tmp_path / "box.h5", transforms, np.array([1] * len(transforms)))
    found = from_acronym(path, tmp_path, Wish(mass=0.1))
    assert found.shape.half_extents == pytest.approx((0.02, 0.03, 0.05), abs=1e-6)
    assert 20 <= len(found.shape.grasps) <= len(good)
    heights = [g.pos[2] for g in found.shape.grasps]
    assert max(heights) < 0.04 and np.abs([g.pos[:2] for g in found.shape.grasps]).max() < 1e-6


def test_what_is_written_is_read_back(tmp_path: Path, thing: Thing) -> None:
    write_grasps(tmp_path / "g.h5", thing.shape.grasps, thing.outcomes, {"file": "box", "scale": 1.0})
    found = read_grasps(tmp_path / "g.h5")
    assert found.held.all() and found.mesh == "box"
    for pose, grasp in zip(found.grasps, thing.shape.grasps, strict=True):
        np.testing.assert_allclose(pose.pos, grasp.pos, atol=1e-9)
        np.testing.assert_allclose(pose.matrix, grasp.pose.matrix, atol=1e-9)


def test_files_of_another_schema_are_refused(tmp_path: Path) -> None:
    (tmp_path / "text.h5").write_text("hello")
    with pytest.raises(AssetError, match="not a readable HDF5"):
        read_grasps(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["data/demo_0"] = np.zeros(3)
    with pytest.raises(AssetError, match="grasps/transforms"):
        read_grasps(tmp_path / "other.h5")
    with pytest.raises(AssetError, match="rigid"):
        read_grasps(published(tmp_path / "skewed.h5", np.array([np.full((4, 4), 2.0)]), np.array([1])))


# ---- on disk


def test_a_thing_is_the_same_after_saving(tmp_path: Path, thing: Thing) -> None:
    store.save(thing, tmp_path / "thing", b"png")
    shape = store.load(tmp_path / "thing")
    assert shape.half_extents == pytest.approx(thing.shape.half_extents)
    assert (shape.mass, shape.friction, shape.verified) == (0.1, 0.8, True)
    assert len(shape.grasps) == len(thing.shape.grasps)
    for ours, theirs in zip(shape.parts, thing.shape.parts, strict=True):
        assert ours.mesh is not None and theirs.mesh is not None and ours.mesh.digest == theirs.mesh.digest
    assert sorted(p.name for p in tmp_path.iterdir()) == ["thing"], "nothing is left over"


def test_of_two_that_make_the_same_thing_at_once_the_first_one_is_kept(tmp_path: Path, thing: Thing) -> None:
    for name, anew in (("first", False), ("second", False), ("third", True)):
        store.save(thing, tmp_path / "thing", name.encode(), anew)
        kept = (tmp_path / "thing" / store.PICTURE).read_bytes()
        assert kept == (name if anew else "first").encode()
        assert sorted(p.name for p in tmp_path.iterdir()) == ["thing"]


def test_a_damaged_or_crafted_folder_is_refused(tmp_path: Path, thing: Thing) -> None:
    store.save(thing, tmp_path / "thing", b"png")
    np.savez(tmp_path / "thing" / store.MESHES, look_vertices=np.array([{"a": 1}], dtype=object))
    with pytest.raises(AssetError, match="damaged"):
        store.load(tmp_path / "thing")
    (tmp_path / "thing" / store.RECORD).write_text("{")
    with pytest.raises(AssetError, match="no prepared object"):
        store.load(tmp_path / "thing")


# ---- by name


def test_sets_of_objects() -> None:
    assert len(catalogue.keys_of("72")) == 72 and len(catalogue.keys_of("19")) == 19
    assert set(catalogue.keys_of("unseen")) == set(catalogue.keys_of("72")) - set(catalogue.keys_of("19"))
    assert {"mug-1", "mug-2", "can-1"} <= set(catalogue.keys_of("mug,can-1"))
    with pytest.raises(UnknownNameError, match=r"'mugg'.*mug-1"):
        catalogue.keys_of("mugg")
    assert with_objects("shelf@19", "unseen") == "shelf@unseen"
    with pytest.raises(ModelError, match="objects of its own"):
        task("stack@72")


@pytest.mark.parametrize("name", ["pick-place", "pick-place-two", "shelf", "microwave"])
def test_tasks_are_done_with_other_objects(name: str) -> None:
    env = ManipulationEnv(task(f"{name}@can-1,jar-1"), images=False)
    attempt = demonstrate(env, 2, ExpertConfig(check=True))
    assert attempt.failure == ""
    assert set(str(attempt.info["variant"]).split("+")) <= {"can-1", "jar-1"}
