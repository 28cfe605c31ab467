"""Short films of what an evaluation found: of successes, and of failures of every cause."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from optimus.conditions import USUAL, Conditions
from optimus.data.atomic import make_folder, write_whole
from optimus.data.episode import Episode
from optimus.evaluate import Start, how_said, play
from optimus.learn.heads import Component
from optimus.robots import Robot
from optimus.show import Film, Loop, png


@dataclass(frozen=True)
class FilmedEpisode:
    """An episode to look at."""

    caption: str
    video: Path
    strip: Path
    success: bool
    cause: str = ""


def film_outcomes(
    run: Path,
    starts: Sequence[Start],
    report: dict[str, Any],
    seed: int,
    component: Component,
    folder: Path,
    robot: Robot | None = None,
    each: int = 3,
    conditions: Conditions = USUAL,
    compiled: bool = False,
) -> list[FilmedEpisode]:
    """Films (MP4, and a PNG strip) of the first few successes, and of failures of every cause. The episodes are played again: they
    are functions of their seeds, and of whether the network is compiled. Files are named by outcome, place in the list, seed, and
    what was unusual. The strip is written first: where there is a film, there is all of it."""
    films = []
    how = how_said(conditions, component, seed)
    make_folder(folder)
    for success in (True, False):
        for i in worth_filming(report["outcomes"], success, each):
            outcome, film = report["outcomes"][i], Film()
            play(run, starts[i], seed + i, component, film, robot, conditions, compiled)
            name = "+".join(filter(None, [f"{'success' if success else 'failure'}-{i:03d}-{outcome['seed']}", how]))
            path, strip = folder / f"{name}.mp4", folder / f"{name}.png"
            write_whole(strip, png(film.strip()))
            film.write(path)
            films.append(FilmedEpisode(caption_of(outcome), path, strip, success, outcome["cause"]))
    return films


def film_policy(run: Path, start: Start, out: Path, size: int = 256) -> Episode:
    """Write a short looping film of the policy in `run` from `start`; see `optimus.show.Loop`."""
    loop = Loop(out, size)
    episode, _ = play(run, start, 0, watch=loop)
    loop.write()
    return episode


def caption_of(outcome: dict[str, Any]) -> str:
    """What is said below the film of an outcome."""
    named = f"seed {outcome['seed']} {outcome['variant']}".strip()
    return f"{named}: {'success' if outcome['success'] else outcome['cause']}"


def worth_filming(outcomes: Sequence[dict[str, Any]], success: bool, each: int) -> list[int]:
    """Indices of `each` outcomes; of failures one of every cause first, however many causes there are."""
    seen: Counter[str] = Counter()
    ranked = []
    for i, outcome in enumerate(outcomes):
        if outcome["success"] is success:
            ranked.append((seen[outcome["cause"]], i))
            seen[outcome["cause"]] += 1
    return [i for _, i in sorted(ranked)[: max(each, len(seen))]]
