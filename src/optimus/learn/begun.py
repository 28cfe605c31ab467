"""What a run was begun with, and whether what is asked for now is the same."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from optimus.errors import CheckpointError
from optimus.learn.gradient import Runtime
from optimus.learn.policy import Policy, PolicyInputs
from optimus.learn.recipe import TrainConfig


def require_same_inputs(begun: Policy, inputs: PolicyInputs, run: Path | None) -> None:
    """`CheckpointError` if the policy that training is to begin with sees or does something else than the data."""
    have, wanted = asdict(begun.inputs), asdict(inputs)
    # what says most comes first: under another control everything else is different as well
    for what in dict.fromkeys(("control", "robot", *wanted)):
        if have[what] != wanted[what]:
            raise CheckpointError(f"{run} was trained with {what} = {have[what]!r}, not {wanted[what]!r} as the data; name another")


def train_described(there: dict[str, Any]) -> dict[str, Any]:
    """The settings that an earlier version recorded, with those that it had not yet, at what it did."""
    defaults = json.loads(json.dumps(asdict(TrainConfig())))
    whole = {k: {**v, **there.get(k, {})} if isinstance(v, dict) else there.get(k, v) for k, v in defaults.items()}
    return {**whole, "runtime": whole["runtime"] and asdict(Runtime(**whole["runtime"]))}


def require_same(run: Path, there: dict[str, Any], wanted: dict[str, Any]) -> None:
    """`CheckpointError` naming the first setting in which the run that is there differs."""
    have, want = _flat(there), _flat(wanted)
    for key in sorted(want):
        if have.get(key) != want[key]:
            raise CheckpointError(
                f"{run} was started with {key} = {have.get(key)!r}, not {want[key]!r}; "
                "use the same settings and data, or another folder"
            )


def _flat(value: Any, prefix: str = "") -> dict[str, Any]:
    if not isinstance(value, dict) or not value:
        return {prefix: value}
    return {k: v for name, part in value.items() for k, v in _flat(part, f"{prefix}.{name}" if prefix else name).items()}
