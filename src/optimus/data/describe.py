"""What is in a data set, in figures: how many, how long, of what, started where, moved how."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from optimus.data.curate import CURATION_FILE, load_curation, undecided
from optimus.data.episode import IMAGE_SUFFIX, INSTRUCTION, MISHAP
from optimus.data.episode_file import OBSERVATION_PREFIX, EpisodeHeader, require_finite
from optimus.data.imitability import Imitability, imitability
from optimus.data.store import EpisodeStore
from optimus.errors import DatasetError

CELLS = 8
"""The rectangle in which a thing starts is cut into this many parts either way."""
BINS = 20
"""Of the histograms of actions, over -1 to 1."""
SATURATED = 0.999
"""An action this far out is at its limit."""


@dataclass(frozen=True)
class Coverage:
    """Where one thing starts, over all episodes."""

    low: tuple[float, float]
    """The smallest x and y [m]."""
    high: tuple[float, float]
    cells: int
    """How many of the `CELLS` x `CELLS` parts of that rectangle hold a start."""
    expected_cells: float
    """How many do on average if as many starts are drawn evenly over the rectangle."""


@dataclass(frozen=True)
class ActionSpread:
    """One number of the actions, over all steps."""

    mean: float
    sd: float
    saturated: float
    """The share of steps at the limit."""
    histogram: tuple[int, ...]
    """Steps in each of `BINS` equal parts of -1 to 1; what lies beyond counts at the ends."""


@dataclass(frozen=True)
class Description:
    """A data set in figures; counts are of episodes where nothing else is said."""

    dataset: str
    task: str
    control: str
    robot: str
    cameras: dict[str, tuple[int, ...]]
    """Name -> height, width and channels of its images."""
    versions: dict[str, str]
    episodes: int
    steps: int
    lengths: tuple[int, ...]
    """[steps]"""
    failures: dict[str, int]
    """Attempts that failed, by reason."""
    skeletons: dict[str, int]
    variants: dict[str, int]
    objects: dict[str, int]
    """What the things are called, or where that is not recorded their names."""
    instructions: dict[str, int]
    perturbed: int
    retried: int
    mishaps: int
    """Episodes in which a thing was pushed or slipped."""
    split: dict[str, int] = field(default_factory=dict)
    """Train, validation, what came after the curation and, by reason, dropped; empty where the data set is not curated."""
    starts: dict[str, Coverage] = field(default_factory=dict)
    """By the name of the thing in the scene."""
    actions: tuple[ActionSpread, ...] = ()
    imitability: Imitability | None = None
    """None where there is too little to compare, or too little is known of it."""


def describe(dataset: Path | str, progress: Callable[[int, int], None] = lambda done, of: None) -> Description:
    """Read all headers, and of every episode the actions and where things started; no image. `DatasetError` if it is none."""
    store = EpisodeStore.open(dataset)
    headers = store.headers()
    if not headers:
        raise DatasetError(f"{store.path} holds no episodes yet; {len(store.failed_seeds)} attempts failed")
    actions, starts = [], starting_places(headers)
    for number, header in enumerate(headers):
        actions.append(header.read("actions"))
        require_finite(actions[-1], header.path, "actions")
        progress(number + 1, len(headers))
    info = [h.info for h in headers]
    return Description(
        dataset=str(store.path),
        task=store.task,
        control=store.control,
        robot=store.robot,
        cameras={c: headers[0].arrays[f"{OBSERVATION_PREFIX}{c}{IMAGE_SUFFIX}"].shape[1:] for c in store.cameras},
        versions=store.versions,
        episodes=len(headers),
        steps=sum(h.steps for h in headers),
        lengths=tuple(h.steps for h in headers),
        failures=_most_first(Counter(_heading(store.read_failure(s)["reason"]) for s in store.failed_seeds)),
        skeletons=_most_first(Counter(" ".join(h.skeleton) or "not recorded" for h in headers)),
        variants=_most_first(Counter(str(i["variant"]) for i in info if i.get("variant"))),
        objects=_most_first(Counter(name for h in headers for name in _called(h))),
        instructions=_most_first(Counter(str(i[INSTRUCTION]) for i in info if i.get(INSTRUCTION))),
        perturbed=sum(bool(i.get("perturbed")) for i in info),
        retried=sum(i.get("retries", 0) > 0 for i in info),
        mishaps=sum(MISHAP in i for i in info),
        split=_split(store),
        starts={name: _coverage(np.array(places)) for name, places in starts.items()},
        actions=tuple(_spread(column) for column in _columns(store, actions)),
        imitability=_imitability(store),
    )


def _imitability(store: EpisodeStore) -> Imitability | None:
    try:
        return imitability(store.path)
    except DatasetError:
        return None


def starting_places(headers: Sequence[EpisodeHeader]) -> dict[str, list[list[float]]]:
    """Where each thing is at the first step of each episode [m], by its name in the scene."""
    found: dict[str, list[list[float]]] = {}
    for header in headers:
        if header.object_names:
            for name, place in zip(header.object_names, header.read("objects")[0].tolist(), strict=True):
                found.setdefault(name, []).append(place)
    return found


def _called(header: EpisodeHeader) -> list[str]:
    words: Mapping[str, str] = header.info.get("words", {})
    return [words.get(name, name) for name in header.object_names]


def _heading(reason: str) -> str:
    """The reason without its particulars."""
    return reason.split(":")[0]


def _most_first(counts: Counter[str]) -> dict[str, int]:
    return dict(sorted(counts.items(), key=lambda item: (-item[1], item[0])))


def _split(store: EpisodeStore) -> dict[str, int]:
    if not (store.path / CURATION_FILE).exists():
        return {}
    curation = load_curation(store.path)
    dropped = _most_first(Counter(f"dropped: {_heading(reason)}" for reason in curation.dropped.values()))
    new = {"came after the curation": n} if (n := len(undecided(store, curation))) else {}
    return {"train": len(curation.train), "validation": len(curation.validation), **new, **dropped}


def _coverage(places: NDArray[np.float64]) -> Coverage:
    flat = places[:, :2]
    low, high = flat.min(0), flat.max(0)
    cells = np.minimum((CELLS * (flat - low) / np.maximum(high - low, 1e-9)).astype(int), CELLS - 1)
    total = CELLS * CELLS
    expected = total * (1 - (1 - 1 / total) ** len(flat))
    corners = [(float(c[0]), float(c[1])) for c in (low, high)]
    return Coverage(corners[0], corners[1], len({tuple(c) for c in cells.tolist()}), float(expected))


def _columns(store: EpisodeStore, actions: Sequence[NDArray[np.float32]]) -> list[NDArray[np.float32]]:
    if len({a.shape[1] for a in actions}) > 1:
        raise DatasetError(f"{store.path}: its actions are not all of one size; collect these apart")
    return list(np.concatenate(actions).T)


def _spread(values: NDArray[np.float32]) -> ActionSpread:
    histogram, _ = np.histogram(values.clip(-1, 1), BINS, (-1, 1))
    at_limit = float((np.abs(values) >= SATURATED).mean())
    return ActionSpread(float(values.mean()), float(values.std()), at_limit, tuple(histogram.tolist()))
