"""Demonstrations of others, from HDF5 files as robosuite and robomimic write them: taken over, learned from, refused."""

from __future__ import annotations

import json
import pickle
from dataclasses import replace
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import pytest

from optimus import load_policy
from optimus.data.curate import CurationConfig, curate
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError
from optimus.exchange.robomimic_import import RobomimicSource, import_robomimic
from optimus.learn import metrics
from optimus.learn.train import TrainConfig, train
from test_train import QUICK, SMALL


def test_another_s_demonstrations_are_curated_and_learned_from(tmp_path: Path) -> None:
    """A file as robosuite users have them: float64, no words, no masks, other observations, one demonstration without success."""
    robosuite_like(tmp_path / "lift.hdf5", count=8)
    said = import_robomimic(tmp_path / "lift.hdf5", tmp_path / "lift", RobomimicSource(instruction="lift the cube"))
    assert said["observations"] == ["robot0_eef_pos", "robot0_eef_quat", "robot0_gripper_qpos", "agentview_image"]
    store = EpisodeStore.open(tmp_path / "lift")
    assert store.task == "Lift" and store.config["position_scale"] == 0.05
    assert store.read(10).info["instruction"] == "lift the cube" and store.read(10).initial_state.shape == (32,)
    curation = curate(store.path, CurationConfig())
    assert curation.dropped == {3: "failed"}
    assert store.config["gripper"] == "continuous"  # its last numbers are not of two values
    policy = train(store.path, tmp_path / "run", replace(QUICK, steps=2), SMALL)
    assert policy.inputs.objects == 0 and set(policy.inputs.proprioception) == set(said["observations"][:3])
    for line in metrics.read(tmp_path / "run"):
        assert np.isfinite([v for v in line.values() if v is not None]).all()
    with pytest.raises(DatasetError, match="robot0_joint_pos"):
        import_robomimic(tmp_path / "lift.hdf5", tmp_path / "other", RobomimicSource(observations=("robot0_jointpos",)))
    assert not (tmp_path / "other").exists()
    more = import_robomimic(tmp_path / "lift.hdf5", tmp_path / "other", RobomimicSource(observations=("robot0_joint_pos",)))
    assert more["observations"] == [*said["observations"][:3], "robot0_joint_pos", "agentview_image"]


@pytest.mark.parametrize("size", [1, 2, 4, 14])
def test_actions_of_other_sizes_are_learned_from(tmp_path: Path, size: int) -> None:
    robosuite_like(tmp_path / "d.hdf5", 5, size)
    import_robomimic(tmp_path / "d.hdf5", tmp_path / "d")
    curate(tmp_path / "d", CurationConfig())
    train(tmp_path / "d", tmp_path / "run", replace(QUICK, steps=1), SMALL)
    agent = load_policy(tmp_path / "run")
    episode = EpisodeStore.open(tmp_path / "d").read(5)
    action = agent.act({name: array[0] for name, array in episode.observations.items()})
    assert action.shape == (size,) and np.isfinite(action).all()


def test_actions_that_no_policy_can_give_are_refused(tmp_path: Path) -> None:
    robosuite_like(tmp_path / "d.hdf5", 5)
    with h5py.File(tmp_path / "d.hdf5", "r+") as file:
        demo: Any = file["data/demo_5"]
        demo["actions"][2, 1] = -3.0
    import_robomimic(tmp_path / "d.hdf5", tmp_path / "d")
    curate(tmp_path / "d", CurationConfig())
    with pytest.raises(DatasetError, match="actions up to 3"):
        train(tmp_path / "d", tmp_path / "run", TrainConfig(steps=1))


