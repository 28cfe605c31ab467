"""A trained policy on disk: `config.json` says what it is, `model.safetensors` has weights and normalisation.

Plain JSON and safetensors only: loading one never runs code from the file.
"""

from __future__ import annotations

import filecmp
import hashlib
import json
import shutil
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError
from safetensors.torch import load as parse
from safetensors.torch import save as serialise
from torch import Tensor

from optimus.data.atomic import make_folder, write_json, write_whole
from optimus.data.episode import BINARY, OSC, TASKS_OWN
from optimus.errors import CheckpointError
from optimus.learn.policy import Policy

RUN_FORMAT = "optimus-run"
VERSION = 1
CONFIG_FILE = "config.json"
MODEL_FILE = "model.safetensors"
BEST_FOLDER = "best"
"""In a run's folder: the policy of the lowest held-out action error so far, a run folder to load from like any other."""


def joint_task(tasks: Iterable[str]) -> str:
    """The name under which a policy of several tasks is recorded."""
    return "+".join(dict.fromkeys(tasks))


def tasks_of(joint: str) -> tuple[str, ...]:
    """The inverse of `joint_task`."""
    return tuple(joint.split("+"))


def save_best(run: Path, policy: Policy, step: int, error: float) -> None:
    """Keep this policy as the best so far."""
    folder = run / BEST_FOLDER
    make_folder(folder)
    save(folder, policy)
    write_config(folder, {**read_config(run), "best": {"step": step, "held_out_action_error": error}})


def forget_best(run: Path) -> None:
    """Remove the best policy that is kept, if there is one."""
    shutil.rmtree(run / BEST_FOLDER, ignore_errors=True)


def best_step(run: Path) -> int | None:
    """The step of the best policy that is kept; None if there is none."""
    if not (run / BEST_FOLDER / CONFIG_FILE).exists():
        return None
    return int(read_config(run / BEST_FOLDER)["best"]["step"])


def best_is_last(run: Path) -> bool:
    """Whether the best policy that is kept is the last one, to the last bit."""
    return filecmp.cmp(run / MODEL_FILE, run / BEST_FOLDER / MODEL_FILE, shallow=False)


def weights_of(run: Path) -> str:
    """A name of the weights in a run's folder: the same one for the same weights alone; `CheckpointError` if there are none."""
    tensors, digest = read_tensors(run / MODEL_FILE), hashlib.sha256()
    for name in sorted(tensors):  # not the file's bytes: safetensors writes its header in any order
        digest.update(name.encode())
        digest.update(tensors[name].reshape(-1).view(torch.uint8).numpy().tobytes())
    return digest.hexdigest()[:12]


def gripper_of(run: Path) -> str:
    """How the gripper moved in the demonstrations that the policy of that run folder was trained on."""
    return read_config(run).get("dataset", {}).get("config", {}).get("gripper", BINARY)


def write_config(run: Path, config: Mapping[str, Any]) -> None:
    """Record what a run is."""
    write_json(run / CONFIG_FILE, {"format": RUN_FORMAT, "version": VERSION, **config})


def read_config(run: Path) -> dict[str, Any]:
    """What a run is."""
    file = run / CONFIG_FILE
    try:
        config = json.loads(file.read_text())
    except FileNotFoundError as error:
        raise CheckpointError(f"{run} holds no trained policy (no {CONFIG_FILE}); name the folder of a training run") from error
    except (OSError, ValueError) as error:
        raise CheckpointError(f"cannot read {file} ({error}); train again or name another run") from error
    if not isinstance(config, dict) or config.get("format") != RUN_FORMAT:
        raise CheckpointError(f"{file} does not describe a training run of this program; name another folder")
    if config.get("version") != VERSION:
        raise CheckpointError(f"{file} has version {config.get('version')!r}; this program reads version {VERSION}")
    return config


def save(run: Path, policy: Policy) -> None:
    """Write the weights of a policy, whole or not at all."""
    write_whole(
        run / MODEL_FILE,
        serialise(contiguous(policy.state_dict()), {"format": "pt", "task": policy.inputs.task}),
    )


def load(run: Path | str, task: str | None = None, control: str | None = None, robot: str | None = None) -> Policy:
    """The policy trained in the folder `run`; `CheckpointError` if it was for another task, control or robot (as recorded)."""
    run = Path(run)
    config = read_config(run)
    inputs = {"control": OSC, "robot": TASKS_OWN, **config.get("inputs", {})}
    for what, wanted in (("task", task), ("control", control), ("robot", robot)):
        have = inputs.get(what)
        if wanted is not None and wanted != have and not (what == "task" and wanted in tasks_of(str(have))):
            raise CheckpointError(f"{run} was trained for {what} {have!r}, not {wanted!r}; name a run of {wanted!r}")
    try:
        policy = Policy.from_description(config)
    except (KeyError, TypeError, ValueError) as error:
        raise CheckpointError(f"{run / CONFIG_FILE} does not describe a policy ({error}); train again") from error
    load_weights(policy, read_tensors(run / MODEL_FILE), run / MODEL_FILE)
    return policy.eval()


def read_tensors(file: Path) -> dict[str, Tensor]:
    """All tensors of a safetensors file."""
    try:
        return parse(file.read_bytes())
    except FileNotFoundError as error:
        raise CheckpointError(f"{file} is missing: training has not reached its first checkpoint; train on") from error
    except (OSError, SafetensorError) as error:
        raise CheckpointError(f"{file} is damaged ({error}); train again or name another run") from error


def load_weights(policy: Policy, tensors: Mapping[str, Tensor], file: Path) -> None:
    """Put tensors into a policy; `CheckpointError` if they are not exactly its own, or not finite."""
    own = policy.state_dict()
    for name in sorted(own.keys() | tensors.keys()):
        have = tuple(tensors[name].shape) if name in tensors else None
        want = tuple(own[name].shape) if name in own else None
        if have != want:
            raise CheckpointError(f"{file}: {name} has shape {have}, the policy of its {CONFIG_FILE} has {want}; train again")
        if not torch.isfinite(tensors[name]).all():
            raise CheckpointError(f"{file}: {name} holds NaN or infinity; train again")
    policy.load_state_dict(dict(tensors))


def contiguous(tensors: Mapping[str, Tensor]) -> dict[str, Tensor]:
    """The same tensors in the one memory layout that safetensors writes."""
    return {name: tensor.detach().contiguous() for name, tensor in tensors.items()}
