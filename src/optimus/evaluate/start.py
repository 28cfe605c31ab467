"""Where episodes begin: at the validation demonstrations' initial states, or at fresh ones."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from optimus.data.curate import load_curation
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError

RANDOM_SEEDS_FROM = 10_000_000
"""Seeds of random initial states start here, far from those of any dataset."""


@dataclass(frozen=True, eq=False)
class Start:
    """An initial state: a seed, and the physics state to start from where one was recorded."""

    seed: int
    state: np.ndarray | None = None
    objects: str | None = None
    """What to do the task with (see `optimus.tasks.task`); None: what the policy was trained with, empty: the task's own."""
    task: str | None = None
    """Of a policy of several tasks: which; None: its first."""


def validation_starts(dataset: Path, episodes: int) -> list[Start]:
    """The initial states of the validation demonstrations, then (if more are asked for) again from the first."""
    store, seeds = EpisodeStore.open(dataset), load_curation(dataset).validation
    if not seeds:
        raise DatasetError(f"{dataset} has no validation demonstrations; collect more, or evaluate with --states random")
    again = (seeds[i % len(seeds)] for i in range(episodes))
    return [Start(s, store.header(s).read("initial_state"), task=store.task) for s in again]


def random_starts(episodes: int, seed: int = 0, objects: str | None = None, task: str | None = None) -> list[Start]:
    """Fresh problems that no dataset holds, perhaps with other objects than the policy was trained with."""
    return [Start(RANDOM_SEEDS_FROM + seed * 100_000 + i, objects=objects, task=task) for i in range(episodes)]
