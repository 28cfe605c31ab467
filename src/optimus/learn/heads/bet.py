"""BeT (Shafiullah et al., 2022): which of some clusters of actions, and how far from its centre."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import torch
import torch.nn.functional as F
from numpy.typing import NDArray
from torch import Tensor, nn

from optimus.learn.heads.mixture import Mixture, NextAction


@dataclass(frozen=True)
class BeTConfig(NextAction):
    """The paper's re-implementation (Table D.2)."""

    clusters: int = 24
    offset_scale: float = 100.0
    """Weight of the offset's squared error beside the focal loss of the cluster."""
    focus: float = 2.0
    """Exponent of the focal loss (Lin et al., 2017): 0 is cross-entropy."""
    kind: Literal["bet"] = "bet"

    def build(self, width: int, actions: int) -> BeTHead:
        """A head with random weights."""
        return BeTHead(self, width, actions)


class BeTHead(nn.Module):
    """One linear layer to a score and an offset for each cluster; the centres are fitted once, before training."""

    centres: Tensor

    def __init__(self, config: BeTConfig, width: int, actions: int) -> None:
        super().__init__()
        self.config, self.actions = config, actions
        self.parameters_of = nn.Linear(width, config.clusters * (actions + 1))
        self.register_buffer("centres", torch.zeros(config.clusters, actions))

    def fit(self, actions: NDArray[np.float32]) -> None:
        """Find the clusters of normalised actions `(N, n)` by k-means; where there are fewer different ones, some centres are the
        same."""
        from scipy.cluster.vq import kmeans2  # it takes half a second to load, and this alone needs it

        different = np.unique(actions.astype(np.float64), axis=0)
        count = min(self.config.clusters, len(different))
        if count < len(different):
            rng = np.random.default_rng(0)
            different = kmeans2(actions.astype(np.float64), count, minit="++", rng=rng, missing="warn")[0]
        rows = np.resize(different, (self.config.clusters, self.actions))
        self.centres.copy_(torch.from_numpy(rows))

    def forward(self, features: Tensor) -> Mixture:
        """`(..., width)` to a mixture whose means are what each cluster's answer would be; its deviations say nothing."""
        scores, offsets = self._scores_and_offsets(features)
        mean = self.centres + offsets
        return Mixture(scores, mean, torch.ones_like(mean))

    def loss(self, features: Tensor, actions: Tensor, noise: torch.Generator | None = None) -> Tensor:
        """Focal loss of the cluster nearest to normalised `actions` `(..., n)`, and squared error of that cluster's offset alone
        (the paper's masked, "multi-task" loss); shape `(...)`."""
        scores, offsets = self._scores_and_offsets(features)
        nearest = torch.cdist(actions, self.centres).argmin(-1, keepdim=True)
        log_share = F.log_softmax(scores, -1).gather(-1, nearest).squeeze(-1)
        focal = -((1 - log_share.exp()) ** self.config.focus) * log_share
        offset = offsets.gather(-2, nearest[..., None].expand(*nearest.shape, self.actions)).squeeze(-2)
        wrong = (offset - (actions - self.centres[nearest.squeeze(-1)])).square().mean(-1)
        return focal + self.config.offset_scale * wrong

    def _scores_and_offsets(self, features: Tensor) -> tuple[Tensor, Tensor]:
        """`(..., K)` and `(..., K, n)`, in float32."""
        k, n = self.config.clusters, self.actions
        scores, offsets = self.parameters_of(features).float().split([k, k * n], dim=-1)
        return scores, offsets.unflatten(-1, (k, n))
