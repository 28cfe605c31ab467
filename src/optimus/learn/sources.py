"""What a policy learns from: one curated data set or several, and corrections besides."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from optimus.data.curate import Curation, load_curation
from optimus.data.episode import BINARY, IMAGE_SIZE, IMAGE_SUFFIX, IMPORTED, RECEPTACLE, VIEWS
from optimus.data.episode_file import OBSERVATION_PREFIX, EpisodeHeader
from optimus.data.store import EpisodeStore
from optimus.data.windows import WindowConfig, Windows
from optimus.errors import DatasetError
from optimus.learn.checkpoint import joint_task, read_config

POSITION_SCALE = "position_scale"
"""Key of a dataset's configuration: metres that a position action of 1 stands for."""
SPLIT = "split"
"""Key of what is recorded of the data: a digest of which episodes are trained on, and which are held out."""
STARTS = "starts"
"""Key of the same: which initial states were learned from, of the run that training began with too."""
SCALES = (POSITION_SCALE, "rotation_scale", "joint_scale")


@dataclass(frozen=True)
class Sources:
    """The folders that a run learns from, and the run whose weights it begins with."""

    datasets: tuple[Path, ...]
    """Curated; their shares in training are those of their steps."""
    corrections: tuple[Path, ...] = ()
    """All of these is trained on, but for furniture of a size that is held out."""
    initial: Path | None = None


@dataclass(frozen=True, eq=False)
class Lessons:
    """The sources, opened and found to fit together."""

    task: str
    """Of several data sets: all their tasks (`checkpoint.joint_task`)."""
    train: Windows
    validation: Windows
    position_scale: float | None
    held_out: Sequence[EpisodeHeader]
    about: dict[str, Any]
    """What was learned from, JSON-able."""

    @classmethod
    def of(cls, sources: Sources, cut: WindowConfig, demonstrations: int | None = None) -> Lessons:
        """Open them, and of each data set the first so many demonstrations to train on; `DatasetError` if they do not fit together,
        or one has fewer."""
        folders = [*sources.datasets, *sources.corrections]
        if twice := [str(f) for i, f in enumerate(folders) if f.resolve() in [other.resolve() for other in folders[:i]]]:
            raise DatasetError(f"{', '.join(twice)} is named twice; name each dataset once")
        stores = [EpisodeStore.open(path) for path in sources.datasets]
        if not stores:
            raise DatasetError("nothing to train on; name one dataset or several")
        curations = [_shortened(load_curation(store.path), demonstrations, store.path) for store in stores]
        first = stores[0]
        if cut.images and not first.cameras and IMPORTED not in first.config:
            raise DatasetError(f"{first.path} holds no images; add them with optimus render, or train with --observe state")
        for store in stores[1:]:
            _require_same_meaning(store, first)
        rest = _rest(stores, curations, "validation")
        held_out = [*(first.header(s) for s in curations[0].validation), *rest]
        sizes = {size for h in held_out if (size := _size(h))}
        extra = [h for path in sources.corrections for h in _corrections(path, stores) if _size(h) not in sizes]
        train = [*_rest(stores, curations, "train"), *extra]
        learned = [*(first.header(s) for s in curations[0].train), *train]
        centre = replace(cut, windows=1, change_weight=1.0)
        windows = Windows(first, curations[0].train, cut, train)
        validation = Windows(first, curations[0].validation, centre, rest)
        largest = float(max(np.abs(part.actions).max(initial=0.0) for part in (windows, validation)))
        if largest > 1.0 + 1e-4:
            raise DatasetError(f"{first.path} has actions up to {largest:.3g}; policies answer from -1 to 1: scale and import them")
        _require_apart(learned, held_out)
        return cls(
            joint_task(store.task for store in stores),
            windows,
            validation,
            first.config.get(POSITION_SCALE),
            held_out,
            {**_about(stores, curations, extra), STARTS: _starts(learned, sources.initial)},
        )


    def require_new_to(self, initial: Path) -> None:
        """`DatasetError` if the run that training begins with has learned from an initial state that is held out now."""
        before = learned_starts(initial)
        both = [h for h in self.held_out if _has_start(h) and h.start in before]
        if both:
            raise DatasetError(
                f"{initial} has learned from {len(both)} of the {len(self.held_out)} initial states held out ({both[0].path}); "
                "the dataset was curated anew since, or has the same seeds; train without --initial, or collect others with --seed"
            )


def crop_of(datasets: Sequence[Path]) -> int:
    """Side of the square that a policy sees of these datasets' images [pixels]: 76 of 84, and of others as large a share."""
    usual, share = WindowConfig().crop, WindowConfig().crop / IMAGE_SIZE
    sides = [side for path in datasets for side in _sides(EpisodeStore.open(path))]
    return round(share * min(sides)) if sides else usual


