"""How easy demonstrations are to imitate: how far apart the actions are that were taken in alike situations (docs/imitability.md).

A policy that sees where the hand and the things are can do no better than the mean of what was done there; what is left over, step
by step, is what it errs by. Summed over an episode as independent errors sum, it is a drift in metres.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from optimus.data.curate import CURATION_FILE, load_curation
from optimus.data.episode import GRIPPER, arm_parts
from optimus.data.episode_file import EpisodeHeader
from optimus.data.store import EpisodeStore
from optimus.data.turns import rotations_of
from optimus.errors import DatasetError
from optimus.se3 import matrix_from_quat

Array = NDArray[np.float64]

NEIGHBOURS = 5
"""Other episodes that a step is compared with: the nearest step of each."""
TURN_WEIGHT = 0.2
"""A turn of one radian counts as this many metres, in states and in actions."""
MOST = 200
"""Episodes looked at, evenly spread over those there are: the score depends on how many there are, and costs their square."""
NEAR = 0.15
"""What the hand is at is the nearest thing, if that is as near as this [m]; else it is a place in the base frame."""
LEFT = 0.02
"""The hand is at work on a thing until it has gone this far from where the gripper began [m]."""


@dataclass(frozen=True)
class Imitability:
    """The score of a dataset. Smaller is easier."""

    episodes: int
    steps: float
    """Mean length of an episode."""
    drift: float
    """Root of the mean squared sum, over an episode, of what no function of the state can foretell of the hand's motions [m]."""
    doubt: float
    """Steps of an episode, in the mean, in which the gripper's label differs from what was done in alike situations."""
    alike: float
    """Median distance of the situations compared [m]: they are alike only where this is small."""
    phases: dict[str, dict[str, float]]
    """`drift` [m], `doubt` [steps] and mean length in `steps` of each phase; squared drifts and doubts add up to the whole's."""
    compared: float
    """Share of the steps that enough other episodes had something to compare with; the rest is taken to be like these."""

    @property
    def in_words(self) -> str:
        """The score on one line."""
        spread = f"drift {1000 * self.drift:.0f} mm, doubt {self.doubt:.1f} steps an episode"
        partly = f"; {self.compared:.0%} of the steps compared" if self.compared < 1.0 else ""
        return f"{spread}; situations {1000 * self.alike:.0f} mm apart{partly}"


@dataclass(frozen=True, eq=False)
class _Steps:
    """T steps of one episode that belong together: those on the way to one use of the gripper, and during it."""

    use: tuple[int, str]
    """Which use it is, and of what: only steps of the same use are compared."""
    states: Array
    """`(T, n)` [m]"""
    motions: Array
    """`(T, m)` [m]: the actions of the arm, turns weighted."""
    shut: NDArray[np.bool_]
    phase: list[str]


def imitability(path: Path | str) -> Imitability:
    """The score of the dataset at `path`: of the episodes that its curation keeps, or of all where it has none."""
    return compared([path])[0]


def compared(paths: Sequence[Path | str]) -> list[Imitability]:
    """The scores of datasets of one task, over equally many episodes of each: more lie closer together."""
    stores = [EpisodeStore.open(path) for path in paths]
    if len(tasks := sorted({store.task for store in stores})) > 1:
        raise DatasetError(f"these are of several tasks ({', '.join(tasks)}), which cannot be compared; name datasets of one")
    seeds = [load_curation(s.path).kept if (s.path / CURATION_FILE).exists() else s.seeds for s in stores]
    most = min(MOST, *map(len, seeds))
    chosen = [np.unique(np.linspace(0, len(of) - 1, most).astype(int)) for of in seeds]
    return [
        imitability_of([store.header(of[i]) for i in some], _units(store))
        for store, of, some in zip(stores, seeds, chosen, strict=True)
    ]


def imitability_of(headers: Sequence[EpisodeHeader], units: Array) -> Imitability:
    """The score of these episodes; `units` `(m,)` [m] is what an action of 1 counts, for each number of the arm's part."""
    if len(headers) <= NEIGHBOURS:
        raise DatasetError(f"a step is compared with {NEIGHBOURS} other episodes; there are {len(headers)} in all: collect more")
    pools: dict[tuple[int, str], list[_Steps]] = {}
    for header in headers:
        for steps in _uses(header, units):
            pools.setdefault(steps.use, []).append(steps)
    big = {use: pool for use, pool in sorted(pools.items()) if len(pool) > NEIGHBOURS}
    if not big:
        raise DatasetError(f"no two of these {len(headers)} episodes use the gripper on the same things; collect more")
    squared, doubt, gap = (np.concatenate(part) for part in zip(*(_dispersion(pool) for pool in big.values()), strict=True))
    phase = np.array([name for pool in big.values() for steps in pool for name in steps.phase])
    of_phase = Counter(name for pool in pools.values() for steps in pool for name in steps.phase)

    def summary(name: str) -> dict[str, float]:
        """Steps that nothing could be compared with count as those of their phase that something could."""
        here, steps = phase == name, of_phase[name] / len(headers)
        return {"drift": float(np.sqrt(steps * squared[here].mean())), "doubt": float(steps * doubt[here].mean()), "steps": steps}

    phases = {str(name): summary(name) for name in dict.fromkeys(phase)}
    lengths = sum(of_phase.values())
    return Imitability(
        episodes=len(headers),
        steps=lengths / len(headers),
        drift=float(np.sqrt(sum(p["drift"] ** 2 for p in phases.values()))),
        doubt=sum(p["doubt"] for p in phases.values()),
        alike=float(np.median(gap)),
        phases=phases,
        compared=len(squared) / lengths,
    )


