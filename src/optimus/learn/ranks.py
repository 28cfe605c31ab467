"""`Ranks`: the processes that train one policy together, started by `torchrun` on one machine or several.

Each computes its part of every batch; the gradient is averaged over them, and each takes the same step with the same weights.
Only the first, rank 0, writes files. Nothing is pickled: what they agree on travels as JSON and as tensors.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import torch
import torch.distributed as dist
from torch import Tensor

from optimus.errors import OptimusError


class DeviceError(OptimusError):
    """A device or a number of processes that is not there."""


@dataclass(frozen=True)
class Ranks:
    """This process among those that train together; by default it is alone."""

    rank: int = 0
    count: int = 1
    on_this_machine: int = 1
    device: torch.device = field(default_factory=lambda: torch.device("cpu"))

    @property
    def first(self) -> bool:
        """Whether this process writes files."""
        return self.rank == 0

    def average(self, tensors: Sequence[Tensor]) -> None:
        """Replace each tensor by its mean over the processes, which all get the same bits."""
        if self.count == 1:
            return
        for dtype in {t.dtype: None for t in tensors}:
            of_type = [t for t in tensors if t.dtype == dtype]
            flat = torch.cat([t.reshape(-1) for t in of_type]).to(self.device)
            dist.all_reduce(flat)
            flat.div_(self.count)
            for tensor, part in zip(of_type, flat.split([t.numel() for t in of_type]), strict=True):
                tensor.copy_(part.view(tensor.shape))

    def take_firsts(self, tensors: Iterable[Tensor]) -> None:
        """Replace each tensor by the first process's."""
        if self.count == 1:
            return
        for tensor in tensors:
            sent = tensor.detach().contiguous().to(self.device)
            dist.broadcast(sent, 0)
            tensor.detach().copy_(sent)

    def agree(self, value: Any) -> Any:
        """The first process's JSON-able value."""
        if self.count == 1:
            return value
        text = bytearray(json.dumps(value).encode())
        size = torch.tensor([len(text)], device=self.device)
        dist.broadcast(size, 0)
        sent = torch.frombuffer(text, dtype=torch.uint8) if self.first else torch.empty(int(size), dtype=torch.uint8)
        sent = sent.to(self.device)
        dist.broadcast(sent, 0)
        return json.loads(bytes(sent.cpu().numpy()))


@contextmanager
def joined(device: str) -> Iterator[Ranks]:
    """The processes that `torchrun` started together with this one, or this one alone; they part at the end.

    `device` is `auto`, `cpu` or `cuda`; `DeviceError` if that is not there.
    """
    kind = device_kind(device)
    count, local = int(os.environ.get("WORLD_SIZE", "1")), int(os.environ.get("LOCAL_RANK", "0"))
    if kind == "cuda" and local >= torch.cuda.device_count():
        raise DeviceError(f"process {local} of this machine has no GPU: there are {torch.cuda.device_count()}; start fewer")
    where = torch.device("cuda", local) if kind == "cuda" else torch.device("cpu")
    if count == 1:
        yield Ranks(device=where)
        return
    if kind == "cuda":
        torch.cuda.set_device(where)
    dist.init_process_group("nccl" if kind == "cuda" else "gloo")
    try:
        yield Ranks(dist.get_rank(), count, int(os.environ.get("LOCAL_WORLD_SIZE", "1")), where)
    finally:
        dist.destroy_process_group()


def is_first() -> bool:
    """Whether this process is the one that speaks: rank 0, or alone."""
    return int(os.environ.get("RANK", "0")) == 0


def device_kind(asked: str) -> str:
    """`cpu` or `cuda`, for `auto`, `cpu` or `cuda`."""
    if asked not in ("auto", "cpu", "cuda"):
        raise DeviceError(f"unknown device {asked!r}; valid: auto, cpu, cuda")
    if asked == "cuda" and not torch.cuda.is_available():
        raise DeviceError("PyTorch finds no GPU here; use --device cpu, or install a build of torch for this GPU")
    return "cuda" if asked != "cpu" and torch.cuda.is_available() else "cpu"
