"""robomimic's HDF5 files, whoever made them, as a data set of this program's own."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from optimus.data.atomic import require_free, write_json, written_aside
from optimus.data.curate import CURATION_FILE
from optimus.data.episode import CONTINUOUS, IMAGE_SUFFIX, IMPORTED, INSTRUCTION, PROPRIOCEPTION, RENDERED, Episode
from optimus.data.store import DESCRIPTION, EpisodeStore
from optimus.errors import DatasetError
from optimus.exchange.hdf5 import facts, group_in, names, names_in, numbers, opened, plain_dataset
from optimus.exchange.robomimic import OBJECT, OWN
from optimus.exchange.selection import environment_settings

JOINTS = ("robot0_joint_pos", "robot0_joint_target_error")
"""Low-dimensional observations of this program's own files under joint control, besides `PROPRIOCEPTION`."""


@dataclass(frozen=True)
class RobomimicSource:
    """What to take from the file."""

    observations: tuple[str, ...] = ()
    """Names of low-dimensional observations, besides those of `PROPRIOCEPTION` that all demonstrations have."""
    instruction: str = ""
    """What was wanted, in plain English, for demonstrations that do not say it."""
    overwrite: bool = False


def import_robomimic(
    file: Path, out: Path, source: RobomimicSource | None = None, progress: Callable[[int, int], None] = lambda done, of: None
) -> dict[str, Any]:
    """Write the file's demonstrations as a data set, whole or not at all; its masks become the curation.

    Images are the uint8 arrays `(T, height, width, 3)` among the observations. Errors: `DatasetError` names what is missing, of
    another shape, not finite or not plain numbers.
    """
    source = source or RobomimicSource()
    require_free(out, source.overwrite, DESCRIPTION)
    with opened(file) as opened_file:
        data = group_in(opened_file, "data")
        demos = _demos(data)
        low, images = _observations(data, demos, source)
        with written_aside(out, source.overwrite, DESCRIPTION) as folder:
            store = EpisodeStore.create(folder, *_description(data, demos, images))
            # in the order that a file of this program's own says
            images.sort(key=lambda name: [*store.cameras, name.removesuffix(IMAGE_SUFFIX)].index(name.removesuffix(IMAGE_SUFFIX)))
            seeds: dict[str, int] = {}
            for name, number in demos.items():
                episode = _episode(group_in(data, name), store.task, number, low, images, source)
                if episode.seed in seeds.values():
                    raise DatasetError(f"{file}: two demonstrations were made from seed {episode.seed}")
                store.write(episode)
                seeds[name] = episode.seed
                progress(len(seeds), len(demos))
            split = _write_curation(opened_file, folder, store.task, seeds)
    return {"dataset": str(out), "task": store.task, "demonstrations": len(demos), **split, "observations": [*low, *images]}


def _demos(data: h5py.Group) -> dict[str, int]:
    """Names of the demonstrations and their numbers, ascending; counted from 0 where names do not number them."""
    found = [name for name in names_in(data) if isinstance(data[name], h5py.Group)]
    if not found:
        raise DatasetError(f"{data.file.filename}: its group data holds no demonstrations; it is not a robomimic data set")
    ends = {name: int(m.group()) for name in found if (m := re.search(r"\d+$", name))}
    if len(set(ends.values())) < len(found):
        return {name: number for number, name in enumerate(sorted(found))}
    return dict(sorted(ends.items(), key=lambda item: item[1]))


def _observations(data: h5py.Group, demos: Iterable[str], source: RobomimicSource) -> tuple[list[str], list[str]]:
    """Names of the low-dimensional observations and of the images to take: what every demonstration has."""
    common: set[str] | None = None
    for demo in demos:
        here = set(names_in(group_in(group_in(data, demo), "obs")))
        common = here if common is None else common & here
    first = group_in(group_in(data, next(iter(demos))), "obs")
    shapes = {name: plain_dataset(first, name) for name in sorted(common or ())}
    images = [name for name, a in shapes.items() if a.dtype == np.uint8 and a.ndim == 4 and a.shape[-1] == 3]
    numeric = [name for name, a in shapes.items() if a.ndim == 2 and a.dtype.kind == "f"]
    usual = (*PROPRIOCEPTION, *JOINTS) if facts(data, OWN) else tuple(PROPRIOCEPTION)
    low = list(dict.fromkeys([*(name for name in usual if name in numeric), *source.observations]))
    if unknown := [name for name in low if name not in numeric]:
        raise DatasetError(f"{data.file.filename} has no observation {', '.join(unknown)}; it has {', '.join(numeric) or 'none'}")
    if not low:
        others = ", ".join(numeric) or "none"
        raise DatasetError(f"{data.file.filename} has none of {', '.join(usual)}; name some with --observations: {others}")
    return low, images