def _units(store: EpisodeStore) -> Array:
    """What an action of 1 counts, for each number of the arm's part [m]."""
    size = store.header(store.seeds[0]).arrays["actions"].shape[1]
    parts = arm_parts(store.control, size)
    names = ("joint_scale",) if len(parts) == 1 else ("position_scale", "rotation_scale")
    units = np.zeros(size - 1)
    for part, name in zip(parts, names, strict=True):
        if name not in store.config:
            raise DatasetError(f"{store.path} does not say what an action of 1 stands for ({name}); collect it again")
        units[part] = store.config[name] * (1.0 if name == "position_scale" else TURN_WEIGHT)
    return units


def _dispersion(pool: list[_Steps]) -> tuple[Array, Array, Array]:
    """For each step of the pool: the squared distance of its motion from the mean of its neighbours' [m^2], freed of what the mean
    of so few errs by; the share of neighbours with another label for the gripper; and their mean distance [m]."""
    states, motions = np.concatenate([s.states for s in pool]), np.concatenate([s.motions for s in pool])
    shut = np.concatenate([s.shut for s in pool])
    ends = np.cumsum([len(s.states) for s in pool])
    gaps, nearest = np.empty((len(states), len(pool))), np.empty((len(states), len(pool)), np.int64)
    for i, (steps, end) in enumerate(zip(pool, ends, strict=True)):
        begin = end - len(steps.states)
        gaps[:, i], found = KDTree(steps.states).query(states)
        gaps[begin:end, i], nearest[:, i] = np.inf, begin + found
    order = np.argsort(gaps, axis=1, kind="stable")[:, :NEIGHBOURS]
    chosen = np.take_along_axis(nearest, order, axis=1)
    squared = ((motions - motions[chosen].mean(axis=1)) ** 2).sum(axis=1) * NEIGHBOURS / (NEIGHBOURS + 1)
    return squared, (shut[chosen] != shut[:, None]).mean(axis=1), np.take_along_axis(gaps, order, axis=1).mean(axis=1)


def _uses(header: EpisodeHeader, units: Array) -> list[_Steps]:
    """An episode cut into what belongs to each use of the gripper, and what comes after the last."""
    tcp, turned = _hand(header)
    things, turns = _things(header)
    actions = header.read("actions").astype(float)
    shut = actions[:, GRIPPER] > 0
    opening = np.abs(header.read("obs.robot0_gripper_qpos")).sum(axis=1)
    uses, begin, at, held = [], 0, -1, -1
    begins = [int(i) + 1 for i in np.flatnonzero(np.diff(shut))]
    ends = [*begins, len(tcp)]
    for number, (use, following) in enumerate(zip(ends, [*ends[1:], len(tcp)], strict=True)):
        if use < len(tcp):
            at = _at(tcp[use], things[use], held)
            held = at if shut[use] else -1
        end = min(following, use + _steps_until(np.linalg.norm(tcp[use:] - tcp[use : use + 1], axis=1) > LEFT))
        if end > begin:
            here = slice(begin, end)
            origin, frame = (things[here, at], turns[here, at]) if at >= 0 else (np.zeros(3), np.eye(3)[None])
            relative = np.swapaxes(turned[here], 1, 2) @ frame
            axes = TURN_WEIGHT / np.sqrt(2) * relative[:, :, :2].reshape(end - begin, -1)
            states = np.concatenate([tcp[here] - origin, axes, opening[here, None]], axis=1)
            phase = [_phase(number, len(begins), step < use) for step in range(begin, end)]
            name = header.object_names[at] if at >= 0 else ""
            uses.append(_Steps((number, name), states, actions[here, :GRIPPER] * units, shut[here], phase))
        begin = end
    return uses


def _phase(use: int, uses: int, before: bool) -> str:
    if use == uses:
        return "after"
    return f"to use {use + 1}" if before else f"in use {use + 1}"


def _steps_until(there: NDArray[np.bool_]) -> int:
    """The index of the first that is true; their number if none is."""
    return int(np.argmax(there)) if there.any() else len(there)


def _at(tcp: Array, things: Array, held: int) -> int:
    """Which of `things` `(k, 3)` the hand at `tcp` `(3,)` is at, other than what it holds; -1 for none."""
    gaps = np.linalg.norm(things - tcp, axis=1)
    if held >= 0:
        gaps[held] = np.inf
    return int(np.argmin(gaps)) if gaps.min(initial=np.inf) < NEAR else -1


def _hand(header: EpisodeHeader) -> tuple[Array, Array]:
    """The tcp's position `(T, 3)` [m] and rotation `(T, 3, 3)`."""
    quats = header.read("obs.robot0_eef_quat").astype(float)[:, [3, 0, 1, 2]]
    return header.read("obs.robot0_eef_pos").astype(float), np.stack([matrix_from_quat(q) for q in quats])


def _things(header: EpisodeHeader) -> tuple[Array, Array]:
    """The objects' positions `(T, k, 3)` [m] and rotations `(T, k, 3, 3)`; none turns where nobody recorded states."""
    places = header.read("objects").astype(float)
    turns = rotations_of(header)
    return places, np.broadcast_to(np.eye(3), (*places.shape, 3)) if turns is None else turns
