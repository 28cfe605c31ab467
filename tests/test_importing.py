"""Other people's meshes: closed, stood up, fused, refused with the reason, and what is on the command line."""

from __future__ import annotations

import json
import os
from functools import partial
from itertools import count
from pathlib import Path

import numpy as np
import pytest
import trimesh

from optimus.assets import catalogue, store
from optimus.assets.importing import Wish, imported, meshes_in, read_mesh, repaired, steadiness, stood_up, whole
from optimus.assets.thing import Facts, Thing
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import AssetError, OptimusError, StorageError
from optimus.objects.shapes import block
from optimus.tasks import task
from optimus.workers import each_apart


def box() -> trimesh.Trimesh:
    return trimesh.creation.box((0.04, 0.06, 0.10))


def cup() -> trimesh.Trimesh:
    outline = [[0, 0], [0.03, 0], [0.035, 0.08], [0.029, 0.08], [0.025, 0.006], [0, 0.006]]
    return trimesh.creation.revolve(np.array(outline))


def test_meshes_are_closed_and_stood_up(tmp_path: Path) -> None:
    mesh = box()
    holed = trimesh.Trimesh(mesh.vertices, mesh.faces[1:])
    assert not holed.is_watertight
    assert repaired(holed).is_watertight and repaired(holed).volume == pytest.approx(mesh.volume, rel=1e-6)
    for turn in ([1, 0, 0], [0, 1, 0]):
        lying = cup()
        lying.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 5, turn))
        lying.apply_transform(stood_up(lying, "auto"))
        assert steadiness(lying) > 0.1
    for sides in (24, 32, 48, 64, 128):
        can = trimesh.creation.cylinder(0.03, 0.1, sections=sides)
        assert steadiness(can) == pytest.approx(np.arctan(0.03 / 0.05), abs=0.02)
        can.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, [1, 0, 0]))
        assert steadiness(can) < np.radians(9.0), "it rolls"
        can.apply_transform(stood_up(can, "auto"))
        assert can.extents[2] == pytest.approx(0.1, abs=1e-6)
    y_up = cup()
    y_up.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, [1, 0, 0]))
    y_up.export(tmp_path / "mug.ply")
    mug = repaired(read_mesh(tmp_path / "mug.ply")[0])
    mug.apply_transform(stood_up(mug, "auto"))
    assert mug.extents[2] == pytest.approx(0.08, abs=0.002), "y up, as glTF has it, is understood"


def test_closed_bodies_that_overlap_become_one(tmp_path: Path) -> None:
    """An L of two boxes, as modellers put things together: one volume, no face inside it, and grasps across it that hold."""
    wall, foot = trimesh.creation.box((0.02, 0.05, 0.10)), trimesh.creation.box((0.06, 0.05, 0.02))
    foot.apply_translation((0.02, 0.0, -0.04))
    both = trimesh.util.concatenate([wall, foot])
    assert isinstance(both, trimesh.Trimesh)
    assert both.is_watertight and both.volume == pytest.approx(0.00016)
    solid = repaired(both)
    assert solid.is_watertight and solid.volume == pytest.approx(0.00014, rel=1e-4), "what they share counts once"
    assert solid.contains([(0.0, 0.0, -0.04)]).all() and len(solid.split()) == 1
    hits = solid.ray.intersects_location([(-0.1, 0.001, -0.041)], [(1.0, 0.0, 0.0)], multiple_hits=True)[0]
    assert np.allclose(np.sort(hits[:, 0]), (-0.01, 0.05), atol=1e-6), "no face inside"
    both.export(tmp_path / "l.stl")
    assert len(imported(tmp_path / "l.stl", Wish()).shape.grasps) >= 20


@pytest.mark.parametrize(
    ("mesh", "scale", "why"),
    [
        (trimesh.creation.box((1.0, 0.5, 0.5)), 1.0, "100.0 cm|111.8 cm across"),
        (trimesh.creation.box((0.004, 0.004, 0.004)), 1.0, "mm long"),
        (trimesh.creation.box((0.11, 0.11, 0.10)), 1.0, "0 grasps that hold"),
        (trimesh.Trimesh([[0, 0, 0], [0.05, 0, 0], [0, 0.05, 0]], [[0, 1, 2]]), 1.0, "flat"),
        (trimesh.creation.box((6.0, 6.0, 9.0)), 0.01, ""),
    ],
)
def test_what_cannot_be_handled_is_refused_with_the_reason(tmp_path: Path, mesh: trimesh.Trimesh, scale: float, why: str) -> None:
    mesh.export(tmp_path / "it.stl")
    if not why:
        assert imported(tmp_path / "it.stl", Wish(scale=scale)).shape.half_extents[2] == pytest.approx(0.045)
        return
    with pytest.raises(AssetError, match=why):
        imported(tmp_path / "it.stl", Wish(scale=scale, mass=0.1))


