"""Which episodes of a data set go out, and which of them are to train on and which to validate on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from optimus.data.curate import CURATION_FILE, load_curation, require_decided
from optimus.data.episode import INSTRUCTION
from optimus.data.episode_file import EpisodeHeader
from optimus.data.store import EpisodeStore
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError


@dataclass(frozen=True, eq=False)
class Selection:
    """Episodes in the order in which they are written, and the split by curation (empty without one)."""

    store: EpisodeStore
    headers: tuple[EpisodeHeader, ...]
    train: frozenset[int]
    validation: frozenset[int]

    @property
    def steps(self) -> int:
        """Steps of all episodes."""
        return sum(header.steps for header in self.headers)


def environment_settings(env_args: Any) -> Mapping[str, Any]:
    """The `env_kwargs` of another program's `env_args`; empty where it gives none."""
    settings = env_args.get("env_kwargs") if isinstance(env_args, Mapping) else None
    return settings if isinstance(settings, Mapping) else {}


def instruction_of(header: EpisodeHeader, env: ManipulationEnv | None) -> str:
    """What was wanted, in plain English; of episodes that did not record it, as the task says it, or else the task's name."""
    told = str(header.info.get(INSTRUCTION, ""))
    if not told and env is not None:
        told = str(env.reset(seed=header.seed)[1][INSTRUCTION])
    return told or header.task.replace("-", " ")


def select(dataset: Path, everything: bool = False) -> Selection:
    """The episodes that curation kept, all of them where there was no curation or `everything` is asked for."""
    store = EpisodeStore.open(dataset)
    seeds = store.seeds
    train, validation = frozenset[int](), frozenset[int]()
    if (store.path / CURATION_FILE).exists():
        curation = load_curation(dataset)
        if not everything:
            require_decided(store, curation)
        train, validation = frozenset(curation.train), frozenset(curation.validation)
        if missing := (train | validation) - set(seeds):
            raise DatasetError(f"{store.path}: its curation names episodes that are not there: {sorted(missing)}; curate again")
        seeds = seeds if everything else curation.kept
    if not seeds:
        raise DatasetError(f"{store.path} holds no episodes to export; collect some")
    return Selection(store, tuple(store.header(seed) for seed in seeds), train, validation)
