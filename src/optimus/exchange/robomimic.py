"""A data set as one HDF5 file in robomimic's layout (robomimic.github.io/docs/datasets/overview.html); the paper's code reads it.

    data                            attributes total, env_args (JSON: env_name, type, env_kwargs)
    data/demo_0                     attributes num_samples, model_file (MJCF), ep_meta (JSON: lang, seed, skeleton ...)
    data/demo_0/{actions, states, rewards, dones}       (T, ...); states: time, qpos, qvel
    data/demo_0/{obs, next_obs}/<name>                  (T, ...); images uint8 (T, height, width, 3), named <camera>_image
    mask/{train, valid}             names of demonstrations

`actions` are the labels. Besides, what only this program reads: `executed`, which differs from them where the arm was pushed on
purpose, and `initial_state`, all that MuJoCo needs to start the episode again exactly.
`obs/object` holds the positions of the movable things one after another. After the last step nothing was seen: it is its own
`next_obs`.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from optimus.data.atomic import require_free, written_aside
from optimus.data.episode import DEPTH_SUFFIX, IMAGE_SUFFIX, RENDERED
from optimus.data.episode_file import EpisodeHeader, read_episode
from optimus.data.store import installed_versions
from optimus.env import ManipulationEnv
from optimus.exchange.hdf5 import created
from optimus.exchange.selection import Selection, instruction_of, select
from optimus.exchange.states import environment, is_ours, states_of
from optimus.registration import made_by
from optimus.robots import Robot
from optimus.spec import world_spec

GYM_TYPE = 2
"""robomimic's `EnvType.GYM_TYPE`: its environments are made by `gym.make(env_name, **env_kwargs)`."""
OBJECT = "object"
"""robomimic's name for what is known of the objects: never a policy's input here."""
OWN = "optimus"
"""The attribute of `data` that holds, as JSON, what the format has no place for; `robomimic_import` takes it up."""


@dataclass(frozen=True)
class RobomimicConfig:
    """How to write the file."""

    everything: bool = False
    """Also the demonstrations that curation dropped; they are in no mask."""
    states: bool = True
    """Write the physics states."""
    next_obs: bool = True
    """Write `next_obs`, which doubles the file and which behaviour cloning does not read."""
    compress: bool = False
    """Images by gzip: a third of the size, several times slower to read."""
    overwrite: bool = False
    robot: Robot | None = None
    """That of the data set, where a robot file says which."""


def export_robomimic(
    dataset: Path, out: Path, config: RobomimicConfig | None = None, progress: Callable[[int, int], None] = lambda done, of: None
) -> dict[str, Any]:
    """Write the episodes, whole or not at all; `progress(done, all)` counts them. The answer says what was written."""
    config = config or RobomimicConfig()
    require_free(out, config.overwrite)
    selection = select(dataset, config.everything)
    env = environment(selection.store, config.robot)
    with written_aside(out, config.overwrite) as path, created(path) as file:
        data = file.create_group("data")
        for number, header in enumerate(selection.headers):
            _write_demo(data.create_group(f"demo_{number}"), header, env, config)
            progress(number + 1, len(selection.headers))
        data.attrs["total"] = selection.steps
        data.attrs["env_args"] = json.dumps(_env_args(selection))
        data.attrs[OWN] = json.dumps(_about(selection))
        _write_masks(file, selection)
        states = all("states" in demo for demo in data.values())
    split = {"train": len(selection.train), "valid": len(selection.validation)}
    has = {"states": states, "models": env is not None}
    return {"file": str(out), "demonstrations": len(selection.headers), "steps": selection.steps, **split, **has}


def _write_demo(group: h5py.Group, header: EpisodeHeader, env: ManipulationEnv | None, config: RobomimicConfig) -> None:
    episode = read_episode(header)
    last = np.zeros(len(episode), np.float64)
    last[-1] = 1.0
    # distances as pictures of one channel, as robomimic's depth is
    seen = {name: array[..., None] if name.endswith(DEPTH_SUFFIX) else array for name, array in episode.observations.items()}
    if episode.object_names:
        seen[OBJECT] = episode.objects.reshape(len(episode), -1)
    states = states_of(header, env) if config.states else None
    for name, array in {
        "actions": episode.actions,
        "executed": episode.executed,
        "initial_state": episode.initial_state,
        "rewards": last * episode.success,
        "dones": last.astype(np.int64),
        **({} if states is None else {"states": states}),
    }.items():
        group.create_dataset(name, data=array)
    for name, array in seen.items():
        _write_observation(group, f"obs/{name}", array, config.compress)
        if config.next_obs:
            _write_observation(group, f"next_obs/{name}", np.concatenate([array[1:], array[-1:]]), config.compress)
    group.attrs["num_samples"] = len(episode)
    group.attrs["ep_meta"] = json.dumps({"lang": instruction_of(header, env), **_episode_facts(header)})
    if env is not None:
        env.reset(seed=header.seed)
        group.attrs["model_file"] = world_spec(env.problem.scene).to_xml()


def _write_observation(group: h5py.Group, name: str, array: NDArray[Any], compress: bool) -> None:
    if compress and name.endswith(IMAGE_SUFFIX):  # one frame a chunk: a window's frames are read alone
        group.create_dataset(name, data=array, chunks=(1, *array.shape[1:]), compression="gzip", compression_opts=1)
    else:
        group.create_dataset(name, data=array)


def _episode_facts(header: EpisodeHeader) -> dict[str, Any]:
    """Besides `lang`, where RoboCasa's and robomimic's language-conditioned readers look for the instruction."""
    return {name: getattr(header, name) for name in ("seed", "agent", "success", "failure", "skeleton", "object_names", "info")}


def _env_args(selection: Selection) -> dict[str, Any]:
    store = selection.store
    name, task = made_by(store.task) if is_ours(store.task) else (store.task, {})
    foreign = store.config.get("env_args")
    if isinstance(foreign, dict):
        return foreign
    version = installed_versions()["optimus-tamp"]
    how = {"control": store.control, **{key: store.config[key] for key in ("robot", "gripper") if key in store.config}}
    if RENDERED in store.config and store.cameras:
        views = {view["name"]: view for view in store.views}
        how |= {"image_size": store.config[RENDERED]["size"], "cameras": [views.get(c, c) for c in store.cameras]}
    return {"env_name": name, "type": GYM_TYPE, "env_kwargs": {**task, **how}, "env_version": version}


def _about(selection: Selection) -> dict[str, Any]:
    store = selection.store
    return {"task": store.task, "cameras": list(store.cameras), "config": store.config, "versions": store.versions}


def _write_masks(file: h5py.File, selection: Selection) -> None:
    """Filter keys, as robomimic's own tool writes them: fixed-length byte strings. Without curation there are none."""
    for key, seeds in (("train", selection.train), ("valid", selection.validation)):
        if seeds:
            names = [f"demo_{n}" for n, header in enumerate(selection.headers) if header.seed in seeds]
            file.create_dataset(f"mask/{key}", data=np.array(names, dtype="S"))