def robosuite_like(path: Path, count: int, numbers: int = 7) -> None:
    rng = np.random.default_rng(0)
    sizes = {"robot0_eef_pos": 3, "robot0_eef_quat": 4, "robot0_gripper_qpos": 2, "robot0_joint_pos": 7, "object": 10}
    with h5py.File(path, "w") as file:
        data = file.create_group("data")
        kwargs = {"controller_configs": {"type": "OSC_POSE", "output_max": [0.05] * 3 + [0.5] * 3}, "control_freq": 20}
        data.attrs["env_args"] = json.dumps({"env_name": "Lift", "type": 1, "env_kwargs": kwargs})
        for i in range(3, 3 + count):
            demo, steps = data.create_group(f"demo_{i}"), 12 + i % 3
            demo.attrs["num_samples"] = steps
            demo["actions"], demo["states"] = rng.uniform(-1, 1, (steps, numbers)), rng.normal(size=(steps, 32))
            demo["rewards"], demo["dones"] = np.eye(steps)[-1] * (i != 3), np.eye(steps)[-1]
            for name, size in sizes.items():
                demo[f"obs/{name}"] = rng.normal(size=(steps, size))
            demo["obs/agentview_image"] = rng.integers(0, 255, (steps, 84, 84, 3), dtype=np.uint8)


def _damage(kind: str, file: Any, folder: Path) -> None:
    demo = file["data/demo_0"]
    pos = demo["obs/robot0_eef_pos"][()]
    if kind == "no data":
        del file["data"]
    elif kind == "no demonstrations":
        for name in list(file["data"]):
            del file["data"][name]
    elif kind == "NaN":
        demo["actions"][0, 0] = np.nan
    elif kind == "rows":
        del demo["obs/robot0_eef_pos"]
        demo["obs/robot0_eef_pos"] = pos[:-1]
    elif kind == "no actions":
        del demo["actions"]
    elif kind == "a module for a task":
        file["data"].attrs["env_args"] = json.dumps({"env_name": "antigravity:TASK"})
    elif kind == "env_args":
        file["data"].attrs["env_args"] = "[1, 2"
    elif kind == "external link":
        with h5py.File(folder / "elsewhere.hdf5", "w") as other:
            other["pos"] = pos
        del demo["obs/robot0_eef_pos"]
        demo["obs/robot0_eef_pos"] = h5py.ExternalLink(str(folder / "elsewhere.hdf5"), "pos")
    elif kind == "pickled":
        del demo["actions"]
        demo.create_dataset("actions", data=np.frombuffer(pickle.dumps(_Bomb(folder)), np.uint8).view("V1"))
    elif kind == "objects":
        del demo["actions"]
        demo.create_dataset("actions", (2,), dtype=h5py.vlen_dtype(np.float64))
    elif kind == "external storage":
        (folder / "raw").write_bytes(np.zeros((len(pos), 7), np.float64).tobytes())
        del demo["actions"]
        demo.create_dataset("actions", (len(pos), 7), np.float64, external=[(str(folder / "raw"), 0, h5py.h5f.UNLIMITED)])


class _Bomb:
    """Leaves a mark wherever it is unpickled."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __reduce__(self) -> tuple[Any, tuple[Any, ...]]:
        return Path.touch, (self.folder / "executed",)


DAMAGE = {
    "no data": "no group 'data'",
    "no demonstrations": "no demonstrations",
    "NaN": "NaN",
    "rows": "rows",
    "no actions": "'actions'",
    "env_args": "env_args",
    "a module for a task": "antigravity:TASK",
    "external link": "robot0_eef_pos",
    "pickled": "only plain numbers",
    "objects": "only plain numbers",
    "external storage": "another file",
}


@pytest.mark.parametrize("kind", DAMAGE)
def test_what_is_no_plain_data_is_refused_and_leaves_nothing(tmp_path: Path, kind: str) -> None:
    robosuite_like(tmp_path / "d.hdf5", count=1)
    with h5py.File(tmp_path / "d.hdf5", "r+") as file:
        file.move("data/demo_3", "data/demo_0")
        _damage(kind, file, tmp_path)
    names = ("robot0_eef_pos",)
    with pytest.raises(DatasetError, match=DAMAGE[kind]):
        import_robomimic(tmp_path / "d.hdf5", tmp_path / "out", RobomimicSource(observations=names))
    assert not (tmp_path / "executed").exists() and not list(tmp_path.glob("out*"))