def _sides(store: EpisodeStore) -> list[int]:
    """The sides of its images."""
    arrays = store.header(store.seeds[0]).arrays if store.seeds else {}
    names = [f"{OBSERVATION_PREFIX}{camera}{IMAGE_SUFFIX}" for camera in store.cameras]
    return [side for name in names if name in arrays for side in arrays[name].shape[1:3]]


def _shortened(curation: Curation, count: int | None, path: Path) -> Curation:
    """With the first so many episodes to train on: fewer are among more, so that curves compare like with like."""
    there = len(curation.train)
    if count is not None and not 1 <= count <= there:
        raise DatasetError(f"{path} has {there} demonstrations to train on, not {count}; ask for 1 to {there}, or collect more")
    return replace(curation, train=curation.train[:count])


def _rest(stores: Sequence[EpisodeStore], curations: Sequence[Curation], which: str) -> list[EpisodeHeader]:
    """The headers of all datasets but the first."""
    return [store.header(s) for store, c in zip(stores[1:], curations[1:], strict=True) for s in getattr(c, which)]


def _about(stores: Sequence[EpisodeStore], curations: Sequence[Curation], extra: Sequence[EpisodeHeader]) -> dict[str, Any]:
    episodes = sum(len(c.train) for c in curations) + len(extra)
    split = [[c.train, c.validation] for c in curations] + [[header.seed for header in extra]]
    said: dict[str, Any] = {"config": stores[0].config, "versions": stores[0].versions, "episodes": episodes}
    said[SPLIT] = hashlib.sha256(json.dumps(split).encode()).hexdigest()[:12]
    if len(stores) > 1:
        said["others"] = [{"task": s.task, "config": s.config, "versions": s.versions} for s in stores[1:]]
    return said


def _require_apart(learned: Sequence[EpisodeHeader], held_out: Sequence[EpisodeHeader]) -> None:
    """`DatasetError` if an initial state that is held out is learned from in another episode: held-out errors would say nothing.
    Where all episodes begin alike, or say so for want of knowing (imported ones), none could be held out."""
    known = {(h.task, h.start) for h in learned if _has_start(h)}
    if len(known | {(h.task, h.start) for h in held_out if _has_start(h)}) == 1:
        return
    sizes = {size for h in learned if (size := _size(h))}
    for both, what in (
        ([h for h in held_out if _has_start(h) and (h.task, h.start) in known], "begin like one that is learned from"),
        ([h for h in held_out if _size(h) in sizes], "have furniture of a size that is learned from"),
    ):
        if both:
            raise DatasetError(
                f"{len(both)} of {len(held_out)} held-out episodes {what} ({both[0].path} the first); "
                "curate all datasets alike, or leave one out"
            )


def _size(header: EpisodeHeader) -> tuple[str, str] | None:
    """The task and the size of its furniture, where that is drawn."""
    size = header.info.get(RECEPTACLE)
    return (header.task, str(size)) if size else None


def _starts(learned: Sequence[EpisodeHeader], initial: Path | None) -> list[str]:
    """Of those episodes (imported ones may have none), and of what the run `initial` was trained on."""
    before = learned_starts(initial) if initial is not None else set()
    return sorted({h.start for h in learned if _has_start(h)} | before)


def _has_start(header: EpisodeHeader) -> bool:
    return header.arrays["initial_state"].shape[0] > 0


def learned_starts(run: Path) -> set[str]:
    """The initial states that a run learned from, as `start_digest` names them; empty for one of an earlier version."""
    return set(read_config(run).get("dataset", {}).get(STARTS, ()))


def _corrections(path: Path, of: Sequence[EpisodeStore]) -> list[EpisodeHeader]:
    """All episodes of a dataset of corrections."""
    store = EpisodeStore.open(path)
    if store.task not in (tasks := [s.task for s in of]):
        raise DatasetError(f"{path} was collected for task {store.task!r}, not {' or '.join(map(repr, tasks))}; name another")
    _require_same_meaning(store, of[0])
    return store.headers()


def _require_same_meaning(store: EpisodeStore, first: EpisodeStore) -> None:
    """`DatasetError` if what is seen or done in one of them means something else than in the other."""
    said: list[tuple[str, Any, Any]] = [(what, getattr(store, what), getattr(first, what)) for what in ("control", "robot")]
    said.append(("cameras", ", ".join(store.cameras), ", ".join(first.cameras)))
    said.append((VIEWS, store.views, first.views))
    said.append(("gripper", store.config.get("gripper", BINARY), first.config.get("gripper", BINARY)))
    said += [(scale, store.config.get(scale), first.config.get(scale)) for scale in SCALES]
    for what, have, wanted in said:
        if have != wanted:
            raise DatasetError(
                f"{store.path} was collected with {what} = {have!r}, not {wanted!r} as {first.path}; "
                "train on it apart, or collect it again"
            )
