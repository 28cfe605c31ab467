"""Curation: which episodes are learned from, and why not the others; only `curation.json` is written.

The rules, in the order in which one of them becomes an episode's reason: `RULES`.
"""

from __future__ import annotations

import json
import math
from collections import Counter
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Literal

import numpy as np

from optimus.data.atomic import write_json
from optimus.data.episode import MISHAP, RECEPTACLE, VIEWS
from optimus.data.episode_file import EpisodeHeader
from optimus.data.frustum import in_view
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError, require_at_least, require_below_one

CURATION_FILE = "curation.json"

FAILED, RETRIED, TOO_LONG = "failed", "retried", "too long"
OUTSIDE, OUT_OF_VIEW, OFF_PATH = "outside workspace", "out of view", "tracking error"
RULES = (FAILED, RETRIED, TOO_LONG, OUTSIDE, OUT_OF_VIEW, OFF_PATH)


@dataclass(frozen=True)
class CurationConfig:
    """What an episode has to be like to be learned from."""

    max_length_sd: float = 2.0
    """Longest episode: mean + this many standard deviations of the lengths of successful ones."""
    length_over: Literal["skeleton", "all"] = "skeleton"
    """... of those with its plan skeleton, or of all (the paper's rule, which cuts the longer branch of a task)."""
    workspace_min: tuple[float, float, float] | None = None
    """Lower corner [m] of the box that the tcp has to stay in."""
    workspace_max: tuple[float, float, float] | None = None
    """Upper corner [m] of that box."""
    in_view: tuple[str, ...] = ()
    """Fixed cameras in whose picture the tcp and every object have to be at every step."""
    max_tracking_error: float | None = None
    """Largest median distance of the tcp from the planned path [m]."""
    keep_retried: bool = False
    """Whether to keep episodes in which the expert had to plan again without a mishap that made it."""
    validation_share: float = 0.1
    """Share of the kept episodes that is held out."""
    validation_episodes: int = 0
    """... or this many if that is more, but never more than a fifth of them: one for each evaluated episode."""
    seed: int = 0
    """Decides which ones are held out."""

    def __post_init__(self) -> None:
        require_at_least(0, validation_episodes=self.validation_episodes, seed=self.seed)
        require_at_least(0, max_length_sd=self.max_length_sd, max_tracking_error=self.max_tracking_error)
        require_below_one(validation_share=self.validation_share)
        for corner in filter(None, (self.workspace_min, self.workspace_max)):
            for number in corner:
                require_at_least(-math.inf, workspace=number)  # a box may be open on a side


@dataclass(frozen=True)
class Curation:
    """Ids (seeds) of the episodes to train on and to validate on, and why each of the others is dropped."""

    train: tuple[int, ...]
    validation: tuple[int, ...]
    dropped: dict[int, str]
    config: dict[str, Any]
    broken: dict[str, int] = field(default_factory=dict)
    """How many episodes break each rule, whatever other rules they break."""

    @property
    def kept(self) -> tuple[int, ...]:
        """All ids that are learned from or validated on, ascending."""
        return tuple(sorted(self.train + self.validation))

    @property
    def rules(self) -> dict[str, dict[str, int]]:
        """Rule -> how many episodes it `removed` that no rule before it did, and how many it would remove `alone`."""
        removed = Counter(self.dropped.values())
        return {rule: {"removed": removed[rule], "alone": n} for rule, n in self.broken.items()}


def curate(path: Path | str, config: CurationConfig | None = None) -> Curation:
    """Decide about every episode of the dataset at `path`, and record it in its `curation.json`."""
    config = config or CurationConfig()
    store = EpisodeStore.open(path)
    headers = store.headers()
    limits = _length_limits([h for h in headers if h.success], config)
    reasons = {h.seed: _reasons(h, limits, config) for h in headers}
    kept = [seed for seed, broken in reasons.items() if not broken]
    if len(kept) < 2:
        causes = ", ".join(sorted({rule for broken in reasons.values() for rule in broken})) or "the dataset is that small"
        raise DatasetError(
            f"{store.path}: {len(kept)} of {len(headers)} episodes left ({causes}), at least 2 are needed; "
            "collect more or curate less strictly"
        )
    train, validation = _split({h.seed: _kind(h) for h in headers if h.seed in set(kept)}, config)
    dropped = {seed: broken[0] for seed, broken in reasons.items() if broken}
    counts = {rule: sum(rule in broken for broken in reasons.values()) for rule in RULES}
    curation = Curation(train, validation, dropped, json.loads(json.dumps(asdict(config))), counts)
    write_json(store.path / CURATION_FILE, _as_json(curation, store.task))
    return curation


def undecided(store: EpisodeStore, curation: Curation) -> set[int]:
    """Seeds of the episodes of which the curation knows nothing: they came after it."""
    return set(store.seeds) - {*curation.kept, *curation.dropped}