def _description(data: h5py.Group, demos: Iterable[str], images: Iterable[str]) -> tuple[str, list[str], dict[str, Any]]:
    """The data set's task, cameras and settings; a file of this program's own says them itself."""
    cameras = [name.removesuffix(IMAGE_SUFFIX) for name in images]
    own, env_args = facts(data, OWN), facts(data, "env_args")
    if own:
        return own["task"], [c for c in own["cameras"] if c in cameras], _without_maps(own["config"])
    config: dict[str, Any] = {IMPORTED: "robomimic", "env_args": env_args}
    controller = environment_settings(env_args).get("controller_configs")
    if isinstance(controller, Mapping) and controller.get("type") == "OSC_POSE" and np.size(controller.get("output_max", ())):
        config["position_scale"] = float(np.ravel(controller["output_max"])[0])  # robosuite: metres for an action of 1
    task = str(env_args.get("env_name", "unknown"))
    if ":" in task:
        raise DatasetError(f"{data.file.filename} calls its task {task!r}, a Python module: no foreign file may name one")
    if not all(np.isin(np.abs(numbers(group_in(data, demo), "actions")[..., -1:]), 1.0).all() for demo in demos):
        config["gripper"] = CONTINUOUS
    return task, cameras, config


def _without_maps(config: Mapping[str, Any]) -> dict[str, Any]:
    """The settings of a data set whose distances and segmentation are not taken."""
    rendered = {RENDERED: {**config[RENDERED], "depth": False, "segmentation": False}} if RENDERED in config else {}
    return {**config, **rendered}


def _episode(
    demo: h5py.Group, task: str, number: int, low: list[str], images: list[str], source: RobomimicSource
) -> Episode:
    actions = numbers(demo, "actions").astype(np.float32)
    if actions.ndim != 2 or not len(actions):
        raise DatasetError(f"{demo.file.filename}: {demo.name}/actions has shape {actions.shape}, not (steps, numbers)")
    steps, obs, about = len(actions), group_in(demo, "obs"), facts(demo, "ep_meta")
    here = names_in(demo)
    states = numbers(demo, "states", steps).astype(np.float64) if "states" in here else None
    start = np.zeros(0) if states is None else states[0]
    if "initial_state" in here:
        start = numbers(demo, "initial_state").ravel()
    objects, object_names = _objects(obs, about, steps)
    success = _success(demo, about, steps)
    observations = {name: numbers(obs, name, steps).astype(np.float32) for name in low}
    for name in images:
        observations[name.removesuffix(IMAGE_SUFFIX) + IMAGE_SUFFIX] = numbers(obs, name, steps)  # type: ignore[assignment]
    own = about.get("info", {})
    told = about.get("lang") or own.get(INSTRUCTION) or source.instruction
    return Episode(
        task=task,
        seed=int(about.get("seed", number)),
        agent=str(about.get("agent", "demonstrator")),
        observations=observations,
        actions=actions,
        executed=numbers(demo, "executed", steps).astype(np.float32) if "executed" in here else actions.copy(),
        initial_state=start.astype(np.float64),
        objects=objects,
        object_names=object_names,
        success=success,
        failure="" if success else str(about.get("failure") or "no reward"),
        skeleton=tuple(about.get("skeleton", ())),
        info={**own, **({INSTRUCTION: told} if told else {}), "demo": str(demo.name).rsplit("/", 1)[-1]},
        states=states,
    )


def _objects(obs: h5py.Group, about: Mapping[str, Any], steps: int) -> tuple[NDArray[np.float32], tuple[str, ...]]:
    """Positions of the objects and their names, where the file says which numbers are whose: robomimic itself leaves that open."""
    wanted = tuple(about.get("object_names", ()))
    if wanted and OBJECT in names_in(obs):
        flat = numbers(obs, OBJECT, steps)
        if flat.shape == (steps, 3 * len(wanted)):
            return flat.astype(np.float32).reshape(steps, -1, 3), wanted
    return np.zeros((steps, 0, 3), np.float32), ()


def _success(demo: h5py.Group, about: Mapping[str, Any], steps: int) -> bool:
    """As the file says it; else by its reward, which is above 0 from success on; without any, demonstrations are successes."""
    if "success" in about:
        return bool(about["success"])
    return "rewards" not in names_in(demo) or bool(numbers(demo, "rewards", steps).max() > 0)


def _write_curation(file: h5py.File, folder: Path, task: str, seeds: Mapping[str, int]) -> dict[str, int]:
    """The masks train and valid as this program's curation; without both, the data set is yet to be curated."""
    masks = group_in(file, "mask") if "mask" in names_in(file) else None
    if masks is None or not {"train", "valid"} <= set(names_in(masks)):
        return {"train": 0, "valid": 0}
    split = {key: sorted(seeds[name] for name in names(masks, key) if name in seeds) for key in ("train", "valid")}
    if both := set(split["train"]) & set(split["valid"]):
        raise DatasetError(f"{file.filename}: its masks train and valid share demonstrations {sorted(both)}")
    kept = {*split["train"], *split["valid"]}
    record = {
        "task": task,
        "config": {IMPORTED: "robomimic"},
        "train": split["train"],
        "validation": split["valid"],
        "dropped": {str(seed): "in no mask" for seed in seeds.values() if seed not in kept},
    }
    write_json(folder / CURATION_FILE, record)
    return {key: len(chosen) for key, chosen in split.items()}
