"""Everything that the next training step depends on, and its file.

`train_state/<step>.safetensors` holds weights, running average and optimiser moments, with step and plan in
its header: one file, renamed into place, so that a run killed at any moment has a whole one.
"""

from __future__ import annotations

import copy
import json
import re
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save as serialise
from torch import Tensor, nn
from torch.optim.adamw import adamw

from optimus.data.atomic import make_folder, remove_leftovers, write_whole
from optimus.errors import CheckpointError, require_below_one
from optimus.learn.checkpoint import contiguous, load_weights, read_tensors
from optimus.learn.policy import Policy
from optimus.learn.ranks import Ranks
from optimus.learn.schedule import StepPlan

_NAME = re.compile(r"(\d{8,})\.safetensors")
_FORMAT = "optimus-train-state"
_MOMENTS = ("exp_avg", "exp_avg_sq")


@dataclass(frozen=True)
class OptimiserConfig:
    """AdamW, clipped, with a running average of the weights."""

    weight_decay: float = 0.01
    """On matrices and convolutions only, unless `decay_all`."""
    decay_all: bool = False
    clip: float = 1.0
    """Largest norm of the gradient: of what looks (encoders, auxiliary heads) and of what acts, each by itself. The likelihood's
    gradient varies by orders of magnitude; clipped together, it would drown what little the eyes are taught."""
    clip_apart: bool = True
    """False: of the whole gradient at once."""
    average: float = 0.995
    """Decay of the running average, which is the policy that is kept; 0 keeps the newest weights."""

    def __post_init__(self) -> None:
        require_below_one(ema=self.average)


