"""A policy's folder at half its size: what cannot be carried otherwise. It loads and acts like any other."""

from __future__ import annotations

from pathlib import Path

import torch
from safetensors.torch import save as serialise

from optimus.data.atomic import make_folder, write_whole
from optimus.learn import checkpoint


def shrink(run: Path, out: Path) -> None:
    """Write the policy of `run` to the folder `out`, its weights in bfloat16; normalisation and whatever else is small keeps its
    precision. `CheckpointError` if `run` holds no policy."""
    policy = checkpoint.load(run)
    weights = {name for name, p in policy.named_parameters() if p.ndim > 1}
    tensors = checkpoint.contiguous(policy.state_dict())
    small = {name: t.to(torch.bfloat16) if name in weights else t for name, t in tensors.items()}
    make_folder(out)
    write_whole(out / checkpoint.MODEL_FILE, serialise(small, {"format": "pt", "task": policy.inputs.task}))
    checkpoint.write_config(out, {**checkpoint.read_config(run), "shrunk": "weights in bfloat16"})
