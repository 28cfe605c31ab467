"""`dataset`: what is in a data set, in words, as a page, as a film."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from optimus.cli.options import Dataset, Json
from optimus.cli.output import bar, counted, say

if TYPE_CHECKING:
    from optimus.data.describe import Description
    from optimus.data.store import EpisodeStore


def dataset(
    dataset: Dataset,
    html: Path | None = None,
    play: int | None = None,
    out: Path | None = None,
    overwrite: bool = False,
    json: Json = False,
) -> None:
    """Describe a data set: how many episodes of what, how long, where things started, how it moves.

    Try:
        optimus dataset data/stack
        optimus dataset data/stack --html stack.html
        optimus dataset data/stack --play 3 --out episode-3.mp4

    Args:
        html: also write a page with charts and contact sheets, self-contained
        play: write a film of the episode of this seed instead
        out: with --play: the MP4 to write; by default FOLDER-SEED.mp4 here
        overwrite: replace the page or film that is there already
    """
    from optimus.data.store import EpisodeStore

    store = EpisodeStore.open(dataset)
    if play is not None:
        _play(store, play, out or Path(f"{store.path.resolve().name}-{play}.mp4"), overwrite, json)
        return
    from optimus.data.atomic import require_free
    from optimus.data.describe import describe

    if html is not None:
        require_free(html, overwrite)
    with bar(None, f"read {store.path.name}", "episode") as shown:
        about = describe(dataset, counted(shown))
    if html is not None:
        from optimus.data.atomic import make_folder, write_whole
        from optimus.report.dataset_page import render_dataset

        make_folder(html.parent)
        write_whole(html, render_dataset(store, about).encode())
    answer = asdict(about) | ({"page": str(html)} if html else {})
    say(answer, json, "\n".join(_lines(about, html)))


def _play(store: EpisodeStore, seed: int, out: Path, overwrite: bool, json: bool) -> None:
    from optimus.report.film import write_episode_film

    episode = store.read(seed)
    frames = write_episode_film(episode, out, overwrite=overwrite)
    told = str(episode.info.get("instruction", "")) or store.task
    answer = {"film": str(out), "episode": seed, "frames": frames, "instruction": told, "success": episode.success}
    say(answer, json, f"{told}: {frames} frames in {out}")


def _lines(about: Description, html: Path | None) -> list[str]:
    """The description for a terminal: a line a quantity, lists indented below."""
    from optimus.data.describe import CELLS

    shortest, longest = min(about.lengths), max(about.lengths)
    cameras = ", ".join(f"{name} {shape[0]} x {shape[1]}" for name, shape in about.cameras.items()) or "none"
    lines = [
        f"{about.dataset}: {about.episodes} demonstrations of {about.task}, {about.steps} steps",
        f"{'control, robot':<24}{about.control}, {about.robot}",
        f"{'cameras':<24}{cameras}",
        f"{'lengths [steps]':<24}{shortest} to {longest}, mean {about.steps / about.episodes:.1f}",
        f"{'pushed, planned again':<24}{about.perturbed}, {about.retried}",
        f"{'mishaps':<24}{about.mishaps}",
    ]
    if about.imitability is not None:
        lines.append(f"{'imitability':<24}{about.imitability.in_words}")
    named: dict[str, dict[str, Any]] = {
        "failed attempts": about.failures,
        "split": about.split or {"not curated": about.episodes},
        "plans": about.skeletons,
        "variants": about.variants,
        "instructions": about.instructions,
        "objects": about.objects,
    }
    for heading, found in named.items():
        lines += [heading, *(f"  {count:>6}  {name}" for name, count in found.items())] if found else []
    if about.starts:
        lines.append(f"starts: x [m], y [m], cells reached, of {CELLS**2} (if drawn evenly)")
    for name, s in about.starts.items():
        spans = f"{s.low[0]:.3f} to {s.high[0]:.3f}, {s.low[1]:.3f} to {s.high[1]:.3f}"
        lines.append(f"  {name:<12} {spans}, {s.cells} ({s.expected_cells:.0f})")
    lines.append("actions: mean, standard deviation, share at the limit, histogram from -1 to 1")
    for number, a in enumerate(about.actions):
        lines.append(f"  {number:<4}{a.mean:>7.3f}{a.sd:>7.3f}{100 * a.saturated:>6.1f} %  {_sparks(a.histogram)}")
    return lines + ([str(html)] if html else [])


def _sparks(counts: tuple[int, ...]) -> str:
    """Bars of eight heights, one a count; none where there is nothing."""
    most = max(1, *counts)
    return "".join(" " if not c else "▁▂▃▄▅▆▇█"[min(7, 8 * c // most)] for c in counts)