def test_files_that_are_no_meshes_are_named(tmp_path: Path) -> None:
    (tmp_path / "words.obj").write_text("hello")
    (tmp_path / "table.csv").write_text("1,2")
    with pytest.raises(AssetError, match=r"words\.obj"):
        imported(tmp_path / "words.obj", Wish())
    with pytest.raises(AssetError, match=r"readable are .*\.glb"):
        meshes_in([tmp_path / "table.csv"])
    with pytest.raises(AssetError, match="no such file"):
        meshes_in([tmp_path / "missing.obj"])


def test_objects_of_ones_own_from_the_command_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from optimus.cli.objects import objects

    monkeypatch.setenv("OPTIMUS_OBJECTS", str(tmp_path / "mine"))
    meshes = tmp_path / "meshes"
    meshes.mkdir()
    box().export(meshes / "little box.stl")
    trimesh.creation.box((1.0, 1.0, 1.0)).export(meshes / "crate.stl")
    objects("add", (str(meshes),), mass=0.1, json=True)
    answer = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert answer["added"] == ["little-box"] and "across" in answer["refused"][str(meshes / "crate.stl")]
    objects("list", ("little-box",), out=tmp_path / "sheet", json=True)
    listed = json.loads(capsys.readouterr().out.splitlines()[-1])["objects"][0]
    assert (listed["name"], listed["watertight"], listed["mass"]) == ("little-box", True, 0.1)
    assert listed["grasps"] >= 20
    assert (tmp_path / "sheet/objects.png").stat().st_size > 1000
    assert "little-box" in (tmp_path / "sheet/objects.html").read_text()
    before = catalogue.added()
    for wrong in ("../escaped", str(tmp_path / "meshes"), ".", "a,b", "a@b", ""):
        with pytest.raises(OptimusError, match="cannot be an object's name"):
            objects("add", (str(meshes / "little box.stl"),), name=wrong)
    assert (meshes / "crate.stl").exists()
    assert list(catalogue.keys_of("own")) == ["little-box"], "the user's own categories are categories"
    with pytest.raises(OptimusError, match="takes no --mass, --scale"):
        objects("list", ("little-box",), mass=0.2, scale=0.5)
    with pytest.raises(OptimusError, match="name at least one"):
        objects("remove")
    with pytest.raises(OptimusError, match="nothing was added"):
        objects("add", (str(meshes / "crate.stl"),))
    assert catalogue.added() == before
    env = ManipulationEnv(task("pick-place@little-box"), images=False)
    assert demonstrate(env, 1, ExpertConfig()).success
    objects("remove", ("little-box",))
    assert catalogue.added() == {}


def test_a_mesh_that_crashes_or_holds_up_a_library_takes_no_other_with_it() -> None:
    crashed, endless, answer = each_apart([os.abort, partial(sum, count()), partial(int, "3")], 2, seconds=3.0)
    assert answer == 3
    for made in (crashed, endless):
        assert isinstance(made, Exception)
        with pytest.raises(AssetError, match="convex decomposition crash, or go on"):
            whole(made)


@pytest.mark.parametrize(
    "wrong", [{"mass": 0.0}, {"mass": float("nan")}, {"density": float("nan")}, {"scale": -1.0}, {"mass": 0.2, "density": 300.0}]
)
def test_wishes_that_make_no_sense_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(OptimusError, match=r"above 0|say one of them"):
        Wish(**wrong)  # type: ignore[arg-type]


def test_no_object_is_named_as_a_category_or_replaces_what_is_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("OPTIMUS_OBJECTS", str(tmp_path / "mine"))
    kept: list[str] = []
    monkeypatch.setattr(catalogue, "keep", lambda thing, folder: kept.append(folder.name))
    for name in ("mug", "72"):
        facts, cube = Facts(name, "own", "thing", 0.1, 1.0, (0.5, 0.5, 0.5, 1.0)), block(0.04, (1.0, 0.0, 0.0, 1.0))
        thing = Thing(facts, cube, (), True, (0.0, 0.0, 0.0), 1e-4, (0.0, 0.0))
        assert catalogue.add(thing) == kept[-1] != name and len(catalogue.keys_of(name)) > 1
    (tmp_path / "precious").mkdir()
    (tmp_path / "precious" / "thesis.txt").write_text("all of it")
    with pytest.raises(StorageError, match="not an object"):
        store.save(thing, tmp_path / "precious", b"")
    assert (tmp_path / "precious" / "thesis.txt").read_text() == "all of it"


def test_what_is_added_changes_no_category_and_what_is_damaged_no_other_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A dataset says `pick-place@mug`: that has to mean the same mugs everywhere."""
    monkeypatch.setenv("OPTIMUS_OBJECTS", str(tmp_path))
    mugs = catalogue.keys_of("mug")
    records = {"mine": '{"format": 1, "category": "mug"}', "cup": '{"format": 1, "category": "own"}', "broken": "{"}
    for name, record in records.items():
        (tmp_path / name).mkdir()
        (tmp_path / name / "object.json").write_text(record)
    assert catalogue.keys_of("mug") == mugs and list(catalogue.keys_of("own")) == ["cup"]
    assert list(catalogue.keys_of("mug-4,mine")) == ["mug-4", "mine"]
