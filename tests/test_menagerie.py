"""The robot model arrives whole, verified and once, whatever happens on the way."""

import hashlib
import json
import multiprocessing
import os
import shutil
import time
from pathlib import Path

import mujoco
import numpy as np
import pytest

from optimus.errors import AssetError, StorageError, UnknownNameError
from optimus.robots import obj
from optimus.robots.menagerie import RECORD, fetch
from optimus.robots.sources import Manifest, Source, default_sources

MODEL = "franka_emika_panda"


@pytest.fixture(scope="module")
def original(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The files as upstream has them, from the first source that answers."""
    manifest = Manifest.named(MODEL)
    for number, source in enumerate(default_sources(manifest)):
        scratch = tmp_path_factory.mktemp(f"source{number}")
        try:
            return source.locate(scratch)
        except AssetError:
            continue
    pytest.fail("no source of the robot's model answers")


def folder_source(folder: Path) -> list[Source]:
    return [Source(f"the folder {folder.name}", lambda _scratch: folder)]


def refuse(_scratch: Path) -> Path:
    raise AssetError("asleep")


@pytest.fixture(scope="module")
def cache(original: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cache that has the model, from the second source asked: the first one fails."""
    cache = tmp_path_factory.mktemp("cache")
    fetch(cache=cache, sources=[Source("the sleeper", refuse), *folder_source(original)])
    return cache


def test_cached_copy_is_the_same_folder_and_quick(cache: Path) -> None:
    started = time.perf_counter()
    folder = fetch(cache=cache, sources=[])
    assert time.perf_counter() - started < 0.1
    assert folder == fetch(cache=cache, sources=[])
    assert (folder / "LICENSE").is_file()
    assert "changed by optimus" in (folder / "CHANGES").read_text()


def test_model_compiles_and_what_touches_is_untouched(cache: Path, original: Path) -> None:
    folder = fetch(cache=cache, sources=[])
    prepared = mujoco.MjSpec.from_file(str(folder / "panda.xml")).compile()
    full = mujoco.MjSpec.from_file(str(original / "panda.xml")).compile()
    assert prepared.nmeshface < full.nmeshface / 8
    assert np.array_equal(prepared.body_inertia, full.body_inertia)
    for attribute in ("geom_pos", "geom_quat", "geom_size", "geom_friction"):
        mine, theirs = (getattr(model, attribute)[model.geom_group == 3] for model in (prepared, full))
        assert np.array_equal(mine, theirs), attribute
    for name in ("hand.stl", "finger_0.obj", "link5_collision_1.obj"):
        assert (folder / "assets" / name).read_bytes() == (original / "assets" / name).read_bytes()


def test_base_does_not_touch_the_first_link(cache: Path) -> None:
    model = mujoco.MjSpec.from_file(str(fetch(cache=cache, sources=[]) / "panda.xml")).compile()
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_forward(model, data)
    assert data.ncon == 0


def test_visual_meshes_keep_their_shape(cache: Path, original: Path) -> None:
    assets = fetch(cache=cache, sources=[]) / "assets"
    for name in ("link1", "link2"):
        reduced, full = obj.read(assets / f"visual_{name}.obj"), obj.read(original / "assets" / f"{name}.obj")
        assert len(reduced.faces) < len(full.faces) / 8
        assert np.allclose(np.ptp(reduced.points, axis=0), np.ptp(full.points, axis=0), atol=2e-3)
        assert np.allclose(np.linalg.norm(reduced.normals, axis=-1), 1, atol=2e-3)


def test_file_that_was_tampered_with_is_refused(original: Path, tmp_path: Path) -> None:
    copy = tmp_path / "panda"
    shutil.copytree(original, copy)
    (copy / "assets" / "hand.stl").write_bytes(b"not a mesh")
    with pytest.raises(AssetError, match=r"the folder panda: assets/hand\.stl has SHA-256 [0-9a-f]{64}, not"):
        fetch(cache=tmp_path / "cache", sources=folder_source(copy))
    assert not list((tmp_path / "cache" / "models").glob(f"{MODEL}*/"))


def test_offline_error_lists_every_source_and_the_remedy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MENAGERIE_ROOT", str(tmp_path / "empty"))
    monkeypatch.delenv("OPTIMUS_ASSETS", raising=False)
    monkeypatch.setenv("MENAGERIE_CACHE_DIR", str(tmp_path / "downloads"))
    monkeypatch.setenv("MENAGERIE_BASE_URL", (tmp_path / "nowhere").as_uri())
    for name in ("PIP_FIND_LINKS", "PIP_EXTRA_INDEX_URL"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("PIP_CONFIG_FILE", os.devnull)
    monkeypatch.setenv("PIP_NO_INDEX", "1")
    with pytest.raises(AssetError) as caught:
        fetch(cache=tmp_path / "cache")
    message = str(caught.value)
    assert "\n" not in message
    tried = ("MENAGERIE_ROOT=", "mujoco-menagerie downloader", "No such file", "pip download")
    for part in (*tried, "set MENAGERIE_ROOT"):
        assert part in message


def test_damaged_cache_is_mended(original: Path, cache: Path, tmp_path: Path) -> None:
    shutil.copytree(cache, tmp_path, dirs_exist_ok=True)
    folder = fetch(cache=tmp_path, sources=[])
    (folder / "assets" / "hand.stl").write_bytes(b"")
    assert fetch(cache=tmp_path, sources=folder_source(original)) == folder
    assert (folder / "assets" / "hand.stl").stat().st_size > 0
    assert [path.name for path in folder.parent.iterdir() if path.is_dir()] == [folder.name]


def fetch_into(cache: Path, original: Path) -> str:
    return str(fetch(cache=cache, sources=folder_source(original)))


def test_two_processes_at_once(original: Path, tmp_path: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        first, second = pool.starmap(fetch_into, [(tmp_path, original)] * 2)
    assert first == second
    record = json.loads((Path(first) / RECORD).read_text())
    for name, digest in record.items():
        assert hashlib.sha256((Path(first) / name).read_bytes()).hexdigest() == digest


def test_killed_process_leaves_nothing_that_counts(original: Path, tmp_path: Path) -> None:
    for delay in (0.8, 1.6):
        process = multiprocessing.get_context("spawn").Process(target=fetch_into, args=(tmp_path, original))
        process.start()
        process.join(delay)
        process.kill()
        process.join()
    folder = fetch(cache=tmp_path, sources=folder_source(original))
    mujoco.MjSpec.from_file(str(folder / "panda.xml")).compile()
    assert [path.name for path in folder.parent.iterdir() if path.is_dir()] == [folder.name]


def test_cache_that_cannot_be_written_and_unknown_model(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(StorageError, match="set OPTIMUS_CACHE"):
        fetch(cache=tmp_path / "file", sources=[])
    with pytest.raises(UnknownNameError, match="valid: franka_emika_panda"):
        fetch("franka")
