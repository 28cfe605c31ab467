"""Batches where the policy is: cut from the files and sent there, or cut there from a data set that is kept there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np
import torch
from torch import Tensor

from optimus.data.frames import Frames
from optimus.data.windows import Batch, Windows

_MEMORY_SHARE = 0.7
"""Of a GPU's free memory, at most, for the data set."""


@dataclass(frozen=True, eq=False)
class TensorBatch:
    """A `Batch` of tensors on one device."""

    images: dict[str, Tensor]
    shifts: dict[str, Tensor]
    proprioception: dict[str, Tensor]
    actions: Tensor
    weight: Tensor
    objects: Tensor
    keyposes: Tensor
    ahead: Tensor

    @property
    def labels(self) -> Tensor:
        """What a head is taught at each frame: the action `(B, F, n)`, or where it answers in chunks `(B, F, chunk, n)`."""
        return torch.cat([self.actions[:, :, None], self.ahead], 2) if self.ahead.shape[2] else self.actions


class BatchSource(Protocol):
    """`Windows`, or the same resident on a device."""

    def sample(self, rng: np.random.Generator, runs: int) -> Batch | TensorBatch:
        """Runs drawn uniformly, cropped anywhere; a function of the generator's state alone."""
        ...


def on_device(batch: Batch | TensorBatch, device: torch.device) -> TensorBatch:
    """The same batch as tensors on that device; nothing is copied that is there already."""
    if isinstance(batch, TensorBatch):
        return batch
    send = lambda array: torch.from_numpy(array).to(device)  # noqa: E731
    images, shifts, low = (
        {name: send(array) for name, array in arrays.items()}
        for arrays in (batch.images, batch.shifts, batch.proprioception)
    )
    names = ("actions", "weight", "objects", "keyposes", "ahead")
    return TensorBatch(images, shifts, low, *(send(getattr(batch, name)) for name in names))


class ResidentWindows:
    """All frames of some `Windows` on one device, images as uint8. What it samples is, bit for bit, what they would."""

    def __init__(self, windows: Windows, device: torch.device) -> None:
        self._windows, self._device = windows, device
        self._images = {c: self._joined([t.images[c] for t in windows.tracks]) for c in windows.cameras}
        self._low = {name: self._there(values) for name, values in windows.proprioception.items()}
        self._actions, self._weight = self._there(windows.actions), self._there(windows.weight)
        self._objects, self._keyposes = self._there(windows.objects), self._there(windows.keyposes)

    def _joined(self, parts: list[Frames]) -> Tensor:
        """One after the other; put in place one by one, for there is no room for them twice."""
        whole = torch.empty((sum(p.shape[0] for p in parts), *parts[0].shape[1:]), dtype=torch.uint8, device=self._device)
        begin = 0
        for part in parts:
            whole[begin : begin + part.shape[0]] = torch.from_numpy(np.array(part))
            begin += part.shape[0]
        return whole

    def sample(self, rng: np.random.Generator, runs: int) -> TensorBatch:
        """See `Windows.sample`."""
        return self.cut({name: tensor.to(self._device) for name, tensor in self.drawn(rng, runs).items()})

    def drawn(self, rng: np.random.Generator, runs: int) -> dict[str, Tensor]:
        """What decides about a sample, a few numbers a frame, by name: all that has to be sent to the device for it."""
        windows = self._windows
        places = windows.places(rng.integers(len(windows), size=runs))
        offsets = windows.offsets(runs, rng)
        found = {"frames": places.steps, "following": places.following, "inside": places.inside}
        found |= {f"corners {camera}": corners for camera, corners in offsets.items()}
        found |= {f"shifts {camera}": shifts for camera, shifts in windows.shifts(offsets).items()}
        return {name: torch.from_numpy(array) for name, array in found.items()}

    def cut(self, drawn: Mapping[str, Tensor]) -> TensorBatch:
        """The sample that `drawn`, on the device, decides: gathers alone, so that it can be recorded (`recording.py`)."""
        frames = drawn["frames"]
        return TensorBatch(
            images={c: self._crops(c, frames, drawn[f"corners {c}"]) for c in self._images},
            shifts={c: drawn[f"shifts {c}"] for c in self._images},
            proprioception={name: values[frames] for name, values in self._low.items()},
            actions=self._actions[frames],
            weight=self._weight[frames] * drawn["inside"],
            objects=self._objects[frames],
            keyposes=self._keyposes[frames],
            ahead=self._actions[drawn["following"]],
        )

    def _there(self, array: np.ndarray) -> Tensor:
        return torch.from_numpy(array).to(self._device)

    def _crops(self, camera: str, frames: Tensor, corners: Tensor) -> Tensor:
        """The frames `(B, F)`, each run cropped at its corner `(B, 2)`: `(B, F, side, side, 3)`."""
        side = torch.arange(self._windows.config.crop, device=self._device)
        rows, columns = (corners[:, axis, None] + side for axis in (0, 1))
        return self._images[camera][frames[:, :, None, None], rows[:, None, :, None], columns[:, None, None, :]]


def source_on(windows: Windows, device: torch.device) -> BatchSource:
    """The windows, resident on a GPU if they fit there."""
    if device.type != "cuda":
        return windows
    needed = sum(images.nbytes for track in windows.tracks for images in track.images.values())
    free, _ = torch.cuda.mem_get_info(device)
    return ResidentWindows(windows, device) if needed < _MEMORY_SHARE * free else windows
