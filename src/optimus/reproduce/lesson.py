"""From demonstrations to a trained policy and its trials, each stage going on where it was stopped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from optimus.collect import CollectConfig, collect
from optimus.conditions import USUAL, Conditions
from optimus.data.atomic import read_record, write_json
from optimus.data.curate import CURATION_FILE, CurationConfig, curate
from optimus.demonstrate import ExpertConfig
from optimus.evaluate import EvalReport, evaluate, policy_folder, random_starts, states_label, task_of, validation_starts
from optimus.expert import TimeLaw
from optimus.learn import checkpoint
from optimus.learn.presets import HeadName, Observe, preset
from optimus.learn.train import Progress, train
from optimus.reproduce.site import Site, machine
from optimus.rerender import RenderConfig, rerender
from optimus.rollout import Perturbation
from optimus.skills import Style
from optimus.tasks import with_objects
from optimus.words import slug

STEPS_BETWEEN_NOTES = 20
_DONE = "done"
"""In a policy's folder once it has been trained: on what machine."""


@dataclass(frozen=True)
class Data:
    """A dataset: of which task, collected how."""

    task: str
    objects: str | None = None
    planner: Literal["fixed", "random"] = "fixed"
    """Grasps, arm postures and motions in a fixed order, or at random as the paper's planner takes them."""
    stall: int = TimeLaw().stall
    gripper: Literal["binary", "continuous"] = "binary"
    cameras: tuple[str, ...] = ()
    """Only these, rendered anew from the states of the dataset with all."""

    @property
    def name(self) -> str:
        parts = [with_objects(self.task, self.objects), "random" if self.planner == "random" else ""]
        parts += [f"stall={self.stall}" if self.stall != Data("").stall else "", "" if self.gripper == "binary" else self.gripper]
        return slug(" ".join(filter(None, [*parts, *self.cameras])))

    def folder(self, site: Site) -> Path:
        return site.out / "data" / self.name

    def collected(self, site: Site) -> Path:
        """The curated dataset's folder; whatever is missing of it is made."""
        folder, wanted = self.folder(site), site.budget.demonstrations
        if self.cameras:
            source = replace(self, cameras=()).collected(site)
            with site.timed(f"render {self.name}"):
                note = lambda done, of: site.progress(f"render {self.name}", done, of, {})  # noqa: E731
                rerender(source, folder, RenderConfig(cameras=self.cameras), site.workers, progress=note)
            return folder
        with site.timed(f"collect {self.name}"):
            collect(self._config(site), lambda tally: site.progress(f"collect {self.name}", tally.successes, wanted, {}))
            if not (folder / CURATION_FILE).exists():
                curate(folder, CurationConfig(seed=site.seed))
        return folder

    def _config(self, site: Site) -> CollectConfig:
        style = Style(grasps="random", ik="random", motion="sampled") if self.planner == "random" else Style()
        expert = ExpertConfig(style, TimeLaw(stall=self.stall, gripper=self.gripper), perturbation=Perturbation())
        task = with_objects(self.task, self.objects)
        return CollectConfig(task, self.folder(site), site.budget.demonstrations, site.seed, site.workers, expert)

    def commands(self, site: Site) -> list[str]:
        if self.cameras:
            source = replace(self, cameras=())
            again = f"optimus render data/{source.name} --out data/{self.name} --cameras {' '.join(self.cameras)}"
            return [*source.commands(site), again]
        said = f" --objects {self.objects}" if self.objects else ""
        said += " --grasps random --ik random --motion sampled" if self.planner == "random" else ""
        said += f" --stall {self.stall}" if self.stall != Data("").stall else ""
        said += f" --gripper {self.gripper}" if self.gripper != "binary" else ""
        n = site.budget.demonstrations
        collected = f"optimus collect {self.task} --episodes {n} --seed {site.seed}{said} --out data/{self.name}"
        return [collected, *([f"optimus curate data/{self.name} --seed {site.seed}"] if site.seed else [])]


@dataclass(frozen=True)
class Trial:
    """One way of trying a policy."""

    name: str
    states: Literal["validation", "random"]
    which: Literal["last", "best"] = "last"
    conditions: Conditions = USUAL
    objects: str | None = None
    """With random states: what to do the task with, as `evaluate.Start` takes it."""
    task: str | None = None
    """With random states: which of its tasks a policy of several is to do."""

    @property
    def label(self) -> str:
        """Of the initial states; names the file of outcomes."""
        return states_label(self.states, self.task, self.objects)

    def under(self, site: Site) -> Conditions:
        return replace(self.conditions, horizon=site.budget.horizon)

    def command(self, site: Site, lesson: Lesson, seed: int) -> str:
        source = f"--dataset data/{lesson.datasets[0].name}" if self.states == "validation" else "--states random"
        said = f" --objects '{self.objects}'" if self.objects is not None else ""
        said += f" --task {self.task}" if self.task else ""
        said += f" --checkpoint {self.which}" if self.which != "last" else ""
        said += f" --episodes {site.budget.episodes} --seed {seed}{options(self.under(site))}"
        return f"optimus evaluate policies/{lesson.name}/seed-{seed} {source}{said}"


