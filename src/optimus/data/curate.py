"""Curation: which episodes are learned from, and why not the others; only `curation.json` is written."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np

from optimus.data.atomic import write_json
from optimus.data.episode_file import EpisodeHeader
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError

CURATION_FILE = "curation.json"


@dataclass(frozen=True)
class CurationConfig:
    """What an episode has to be like to be learned from."""

    max_length_sd: float = 2.0
    """Longest episode: mean + this many standard deviations of the lengths of its plan skeleton."""
    workspace_min: tuple[float, float, float] | None = None
    """Lower corner [m] of the box that the tcp has to stay in."""
    workspace_max: tuple[float, float, float] | None = None
    """Upper corner [m] of that box."""
    max_tracking_error: float | None = None
    """Largest mean distance [m] between the controller's target and the tcp."""
    keep_retried: bool = False
    """Whether to keep episodes in which the expert had to plan again."""
    validation_share: float = 0.1
    """Share of the kept episodes that is held out."""
    validation_episodes: int = 0
    """... or this many if that is more, but never more than a fifth of them: one for each evaluated episode."""
    seed: int = 0
    """Decides which ones are held out."""


@dataclass(frozen=True)
class Curation:
    """Ids (seeds) of the episodes to train on and to validate on, and why each of the others is dropped."""

    train: tuple[int, ...]
    validation: tuple[int, ...]
    dropped: dict[int, str]
    config: dict[str, Any]

    @property
    def kept(self) -> tuple[int, ...]:
        """All ids that are learned from or validated on, ascending."""
        return tuple(sorted(self.train + self.validation))


def curate(path: Path | str, config: CurationConfig | None = None) -> Curation:
    """Decide about every episode of the dataset at `path`, and record it in its `curation.json`."""
    config = config or CurationConfig()
    store = EpisodeStore.open(path)
    headers = store.headers()
    limits = _length_limits([h for h in headers if h.success], config.max_length_sd)
    reasons = {h.seed: _reason(h, limits, config) for h in headers}
    kept = [seed for seed, reason in reasons.items() if not reason]
    if len(kept) < 2:
        causes = ", ".join(sorted({r for r in reasons.values() if r})) or "the dataset is that small"
        raise DatasetError(
            f"{store.path}: {len(kept)} of {len(headers)} episodes left ({causes}), at least 2 are needed; "
            "collect more or curate less strictly"
        )
    train, validation = _split(kept, config)
    dropped = {seed: reason for seed, reason in reasons.items() if reason}
    curation = Curation(train, validation, dropped, json.loads(json.dumps(asdict(config))))
    write_json(store.path / CURATION_FILE, _as_json(curation, store.task))
    return curation


def load_curation(path: Path | str) -> Curation:
    """The curation recorded in the dataset at `path`."""
    file = Path(path) / CURATION_FILE
    if not file.exists():
        raise DatasetError(f"{path} has not been curated (no {CURATION_FILE}); curate it first")
    try:
        value = json.loads(file.read_text())
        dropped = {int(seed): reason for seed, reason in value["dropped"].items()}
        return Curation(tuple(value["train"]), tuple(value["validation"]), dropped, value["config"])
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise DatasetError(f"{file} is damaged ({error}); curate again") from error


def _as_json(curation: Curation, task: str) -> dict[str, Any]:
    return {
        "task": task,
        "config": curation.config,
        "train": list(curation.train),
        "validation": list(curation.validation),
        "dropped": {str(seed): reason for seed, reason in curation.dropped.items()},
    }


def _length_limits(headers: list[EpisodeHeader], sd: float) -> dict[tuple[str, ...], float]:
    """Longest length [steps] for each skeleton; a limit for all would cut the longer branch of a task."""
    lengths: dict[tuple[str, ...], list[int]] = {}
    for header in headers:
        lengths.setdefault(header.skeleton, []).append(header.steps)
    return {skeleton: float(np.mean(n) + sd * np.std(n)) for skeleton, n in lengths.items()}


def _reason(header: EpisodeHeader, limits: dict[tuple[str, ...], float], config: CurationConfig) -> str:
    """Why an episode is left out, in one or two words; empty if it is kept."""
    if not header.success:
        return "failed"
    if header.info.get("retries", 0) > 0 and not config.keep_retried:
        return "retried"
    if header.steps > limits[header.skeleton] + 1e-9:
        return "too long"
    if _leaves_workspace(header, config):
        return "outside workspace"
    if config.max_tracking_error is not None and _tracking_error(header) > config.max_tracking_error:
        return "tracking error"
    return ""


def _leaves_workspace(header: EpisodeHeader, config: CurationConfig) -> bool:
    if config.workspace_min is None and config.workspace_max is None:
        return False
    position = header.read("obs.robot0_eef_pos")
    low = -np.inf if config.workspace_min is None else np.asarray(config.workspace_min)
    high = np.inf if config.workspace_max is None else np.asarray(config.workspace_max)
    return bool(((position < low) | (position > high)).any())


def _tracking_error(header: EpisodeHeader) -> float:
    """Mean distance [m] between the controller's target and the tcp."""
    return float(np.linalg.norm(header.read("obs.robot0_target_error")[:, :3], axis=1).mean())


def _split(kept: list[int], config: CurationConfig) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Training and validation ids: at least one of each."""
    wanted = min(config.validation_episodes, len(kept) // 5)
    count = min(max(1, round(len(kept) * config.validation_share), wanted), len(kept) - 1)
    held_out = np.random.default_rng(config.seed).choice(sorted(kept), size=count, replace=False)
    validation = tuple(sorted(int(seed) for seed in held_out))
    return tuple(seed for seed in sorted(kept) if seed not in set(validation)), validation
