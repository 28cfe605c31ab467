"""Where episodes begin: at the validation demonstrations' initial states, or at fresh ones."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from optimus.data.curate import load_curation
from optimus.data.episode_file import start_digest
from optimus.data.store import EpisodeStore
from optimus.errors import CheckpointError, DatasetError
from optimus.learn.sources import learned_starts

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


def require_unseen(run: Path, starts: Sequence[Start]) -> None:
    """`CheckpointError` if the policy in `run` has learned from one of these initial states: a dataset that grew and was curated
    anew holds others out than those that were."""
    learned = learned_starts(run)
    seen = sorted({s.seed for s in starts if s.state is not None and start_digest(s.state) in learned})
    if seen:
        named = ", ".join(map(str, seen[:5])) + (", ..." if len(seen) > 5 else "")
        raise CheckpointError(
            f"{run} has learned from {len(seen)} of these initial states (seeds {named}): the dataset has been curated anew since; "
            "evaluate with --states random, or train again"
        )


def random_starts(episodes: int, seed: int = 0, objects: str | None = None, task: str | None = None) -> list[Start]:
    """Fresh problems that no dataset holds, perhaps with other objects than the policy was trained with."""
    return [Start(RANDOM_SEEDS_FROM + seed * 100_000 + i, objects=objects, task=task) for i in range(episodes)]