class TrainState:
    """Weights, their running average, optimiser moments, step, plan, and the training time consumed."""

    def __init__(self, policy: Policy, config: OptimiserConfig, plan: StepPlan) -> None:
        self.policy, self.config, self.plan = policy, config, plan
        self.average = copy.deepcopy(policy).requires_grad_(False)
        self.step, self.seconds = 0, 0.0
        self._parameters = {name: p for name, p in policy.named_parameters() if p.requires_grad}
        self._moments = {name: {moment: torch.zeros_like(p) for moment in _MOMENTS} for name, p in self._parameters.items()}
        looks = {id(p) for part in (policy.encoders, policy.locate, policy.aim) for p in part.parameters()}
        acts = [p for p in self._parameters.values() if id(p) not in looks]
        together = [p for p in self._parameters.values() if id(p) in looks]
        clipped_apart = [part for part in (together, acts) if part]
        self._clipped = clipped_apart if config.clip_apart else [list(self._parameters.values())]
        decayed = {name: p.ndim >= 2 or config.decay_all for name, p in self._parameters.items()}
        self._decays = [(config.weight_decay, [name for name, so in decayed.items() if so])]
        self._decays.append((0.0, [name for name, so in decayed.items() if not so]))

    def update(self, gradient: list[Tensor], rate: float) -> Tensor:
        """Take one step down the gradient; the norms before clipping of its parts are returned, `(1,)` or `(2,)`."""
        for parameter, g in zip(self._parameters.values(), gradient, strict=True):
            parameter.grad = g
        norms = torch.stack([nn.utils.clip_grad_norm_(part, self.config.clip) for part in self._clipped])
        with torch.no_grad():
            self._descend(rate)
        self.step += 1
        # Early on a short memory: the first weights are random and not worth averaging in.
        decay = min(self.config.average, (1 + self.step) / (10 + self.step))
        with torch.no_grad():
            torch._foreach_lerp_(  # pyright: ignore[reportPrivateImportUsage]
                list(self.average.parameters()), list(self.policy.parameters()), 1 - decay
            )
        return norms

    def _descend(self, rate: float) -> None:
        """AdamW by its functional form: the first `torch.optim.Optimizer` of a process loads the compiler, in 3 s of CPU.

        Never `fused=True`: on a CPU it pairs weights and gradients by their place in memory, and a channels-last convolution whose
        gradient is not channels last is moved in scrambled directions, without a word (PyTorch 2.13).
        """
        for decay, names in self._decays:
            weights: list[Tensor] = [self._parameters[name] for name in names]
            gradient = [weight.grad for weight in weights if weight.grad is not None]
            averages, squares = ([self._moments[name][moment] for name in names] for moment in _MOMENTS)
            steps = [torch.tensor(float(self.step)) for _ in names]
            usual = {"beta1": 0.9, "beta2": 0.999, "eps": 1e-8, "amsgrad": False, "maximize": False}
            adamw(weights, gradient, averages, squares, [], steps, foreach=True, lr=rate, weight_decay=decay, **usual)

    def save(self, folder: Path) -> None:
        """Write the state, then delete the older ones."""
        make_folder(folder)
        payload = serialise(contiguous(self._tensors()), {"format": _FORMAT, "state": json.dumps(self._facts())})
        newest = folder / f"{self.step:08d}.safetensors"
        write_whole(newest, payload)
        for path in folder.iterdir():
            if _NAME.fullmatch(path.name) and path != newest:
                path.unlink(missing_ok=True)

    def restore(self, folder: Path) -> bool:
        """Go on from the newest state in `folder`; false if there is none."""
        if not folder.is_dir():
            return False
        remove_leftovers(folder)
        found = sorted(path for path in folder.iterdir() if _NAME.fullmatch(path.name))
        if not found:
            return False
        file = found[-1]
        facts, tensors = _facts(file), read_tensors(file)
        load_weights(self.policy, _part(tensors, "raw."), file)
        load_weights(self.average, _part(tensors, "average."), file)
        self._load_moments(_part(tensors, "moments."), file)
        self._take_facts(facts)
        return True

    def share(self, ranks: Ranks) -> None:
        """Take over the state of the first of several processes."""
        facts, tensors = ranks.agree(self._facts()), self._tensors()
        ranks.take_firsts(tensors.values())
        self._load_moments(_part(tensors, "moments."), Path("rank 0"))
        self._take_facts(facts)

    def _facts(self) -> dict[str, Any]:
        return {"step": self.step, "seconds": self.seconds, "plan": asdict(self.plan)}

    def _take_facts(self, facts: dict[str, Any]) -> None:
        self.step, self.seconds = int(facts["step"]), float(facts["seconds"])
        self.plan = StepPlan(**facts["plan"])

    def _tensors(self) -> dict[str, Tensor]:
        tensors = {f"raw.{name}": value for name, value in self.policy.state_dict().items()}
        tensors |= {f"average.{name}": value for name, value in self.average.state_dict().items()}
        for name, moments in self._moments.items():
            tensors |= {f"moments.{name}.{moment}": value for moment, value in moments.items()}
        return tensors

    def _load_moments(self, tensors: dict[str, Tensor], file: Path) -> None:
        for name, parameter in self._parameters.items():
            for moment in _MOMENTS:
                value = tensors.get(f"{name}.{moment}")
                if value is None or value.shape != parameter.shape:
                    raise CheckpointError(f"{file}: the optimiser's {moment} of {name} is missing or misshapen; train again")
                self._moments[name][moment].copy_(value)  # in the layout of the parameter (channels last)


def _facts(file: Path) -> dict[str, Any]:
    try:
        with safe_open(file, "pt") as opened:
            meta = opened.metadata() or {}
        if meta.get("format") != _FORMAT:
            raise ValueError("not a training state")
        return json.loads(meta["state"])
    except (OSError, SafetensorError, ValueError, KeyError) as error:
        raise CheckpointError(f"{file} is damaged ({error}); delete it to train from the start") from error


def _part(tensors: dict[str, Tensor], prefix: str) -> dict[str, Tensor]:
    return {name.removeprefix(prefix): value for name, value in tensors.items() if name.startswith(prefix)}