def require_decided(store: EpisodeStore, curation: Curation) -> None:
    """`DatasetError` if there are episodes of which the curation knows nothing: they would be left out without a word."""
    if new := undecided(store, curation):
        raise DatasetError(f"{store.path}: {len(new)} episodes came after its curation; curate it again")


def load_curation(path: Path | str) -> Curation:
    """The curation recorded in the dataset at `path`."""
    file = Path(path) / CURATION_FILE
    if not file.exists():
        raise DatasetError(f"{path} has not been curated (no {CURATION_FILE}); curate it first")
    try:
        value = json.loads(file.read_text())
        dropped = {int(seed): reason for seed, reason in value["dropped"].items()}
        broken = {str(rule): int(n) for rule, n in value.get("broken", {}).items()}
        return Curation(tuple(value["train"]), tuple(value["validation"]), dropped, value["config"], broken)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise DatasetError(f"{file} is damaged ({error}); curate again") from error


def _as_json(curation: Curation, task: str) -> dict[str, Any]:
    return {
        "task": task,
        "config": curation.config,
        "train": list(curation.train),
        "validation": list(curation.validation),
        "dropped": {str(seed): reason for seed, reason in curation.dropped.items()},
        "broken": curation.broken,
    }


def _group(header: EpisodeHeader, config: CurationConfig) -> tuple[str, ...]:
    """What an episode's length is compared with: those of the same group. Mishaps take time to make good."""
    happened = header.info.get(MISHAP, {}).get("kind", "")
    return (*(header.skeleton if config.length_over == "skeleton" else ()), happened)


def _length_limits(headers: list[EpisodeHeader], config: CurationConfig) -> dict[tuple[str, ...], float]:
    """Longest length [steps] for each group."""
    lengths: dict[tuple[str, ...], list[int]] = {}
    for header in headers:
        lengths.setdefault(_group(header, config), []).append(header.steps)
    return {group: float(np.mean(n) + config.max_length_sd * np.std(n)) for group, n in lengths.items()}


def _reasons(header: EpisodeHeader, limits: dict[tuple[str, ...], float], config: CurationConfig) -> list[str]:
    """The rules that an episode breaks, in their order."""
    broken = {
        FAILED: not header.success,
        RETRIED: header.info.get("retries", 0) > 0 and not config.keep_retried and MISHAP not in header.info,
        TOO_LONG: header.success and header.steps > limits[_group(header, config)],
        OUTSIDE: _leaves_workspace(header, config),
        OUT_OF_VIEW: any(_leaves_view(header, camera) for camera in config.in_view),
        OFF_PATH: config.max_tracking_error is not None and _tracking_error(header) > config.max_tracking_error,
    }
    return [rule for rule in RULES if broken[rule]]


def _leaves_workspace(header: EpisodeHeader, config: CurationConfig) -> bool:
    if config.workspace_min is None and config.workspace_max is None:
        return False
    position = header.read("obs.robot0_eef_pos")
    low = -np.inf if config.workspace_min is None else np.asarray(config.workspace_min)
    high = np.inf if config.workspace_max is None else np.asarray(config.workspace_max)
    return bool(((position < low) | (position > high)).any())


def _leaves_view(header: EpisodeHeader, camera: str) -> bool:
    views = header.info.get(VIEWS, {})
    if camera not in views:
        raise DatasetError(f"{header.path} says nothing of a fixed camera {camera!r}; it tells of {', '.join(views) or 'none'}")
    points = np.concatenate([header.read("objects"), header.read("obs.robot0_eef_pos")[:, None]], axis=1)
    return not in_view(points, views[camera]).all()


def _tracking_error(header: EpisodeHeader) -> float:
    """Median distance [m] of the tcp from the planned path."""
    error = header.info.get("tracking_error")
    if error is None:
        raise DatasetError(f"{header.path} does not say how well the plan was followed; curate without a limit on that")
    return float(error["median"])


def _kind(header: EpisodeHeader) -> int | str:
    """What an episode is held out with: all those with furniture of the same size, or itself alone."""
    return header.info.get(RECEPTACLE, header.seed)


def _split(kept: dict[int, int | str], config: CurationConfig) -> tuple[tuple[int, ...], tuple[int, ...]]:
    """Training and validation ids, of the ids with their kinds: at least one of each, and no kind in both."""
    wanted = min(config.validation_episodes, len(kept) // 5)
    count = min(max(1, round(len(kept) * config.validation_share), wanted), len(kept) - 1)
    drawn = np.random.default_rng(config.seed).choice(sorted(kept), size=count, replace=False)
    kinds = {kept[int(seed)] for seed in drawn}
    validation = tuple(seed for seed in sorted(kept) if kept[seed] in kinds)
    train = tuple(seed for seed in sorted(kept) if kept[seed] not in kinds)
    if not train:
        raise DatasetError("every size of the furniture is held out, none is left to train on; collect more")
    return train, validation
