"""`Policy`: observations of a window -> distribution over the next action, with its normalisation inside."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Literal

import numpy as np
import torch
import torch.nn.functional as F
from torch import Tensor, nn

from optimus.data.episode import HAND, IMAGE_SIZE, OBJECT_POSITIONS, OBJECT_TURNS, OSC, TASKS_OWN, arm_parts
from optimus.data.windows import WindowConfig, Windows
from optimus.learn.encoder import Encoder, EncoderConfig, ResNetConfig, encoder_config
from optimus.learn.heads import Answers, Head, HeadConfig, MixtureConfig, head_config
from optimus.learn.trunk import TransformerConfig, Trunk, TrunkConfig, trunk_config

_SMALLEST_DEVIATION = 1e-3  # of proprioception [m or 1]: what hardly varies is not blown up
_SMALLEST_AIM = 0.03  # of where the hand goes [m or 1]


@dataclass(frozen=True)
class PolicyConfig:
    """The network, whatever the task."""

    context: int = 8
    """Frames that an action is a function of."""
    crop: int = 76
    """Side of the square that is seen of each image [pixels]."""
    encoder: EncoderConfig | ResNetConfig = field(default_factory=EncoderConfig)
    trunk: TrunkConfig = field(default_factory=TransformerConfig)
    head: HeadConfig = field(default_factory=MixtureConfig)
    observe: Literal["images", "state"] = "images"
    """See with cameras, or be told where the objects are (the paper's ablation)."""
    locates: bool = True
    """Whether an auxiliary head says where the objects are, given images."""
    aims: bool = True
    """Whether another says where the hand goes next, given images."""

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> PolicyConfig:
        """The inverse of `dataclasses.asdict`, from parsed JSON."""
        rest = {k: v for k, v in value.items() if k not in ("encoder", "trunk", "head")}
        rest = {"aims": False, **rest}  # earlier versions did not
        encoder, trunk = encoder_config(value["encoder"]), trunk_config(value["trunk"])
        return cls(**rest, encoder=encoder, trunk=trunk, head=head_config(value["head"]))

    def cut(self, windows: int = 1, change_weight: float = 1.0, change_reach: int = 2) -> WindowConfig:
        """What its windows are cut like, for training on."""
        ahead, images = self.head.chunk - 1, self.observe == "images"
        return WindowConfig(self.context, windows, self.crop, change_weight, change_reach, ahead, images)


@dataclass(frozen=True)
class PolicyInputs:
    """What a dataset decides about a policy."""

    task: str
    cameras: tuple[str, ...]
    proprioception: dict[str, int]
    """Name -> size."""
    objects: int
    """Positions that the auxiliary head can be taught."""
    actions: int = 7
    """Numbers in an action, the gripper's last."""
    control: str = OSC
    """What an action means: the way of control it was recorded with."""
    robot: str = TASKS_OWN
    """Whose arm it moves."""
    frame: tuple[int, int] | None = (IMAGE_SIZE, IMAGE_SIZE)
    """Height and width of the images [pixels], of which the middle is seen; None where cameras differ."""
    views: tuple[dict[str, Any], ...] = ()
    """Those of the cameras that the task's scene does not have, as `RENDERED` settings tell of them."""
    keypose: int = 0
    """Numbers that say where the hand goes next (`keyposes.py`), for a head that is taught so; 0 where nobody recorded it."""

    @property
    def told(self) -> bool:
        """Whether the policy is told how the objects lie, and looks at nothing."""
        return OBJECT_POSITIONS in self.proprioception

    @property
    def told_from_hand(self) -> int:
        """How many numbers say again how the objects lie, as the hand has them before it."""
        told = (self.proprioception.get(name, 0) for name in (OBJECT_POSITIONS, OBJECT_TURNS))
        return sum(told) if self.proprioception.keys() >= HAND else 0

    @property
    def arm_parts(self) -> tuple[slice, ...]:
        """The parts of an action that move the arm, each in one unit."""
        return arm_parts(self.control, self.actions)

    @classmethod
    def of(cls, task: str, windows: Windows, aims: bool = True) -> PolicyInputs:
        """The inputs that a dataset has, for a policy that `aims` or does not."""
        sizes = {name: array.shape[1] for name, array in windows.proprioception.items()}
        objects, actions = windows.objects.shape[1], windows.actions.shape[1]
        frames = set(windows.frame_shapes.values()) or {cls.frame}
        frame = frames.pop() if len(frames) == 1 else None
        keypose = aims * windows.keyposes.shape[1]
        return cls(task, windows.cameras, sizes, objects, actions, windows.control, windows.robot, frame, windows.views, keypose)

    @classmethod
    def from_json(cls, value: Mapping[str, Any]) -> PolicyInputs:
        """The inverse of `dataclasses.asdict`, from parsed JSON."""
        frame = value.get("frame", cls.frame)
        lists = {name: tuple(value.get(name, ())) for name in ("cameras", "views")}
        return cls(**{**value, **lists, "frame": frame and (frame[0], frame[1])})


class Policy(nn.Module):
    """Frame features (one encoder a camera, proprioception) -> tokens -> trunk -> head."""

    low_mean: Tensor
    low_deviation: Tensor
    objects_mean: Tensor
    objects_deviation: Tensor
    keypose_mean: Tensor
    keypose_deviation: Tensor
    action_scale: Tensor

    def __init__(self, config: PolicyConfig, inputs: PolicyInputs) -> None:
        super().__init__()
        self.config, self.inputs = config, inputs
        self.encoders = nn.ModuleDict({camera: Encoder(config.encoder) for camera in inputs.cameras})
        low = sum(_width(name, n) for name, n in inputs.proprioception.items()) + inputs.told_from_hand
        self.looked = config.encoder.features * len(inputs.cameras)
        seen = self.looked + low
        # Where the objects are said to be, and where the hand goes next, is told to the trunk outright, at unit scale: it is in
        # the features too, but small among them, and took the trunk many times as many steps to find there.
        self.locates = config.locates and bool(inputs.cameras) and inputs.objects > 0  # imported data may know of no objects
        self.aims = config.aims and bool(inputs.cameras) and inputs.keypose > 0
        says = 3 * inputs.objects * self.locates + inputs.keypose * self.aims
        self.embed = nn.Linear(seen + says, config.trunk.token)
        self.trunk: Trunk = config.trunk.build(config.context)
        self.head: Head = config.head.build(config.trunk.width, inputs.actions)
        # From the images alone: the hand is where the object is for most of an episode, and told where the hand is, this
        # would never learn to look (docs/results/first-policies.md).
        self.locate = _says(self.looked, 3 * inputs.objects * self.locates)
        self.aim = _says(self.looked, inputs.keypose * self.aims)
        for name, size in (("low", low), ("objects", 3 * inputs.objects), *([("keypose", inputs.keypose)] if self.aims else [])):
            self.register_buffer(f"{name}_mean", torch.zeros(size))
            self.register_buffer(f"{name}_deviation", torch.ones(size))
        self.register_buffer("action_scale", torch.ones(inputs.actions))
        self.to(memory_format=torch.channels_last)  # type: ignore[call-overload]

    def fit_normalisation(self, windows: Windows) -> None:
        """Set the normalisation statistics from all steps of some episodes."""
        low = self._low({n: torch.from_numpy(a) for n, a in windows.proprioception.items()}).double()
        objects = torch.from_numpy(windows.objects).flatten(1).double()
        aims = [("keypose", torch.from_numpy(windows.keyposes).double(), _SMALLEST_AIM)] if self.aims else []
        for name, values, least in (("low", low, _SMALLEST_DEVIATION), ("objects", objects, _SMALLEST_DEVIATION), *aims):
            mean = values.nanmean(0)
            deviation = (values - mean).square().nanmean(0).sqrt()
            getattr(self, f"{name}_mean").copy_(mean)
            getattr(self, f"{name}_deviation").copy_(deviation.clamp(min=least))
        # One scale for all of position and one for all of rotation (or one for all joints), so that directions are kept; +-0.9
        # because the means pass through a tanh. The gripper is +-1 already.
        largest = np.abs(windows.actions).max(0)
        for part in self.inputs.arm_parts:
            self.action_scale[part] = float(largest[part].max()) / 0.9 if largest[part].max() > 1e-6 else 1.0
        self.head.fit(self.normalise(torch.from_numpy(windows.actions)).numpy())

    def frames(
        self,
        images: Mapping[str, Tensor],
        proprioception: Mapping[str, Tensor],
        shifts: Mapping[str, Tensor] | None = None,
        half: bool = False,
    ) -> Tensor:
        """Features of frames seen one by one.

        Images `(..., crop, crop, 3)` uint8 by camera and proprioception `(..., n)` by name to `(..., m)`;
        `shifts` `(..., 2)` by camera say where the crops were taken, in the centre if there are none.
        """
        shape = next(iter(proprioception.values())).shape[:-1]
        seen = []
        for camera in self.inputs.cameras:
            shift = None if shifts is None else shifts[camera].flatten(0, -2)
            seen.append(self.encoders[camera](images[camera].flatten(0, -4), shift, half).reshape(*shape, -1))
        low = (self._low(proprioception) - self.low_mean) / self.low_deviation
        return torch.cat([*seen, low.clamp(-5, 5)], -1)

    def tokens(self, frames: Tensor) -> Tensor:
        """Frame features `(..., m)` to tokens `(..., width)`."""
        says = [head(frames) for head, used in ((self.located, self.locates), (self.aimed, self.aims)) if used]
        return self.embed(torch.cat([frames, *(said.detach().clamp(-5, 5) for said in says)], -1))

    def token(self, images: Mapping[str, Tensor], proprioception: Mapping[str, Tensor]) -> Tensor:
        """Images `(1, crop, crop, 3)` uint8 by camera and proprioception `(1, n)` by name of a frame to its token `(1, token)`."""
        return self.tokens(self.frames(images, proprioception))

    def features(self, tokens: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """Tokens `(B, C, width)` of windows to features of each position `(B, C, width)`."""
        return self.trunk(tokens, noise)

    def answers(self, features: Tensor) -> Answers:
        """Features to a distribution over normalised actions."""
        return self.head(features)

    def normalise(self, actions: Tensor) -> Tensor:
        """Actions `(..., n)` to what the head is taught."""
        return actions / self.action_scale

    def denormalise(self, actions: Tensor) -> Tensor:
        """The inverse of `normalise`."""
        return actions * self.action_scale

    def located(self, frames: Tensor) -> Tensor:
        """Frame features `(..., m)` to normalised positions of the objects `(..., 3 k)`."""
        return self.locate(frames[..., : self.looked])

    def location_error(self, frames: Tensor, objects: Tensor) -> Tensor:
        """Smooth absolute error `(...)` of positions, from frame features and `(..., k, 3)` [m]; NaN is nothing to err about."""
        target = (objects.flatten(-2) - self.objects_mean) / self.objects_deviation
        there = target.isfinite()
        error = F.smooth_l1_loss(self.located(frames), target.where(there, 0.0), reduction="none", beta=0.1)
        return (error * there).sum(-1) / there.sum(-1).clamp(min=1)

    def aimed(self, frames: Tensor) -> Tensor:
        """Frame features `(..., m)` to the normalised keypose `(..., 12)`."""
        return self.aim(frames[..., : self.looked])

    def aim_error(self, frames: Tensor, keyposes: Tensor) -> Tensor:
        """Smooth absolute error `(...)` of where the hand is said to go, from frame features and keyposes `(..., 12)`."""
        target = (keyposes - self.keypose_mean) / self.keypose_deviation
        return F.smooth_l1_loss(self.aimed(frames), target, reduction="none", beta=0.1).mean(-1)

    @property
    def parameter_count(self) -> int:
        """Numbers that are learned."""
        return sum(p.numel() for p in self.parameters())

    def description(self) -> dict[str, Any]:
        """What `Policy.from_description` needs, JSON-able."""
        return {"policy": asdict(self.config), "inputs": asdict(self.inputs)}

    @classmethod
    def from_description(cls, value: Mapping[str, Any]) -> Policy:
        """A policy of this shape, with weights yet to be loaded."""
        return cls(PolicyConfig.from_json(value["policy"]), PolicyInputs.from_json(value["inputs"]))

    @classmethod
    def described(cls, value: Mapping[str, Any]) -> dict[str, Any]:
        """A description that an earlier version wrote, with what it could not yet say, JSON-able."""
        policy, inputs = PolicyConfig.from_json(value["policy"]), PolicyInputs.from_json(value["inputs"])
        return json.loads(json.dumps({"policy": asdict(policy), "inputs": asdict(inputs)}))

    def _low(self, proprioception: Mapping[str, Tensor]) -> Tensor:
        """Low-dimensional observations in one vector; quaternions as two columns of their rotation matrix."""
        parts = [(name, proprioception[name]) for name in self.inputs.proprioception]
        seen = [_two_columns(x) if _is_quaternion(name) else x for name, x in parts]
        if self.inputs.told_from_hand:
            seen.append(_from_hand(proprioception))
        return torch.cat(seen, -1)


def _from_hand(told: Mapping[str, Tensor]) -> Tensor:
    """How the objects lie, as the hand has them before it: their places [m], and the columns that say how they are turned."""
    columns = _two_columns(told["robot0_eef_quat"]).unflatten(-1, (2, 3))
    third = torch.linalg.cross(columns[..., 0, :], columns[..., 1, :])
    to_base = torch.stack([columns[..., 0, :], columns[..., 1, :], third], -1)
    vectors = [told[OBJECT_POSITIONS].unflatten(-1, (-1, 3)) - told["robot0_eef_pos"][..., None, :]]
    if OBJECT_TURNS in told:
        vectors.append(told[OBJECT_TURNS].unflatten(-1, (-1, 3)))
    return (torch.cat(vectors, -2) @ to_base).flatten(-2)


def _says(looked: int, numbers: int) -> nn.Sequential:
    """What decodes so many numbers from what is seen; nothing if there are none."""
    return nn.Sequential(nn.Linear(looked, 128), nn.GELU(), nn.Linear(128, numbers)) if numbers else nn.Sequential()


def _is_quaternion(name: str) -> bool:
    return name.endswith("_quat")


def _width(name: str, size: int) -> int:
    return 6 if _is_quaternion(name) else size


def _two_columns(quaternion: Tensor) -> Tensor:
    """xyzw `(..., 4)` to the first two columns of the rotation matrix `(..., 6)`: as of `-q`."""
    x, y, z, w = F.normalize(quaternion, dim=-1).unbind(-1)
    first = (1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w))
    second = (2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w))
    return torch.stack([*first, *second], -1)
