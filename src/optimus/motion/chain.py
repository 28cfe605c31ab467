"""The smoothest way through a sequence of choices: one configuration a layer, none far from the one before."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from optimus.se3 import Array

Edge = tuple[int, int, int]
"""From a choice of layer k to one of layer k + 1: `(k, choice, next choice)`."""


def smoothest_chain(layers: Sequence[Array], longest_step: float, forbidden: set[Edge], first_costs: Array) -> list[int] | None:
    """Indices, one a layer, of the chain of least cost: its squared steps and the cost of its first choice; None without one.

    `layers`: `(n_k, dof)` configurations [rad] each; no joint moves by more than `longest_step` [rad] from layer to layer, and
    `forbidden` edges are left out. Dynamic programming (Viterbi, 1967).
    """
    if any(len(layer) == 0 for layer in layers):
        return None
    cost, came = np.asarray(first_costs, float), []
    for k in range(1, len(layers)):
        steps = np.abs(layers[k - 1][:, None, :] - layers[k][None, :, :])
        edges = np.where(steps.max(-1) <= longest_step, np.square(steps).sum(-1), np.inf)
        for _, i, j in (e for e in forbidden if e[0] == k - 1):
            edges[i, j] = np.inf
        totals = cost[:, None] + edges
        came.append(totals.argmin(0))
        cost = totals.min(0)
    if not np.isfinite(cost).any():
        return None
    chain = [int(cost.argmin())]
    for back in reversed(came):
        chain.append(int(back[chain[-1]]))
    return chain[::-1]
