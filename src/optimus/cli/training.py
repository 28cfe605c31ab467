"""`train`: from a dataset to a policy."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from optimus.cli.options import Datasets, Json, PresetName, Workers
from optimus.cli.output import StageBars, bar, rate, say

if TYPE_CHECKING:
    from collections.abc import Callable

    from optimus.dagger import DaggerConfig
    from optimus.learn.board import BoardName
    from optimus.learn.policy import PolicyConfig
    from optimus.learn.recipe import TrainConfig
    from optimus.learn.train import Progress


def train(
    datasets: Datasets,
    out: Path,
    minutes: float | None = None,
    epochs: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    demonstrations: int | None = None,
    preset: PresetName = "quick",
    head: Literal["gmm", "gaussian", "mse", "flow", "bet"] | None = None,
    observe: Literal["images", "state"] = "images",
    recipe: Literal["quick", "paper", "gpu"] | None = None,
    batch: int | None = None,
    consecutive: int = 1,
    labels: Literal["all", "last"] | None = None,
    accumulate: int = 1,
    ema: float | None = None,
    precision: Literal["auto", "float32", "bfloat16"] = "auto",
    device: Literal["auto", "cpu", "cuda"] = "auto",
    board: Literal["tensorboard", "wandb", "none"] = "tensorboard",
    corrections: tuple[Path, ...] = (),
    initial: Path | None = None,
    dagger: int = 0,
    dagger_episodes: int = 50,
    dagger_plain: bool = False,
    dagger_evaluations: int = 50,
    workers: Workers = 0,
    json: Json = False,
) -> None:
    """Train a policy on one dataset or several by behaviour cloning; a second call goes on where the first was stopped.

    Try:
        optimus train data/stack --out runs/stack --minutes 12
        optimus train data/stack --out runs/stack --epochs 20
        optimus train data/stack --out runs/fifty --epochs 20 --demonstrations 50
        optimus train data/stack --out runs/rnn --preset quick-rnn --head gaussian
        optimus train data/stack data/pick-place --out runs/both --recipe paper --batch 512 --accumulate 8
        optimus train data/stack --corrections data/corrections --initial runs/policy --out runs/better
        optimus train data/stack --out runs/stack --steps 3000 --dagger 2 --dagger-episodes 50
        torchrun --nproc-per-node 2 -m optimus.cli train data/stack --out runs/stack --steps 5000

    Args:
        out: the run's folder
        minutes: time to train for; the learning rate anneals over it (that of the recipe `paper`: over 100K steps, however long it
            trains); 10 unless --epochs, --steps or the recipe say how long
        epochs: pass over the demonstrations this many times instead: no result depends on the machine's pace
        steps: train for this many gradient steps instead
        seed: of the first weights and of the order of the data
        demonstrations: learn from the first so many of each dataset alone, to see how many are needed; held out are the same ones
        preset: the network
        head: what answers, in place of the preset's own
        observe: see with cameras, or be told how the objects lie (the paper's ablation)
        recipe: quick (minutes on a CPU), paper (Table D.1: 1M steps of 16 windows, 1e-4 to 1e-5 over 100K) or gpu (the paper's
            networks in minutes: 20 epochs of 64 windows, all frames labelled); by default the preset's own
        batch: windows in a step, all processes together, in place of the recipe's
        consecutive: cut the batch in runs of so many windows, one frame apart, whose frames are encoded once
        labels: learn the actions at all frames of a window or only at its last; by default the recipe's (quick: all, paper: last)
        accumulate: compute a batch in this many portions, one after the other
        ema: decay of the running average of the weights that is kept; 0 keeps the newest weights
        precision: of the convolutions; auto: bfloat16 where the hardware has it
        device: what to train on; auto: a GPU if there is one
        board: where the figures can be watched: `tensorboard --logdir OUT`, or Weights & Biases
        corrections: further datasets, from `optimus collect --policy`, to train on as well
        initial: a run folder whose weights, and whose network, to begin with
        dagger: rounds in which the newest policy acts, the planner answers from wherever that led, and training goes on
        dagger_episodes: successful episodes that each round adds
        dagger_plain: add as many demonstrations by the expert alone instead, for comparison
        dagger_evaluations: episodes in which success is measured before and after each round
    """
    from optimus.dagger import DaggerConfig
    from optimus.errors import OptimusError
    from optimus.learn.presets import preset as chosen_preset
    from optimus.learn.ranks import is_first
    from optimus.learn.sources import crop_of
    from optimus.learn.train import train as run_train
    from optimus.pretrained import trained_folder

    chosen = chosen_preset(preset, head, observe)
    chosen = replace(chosen, policy=replace(chosen.policy, crop=crop_of(datasets)))
    initial = None if initial is None else trained_folder(initial)
    if initial is not None and (preset, head, observe) != ("quick", None, "images"):
        _require_network_of(initial, chosen.policy)
    how = recipe or chosen.recipe
    asked = Asked(minutes, epochs, steps, seed, demonstrations, how, batch, consecutive, labels, accumulate, ema, precision, device)
    config = asked.config
    if not dagger and DaggerConfig(1, dagger_episodes, dagger_plain, dagger_evaluations) != DaggerConfig(1):
        named = "--dagger-episodes, --dagger-plain, --dagger-evaluations"
        raise OptimusError(f"{named} say how rounds go; ask for some with --dagger ROUNDS")
    rounds = DaggerConfig(dagger, dagger_episodes, dagger_plain, dagger_evaluations, workers) if dagger else None
    if is_first():
        for dataset in datasets:
            _curate_if_needed(dataset)
    if rounds is not None:
        _require_plain_lesson(datasets, corrections, initial)
        _rounds(datasets[0], out, (config, chosen.policy), rounds, board, json)
        return
    with bar(None, "train", "step", silent=not is_first()) as shown:
        policy = run_train(datasets, out, config, chosen.policy, _training(shown), corrections, initial, board)
    if is_first():
        count = policy.parameter_count
        network = {"preset": preset} if initial is None else {"initial": str(initial)}
        say({"run": str(out), **network, "parameters": count}, json, f"{out}  ({count:,} parameters)")


def _require_network_of(initial: Path, asked: PolicyConfig) -> None:
    """`CheckpointError` if another network was asked for than the run has whose weights training is to begin with."""
    from optimus.errors import CheckpointError
    from optimus.learn import checkpoint

    if checkpoint.load(initial).config != asked:
        own = "brings a network of its own, not the one asked for; leave out --preset, --head, --observe"
        raise CheckpointError(f"--initial {initial} {own}")


def _require_plain_lesson(datasets: tuple[Path, ...], corrections: tuple[Path, ...], initial: Path | None) -> None:
    """`DatasetError` for what does not go with --dagger."""
    from optimus.errors import DatasetError

    if len(datasets) != 1 or corrections or initial or int(os.environ.get("WORLD_SIZE", "1")) > 1:
        raise DatasetError("--dagger takes one dataset and one process, without --corrections and --initial")


def _rounds(
    dataset: Path,
    out: Path,
    lesson: tuple[TrainConfig, PolicyConfig],
    rounds: DaggerConfig,
    board: BoardName,
    json: bool,
) -> None:
    from optimus.dagger import dagger

    bars = StageBars()
    try:
        report = dagger(dataset, out, lesson[0], rounds, bars, lesson[1], board)
    finally:
        bars.close()
    lines = [f"{out / row['policy']}: {row['demonstrations']} demonstrations, {rate(row['success'])}" for row in report["rounds"]]
    say({"run": str(out), **report}, json, "\n".join(lines))


@dataclass(frozen=True)
class Asked:
    """What the options of `train` say about how."""

    minutes: float | None
    epochs: float | None
    steps: int | None
    seed: int
    demonstrations: int | None
    recipe: str
    batch: int | None
    consecutive: int
    labels: Literal["all", "last"] | None
    accumulate: int
    ema: float | None
    precision: str
    device: Literal["auto", "cpu", "cuda"]

    @property
    def config(self) -> TrainConfig:
        """The recipe, with what was asked for in place of its own."""
        from optimus.learn.recipe import recipe

        base = recipe(self.recipe)
        windows = base.loss.runs if self.batch is None else self.batch
        loss = replace(base.loss, runs=self._runs(windows), supervise=self.labels or base.loss.supervise)
        optimiser = base.optimiser if self.ema is None else replace(base.optimiser, average=self.ema)
        return replace(
            base,
            steps=base.steps if self._how_long is None else self.steps,
            epochs=base.epochs if self._how_long is None else self.epochs,
            minutes=base.minutes if self.minutes is None else self.minutes,
            seed=self.seed,
            demonstrations=self.demonstrations,
            windows=self.consecutive,
            loss=loss,
            optimiser=optimiser,
            accumulate=self.accumulate,
            half=None if self.precision == "auto" else self.precision == "bfloat16",
            device=self.device,
        )

    @property
    def _how_long(self) -> str | None:
        """The option that says for how long, if one does; `TrainingError` if several do."""
        from optimus.learn.train import TrainingError

        given = [name for name in ("minutes", "epochs", "steps") if getattr(self, name) is not None]
        if len(given) > 1:
            raise TrainingError(f"{' and '.join(f'--{name}' for name in given)} each say how long to train; give one of them")
        return given[0] if given else None

    def _runs(self, windows: int) -> int:
        """How many runs that many windows are; `BatchError` if that is no whole number."""
        from optimus.learn.gradient import BatchError

        if self.consecutive < 1 or windows % self.consecutive:
            valid = ", ".join(str(n) for n in range(1, windows + 1) if windows % n == 0)
            raise BatchError(f"--consecutive {self.consecutive}: a batch of {windows} windows takes one of {valid}")
        return windows // self.consecutive


def _training(bar: Any) -> Callable[[Progress], None]:
    def progress(p: Progress) -> None:
        bar.total, bar.n = p.steps, p.step
        shown = ("loss", "held_out_action_error_mm", "labels_per_second")
        bar.set_postfix({k: f"{p.metrics[k]:.3g}" for k in shown if k in p.metrics}, refresh=False)
        bar.update(0)

    return progress


def _curate_if_needed(dataset: Path) -> None:
    """Curate, unless it has been done and every episode was there then; `DatasetError` if what was done is damaged: the rules that
    were asked for are lost then, and others hold other episodes out."""
    from optimus.data.curate import CURATION_FILE, CurationConfig, curate, load_curation
    from optimus.data.store import EpisodeStore

    store = EpisodeStore.open(dataset)
    if not (dataset / CURATION_FILE).exists():
        curate(dataset)
        return
    known = load_curation(dataset)
    if set(known.kept) | set(known.dropped) == set(store.seeds):
        return
    try:
        asked = CurationConfig(**known.config)
    except TypeError:  # rules of another program's
        asked = CurationConfig()
    curate(dataset, asked)