@dataclass(frozen=True)
class Lesson:
    """What a policy is taught with."""

    datasets: tuple[Data, ...]
    method: str = "OPTIMUS"
    head: HeadName | None = None
    observe: Observe = "images"

    @property
    def name(self) -> str:
        parts = [*(data.name for data in self.datasets), self.method, self.head or "", "" if self.observe == "images" else "state"]
        return slug(" ".join(filter(None, parts)))

    def run(self, site: Site, seed: int) -> Path:
        return site.out / "policies" / self.name / f"seed-{seed}"

    def collect(self, site: Site) -> list[Path]:
        """The folders of its datasets, collected and curated; whatever is missing is made."""
        return [data.collected(site) for data in self.datasets]

    def learn(self, site: Site, seed: int) -> None:
        """Train the policy of that seed, unless that is done."""
        run = self.run(site, seed)
        if (run / _DONE).exists():
            return
        folders = self.collect(site)
        network = site.budget.presets[self.method]
        config, policy = site.budget.training(network, seed), preset(network, self.head, self.observe).policy
        stage = f"train {self.name}"
        with site.timed(stage):
            train(folders, run, config, policy, _noting(site, stage))
        write_json(run / _DONE, machine())

    def machine(self, site: Site, seed: int) -> dict[str, Any]:
        """What the policy of that seed was trained on, and where its trials were gone on with, if that is another machine."""
        here, done = machine(), self.run(site, seed) / _DONE
        there = read_record(done) if done.exists() and done.stat().st_size else here  # earlier versions left it empty
        return here if there == here else {**there, "processor": f"{there['processor']}; then {here['processor']}"}

    def tried(self, site: Site, seed: int, trial: Trial) -> dict[str, Any]:
        """The report of an evaluation; what was evaluated earlier is read, for the best policy also where it is the last one."""
        run = policy_folder(self.run(site, seed), trial.which)
        if trial.which == "best" and checkpoint.best_is_last(self.run(site, seed)):
            run = self.run(site, seed)
        n, stage = site.budget.episodes, f"evaluate {self.name} {trial.name}".strip()
        if trial.states == "validation":
            starts = validation_starts(self.datasets[0].folder(site), n)
        else:
            starts = random_starts(n, seed, trial.objects, trial.task)
        task = task_of(checkpoint.read_config(run)["task"], starts[0].task, run)
        asked = EvalReport(task, trial.label, (), trial.under(site), seed=seed, weights=checkpoint.weights_of(run))
        if known := asked.answered(run, [s.seed for s in starts]):
            return known
        with site.timed(stage):
            note = lambda done, k: site.progress(stage, done, n, {"successes": str(k)})  # noqa: E731
            report = evaluate(run, starts, trial.label, seed, site.workers, progress=note, conditions=trial.under(site), keep=True)
        report.write(run)
        return report.as_dict()

    def train_command(self, site: Site, seed: int) -> str:
        b, network = site.budget, site.budget.presets[self.method]
        long = "--{} {:.9g}".format(*b.how_long)
        said = (f" --head {self.head}" if self.head else "") + (f" --observe {self.observe}" if self.observe != "images" else "")
        said += f" --recipe {b.recipe}" if b.recipe is not None else ""
        said += f" --batch {b.batch}" if b.batch is not None else ""
        data = " ".join(f"data/{d.name}" for d in self.datasets)
        return f"optimus train {data} --out policies/{self.name}/seed-{seed} --preset {network} {long} --seed {seed}{said}"


def options(conditions: Conditions) -> str:
    """The conditions as options of the command line."""
    parts = [f" --perturb {conditions.perturb}"] if conditions.perturb else []
    parts += [f" --{n} {getattr(conditions, n):g}" for n in ("friction", "mass") if getattr(conditions, n) != 1.0]
    return "".join(parts) + (f" --horizon {conditions.horizon}" if conditions.horizon is not None else "")


def _noting(site: Site, stage: str) -> Callable[[Progress], None]:
    def note(p: Progress) -> None:
        if p.step % STEPS_BETWEEN_NOTES == 0 or p.step == p.steps:
            shown = {k: f"{p.metrics[k]:.3g}" for k in ("loss", "held_out_action_error_mm") if k in p.metrics}
            site.progress(stage, p.step, p.steps, shown)

    return note
