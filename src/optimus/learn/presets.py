"""Policies by name: the paper's, its rivals', and small ones that a CPU trains in minutes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal, get_args

from optimus.errors import UnknownNameError
from optimus.learn.encoder import EncoderConfig, ResNetConfig
from optimus.learn.heads import BeTConfig, FlowConfig, HeadConfig, MixtureConfig
from optimus.learn.policy import PolicyConfig
from optimus.learn.trunk import LSTMConfig, MLPConfig, TransformerConfig

HeadName = Literal["gmm", "gaussian", "mse", "flow", "bet"]
Observe = Literal["images", "state"]

PAPERS_MIXTURE = MixtureConfig(min_deviation=1e-4)
"""Table D.1: five components, the smallest deviation of each."""

SMALL_MIXTURE = MixtureConfig(min_deviation=0.03, max_deviation=0.1)
"""For few steps: neither too narrow to be found, nor so wide that one component holds two ways."""


@dataclass(frozen=True)
class Preset:
    """A network, and the recipe it is trained by where no other is asked for."""

    policy: PolicyConfig
    recipe: str = "quick"


def preset(name: str, head: HeadName | None = None, observe: Observe = "images") -> Preset:
    """The preset of this name, perhaps with another head, or told how the objects lie instead of seeing.

    `UnknownNameError` if there is none of this name.
    """
    if name not in PRESETS:
        raise UnknownNameError("preset", name, PRESETS)
    if head is not None and head not in get_args(HeadName):
        raise UnknownNameError("head", head, get_args(HeadName))
    found = PRESETS[name]
    policy = replace(found.policy, observe=observe)
    return replace(found, policy=policy if head is None else replace(policy, head=_head(head, _mixture(found.policy))))


def _mixture(policy: PolicyConfig) -> MixtureConfig:
    """The preset's own mixture, or where it has another head, that of its kind."""
    if isinstance(policy.head, MixtureConfig):
        return policy.head
    return SMALL_MIXTURE if policy.locates else PAPERS_MIXTURE


def _head(name: HeadName, mixture: MixtureConfig) -> HeadConfig:
    alone = replace(mixture, modes=1, max_deviation=None)
    heads: dict[HeadName, HeadConfig] = {
        "gmm": mixture,
        "gaussian": alone,
        "mse": replace(alone, fixed_deviation=1.0),
        "flow": FlowConfig(),
        "bet": BeTConfig(),
    }
    return heads[name]


def _papers(trunk: TransformerConfig | MLPConfig | LSTMConfig, context: int, head: HeadName = "gmm") -> Preset:
    """The vision and training of Tables D.1 and D.2 around a trunk."""
    policy = PolicyConfig(context, encoder=ResNetConfig(), trunk=trunk, head=_head(head, PAPERS_MIXTURE))
    return Preset(replace(policy, locates=False, aims=False), "paper")


def _locating(of: Preset) -> Preset:
    """What the small policies have besides."""
    policy = replace(of.policy, locates=True, aims=True, head=SMALL_MIXTURE)
    return replace(of, policy=policy, recipe="gpu")


def _quick(trunk: TransformerConfig | MLPConfig | LSTMConfig, context: int, head: HeadName = "gmm") -> Preset:
    """The small vision around a trunk."""
    return Preset(PolicyConfig(context, encoder=EncoderConfig(), trunk=trunk, head=_head(head, SMALL_MIXTURE)))


def _gpt(layers: int, width: int, heads: int) -> TransformerConfig:
    return TransformerConfig(width, layers, heads, dropout=0.1, attention_dropout=0.1)


PRESETS: dict[str, Preset] = {
    "quick": _quick(TransformerConfig(), 8),
    # As it was before it was taught where the hand goes next and had components of a largest deviation, to see what that is worth.
    "quick-locating": Preset(PolicyConfig(aims=False, head=MixtureConfig())),
    "quick-mlp": _quick(MLPConfig(width=512), 1),
    "quick-rnn": _quick(LSTMConfig(width=256, token=128), 10),
    "quick-bet": _quick(TransformerConfig(), 10, "bet"),
    "optimus-30m": _papers(_gpt(6, 256, 8), 8),
    # The same eyes and trunk, also taught where the objects are and where the hand goes next, with a mixture that is less narrow:
    # few steps are enough then.
    "optimus-30m-locating": _locating(_papers(_gpt(6, 256, 8), 8)),
    # The table's second column as it is written comes to 60 million weights; at this width the same layers come to 100.
    "optimus-60m": _papers(_gpt(12, 512, 16), 8),
    "optimus-100m": _papers(_gpt(12, 736, 16), 8),
    "bc-mlp": _papers(MLPConfig(), 1),
    "bc-rnn": _papers(LSTMConfig(), 10),
    "bet": _papers(_gpt(6, 256, 8), 10, "bet"),
}
