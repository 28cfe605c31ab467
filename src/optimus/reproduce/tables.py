"""The paper's tables and figures as data: which rows, which columns, and what fills each cell."""

from __future__ import annotations

import json
from dataclasses import dataclass
from importlib import resources

from optimus.conditions import USUAL, Conditions
from optimus.data.episode import OSC
from optimus.learn.presets import HeadName
from optimus.reproduce.budget import LOCATING, METHODS
from optimus.reproduce.views import STACK_CLOSE, STACK_DISTANT
from optimus.reproduce.work import USUAL_TRIALS, Data, ExpertTime, ExpertWork, Lesson, PolicyTime, PolicyWork, Trial, Work

UNFORESEEN = (
    ("pushed", Conditions("push")),
    ("slips", Conditions("slip")),
    ("friction halved", Conditions(friction=0.5)),
    ("mass doubled", Conditions(mass=2.0)),
)
"""What neither the planner nor the demonstrations know of."""
WRIST = "robot0_eye_in_hand"


@dataclass(frozen=True)
class Cell:
    """One cell, named by its row and column as the paper names them where it has them."""

    row: str
    column: str
    work: Work

    @property
    def name(self) -> str:
        return f"{self.row} {self.column}".strip()


@dataclass(frozen=True)
class Table:
    """A table to reproduce."""

    name: str
    title: str
    cells: tuple[Cell, ...]

    @property
    def rows(self) -> tuple[str, ...]:
        """Its rows' names."""
        return tuple(dict.fromkeys(cell.row for cell in self.cells))

    @property
    def columns(self) -> tuple[str, ...]:
        """Its columns' names."""
        return tuple(dict.fromkeys(cell.column for cell in self.cells))

    @property
    def papers(self) -> dict[str, dict[str, float]]:
        """The paper's figures, row -> column -> percent, or seconds."""
        return papers_figures()[self.name]


def papers_figures() -> dict[str, dict[str, dict[str, float]]]:
    """The paper's figures by table."""
    return json.loads(resources.files("optimus.reproduce").joinpath("paper.json").read_text())


def _methods(*rows: tuple[str, str]) -> tuple[Cell, ...]:
    """Every method on every task."""
    return tuple(Cell(row, m, PolicyWork(Lesson((Data(task),), m))) for row, task in rows for m in METHODS)


def _against_planner(*rows: tuple[str, str]) -> tuple[Cell, ...]:
    ours = (*USUAL_TRIALS, *(Trial(name, "random", conditions=c) for name, c in UNFORESEEN))
    return tuple(
        cell
        for row, task in rows
        for cell in (
            Cell(row, "TAMP-joint", ExpertWork(task, "joint")),
            Cell(row, "TAMP-task", ExpertWork(task, OSC, (("", USUAL), *UNFORESEEN))),
            Cell(row, "OPTIMUS", PolicyWork(Lesson((Data(task),)), ours)),
        )
    )


def _ablations() -> tuple[Cell, ...]:
    stack = Data("stack")
    heads: tuple[tuple[str, HeadName], ...] = (("GMM", "gmm"), ("Gaussian", "gaussian"), ("MSE", "mse"))
    lessons = [
        ("as chosen: GMM, stall of 5, binary gripper, tuned view, wrist camera, images", Lesson((stack,))),
        *((f"{said} loss", Lesson((stack,), head=head)) for said, head in heads[1:]),
        *((f"{said} loss, planner at random", Lesson((Data("stack", planner="random"),), head=head)) for said, head in heads),
        ("stall of 25", Lesson((Data("stack", stall=25),))),
        ("continuous gripper", Lesson((Data("stack", gripper="continuous"),))),
        ("close view", Lesson((Data(STACK_CLOSE.name),))),
        ("distant view", Lesson((Data(STACK_DISTANT.name),))),
        ("no wrist camera", Lesson((Data("stack", cameras=("agentview",)),))),
        ("Microwave, wrist camera", Lesson((Data("microwave"),))),
        ("Microwave, no wrist camera", Lesson((Data("microwave", cameras=("leftshoulder", "rightshoulder")),))),
        ("state, not images", Lesson((stack,), observe="state")),
    ]
    return tuple(Cell(row, "OPTIMUS", PolicyWork(lesson)) for row, lesson in lessons)


def _many_objects() -> tuple[Cell, ...]:
    small, large = Data("pick-place", "19"), Data("pick-place", "72")
    # of 19, the rest of the library is unseen; of all 72, the task's own plain shapes are
    others = (*USUAL_TRIALS, Trial("unseen objects", "random", objects="unseen"))
    foreign = (*USUAL_TRIALS, Trial("unseen objects", "random", objects=""))
    alone = (("Shelf", "shelf"), ("Microwave", "microwave"))
    both = Lesson((Data("shelf", "72"), Data("microwave", "72")))
    trials = tuple(Trial(n, "random", task=f"{t}@72") for n, t in (("", "shelf"), ("on Microwave", "microwave")))
    return (
        Cell("PickPlace, 19 objects", "OPTIMUS", PolicyWork(Lesson((small,)), others)),
        Cell("PickPlace, 72 objects", "OPTIMUS", PolicyWork(Lesson((large,)), foreign)),
        *(Cell(f"{row}, 72 objects", "OPTIMUS", PolicyWork(Lesson((Data(task, "72"),)))) for row, task in alone),
        Cell("Shelf and Microwave, one policy, 72 objects", "OPTIMUS", PolicyWork(both, trials)),
    )


def _times() -> tuple[Cell, ...]:
    tasks = (("stack", "Stack"), ("pick-place", "PickPlace"), ("shelf", "Shelf"), ("microwave", "Microwave"))
    expert = [Cell(f"TAMP, {said}", "time per action", ExpertTime(task)) for task, said in tasks]
    return (
        *expert,
        *(Cell(p, "time per action", PolicyTime(p)) for p in ("quick", "optimus-30m", "optimus-60m", "optimus-100m")),
    )


TABLES: dict[str, Table] = {
    t.name: t
    for t in (
        Table(
            "table-b1",
            "Table B.1: adapting to the scene. Receptacles: validation states of sizes that no training demonstration has",
            _methods(
                ("StackAdapt", "stack-adapt"),
                ("MicrowaveAdapt", "microwave-adapt"),
                ("ShelfReceptacle", "shelf-receptacle"),
                ("MicrowaveReceptacle", "microwave-receptacle"),
            ),
        ),
        Table(
            "table-b2",
            "Table B.2: the policy and its planner",
            _against_planner(
                ("PickPlace", "pick-place"),
                ("PickPlaceTwo", "pick-place-two"),
                ("PickPlaceThree", "pick-place-three"),
                ("PickPlaceFour", "pick-place-four"),
                ("Shelf", "shelf"),
                ("Microwave", "microwave"),
                ("Stack", "stack"),
            ),
        ),
        Table("table-b3", "Table B.3: time per action, one core", _times()),
        Table("figure-a1", "Figure A.1: observation, action and loss", _ablations()),
        Table(
            "long-horizon",
            "Many steps: towers of three to five, two to four things into bins",
            _methods(
                ("StackThree", "stack-three"),
                ("StackFour", "stack-four"),
                ("StackFive", "stack-five"),
                ("PickPlaceTwo", "pick-place-two"),
                ("PickPlaceThree", "pick-place-three"),
                ("PickPlaceFour", "pick-place-four"),
            ),
        ),
        Table(
            "four-tasks",
            "The paper's network on four tasks",
            tuple(
                Cell(row, method, PolicyWork(Lesson((Data(task),), method), (USUAL_TRIALS[0], USUAL_TRIALS[2])))
                for method in (LOCATING, "OPTIMUS")
                for row, task in (
                    ("PickPlace", "pick-place"),
                    ("StackThree", "stack-three"),
                    ("Shelf", "shelf"),
                    ("Microwave", "microwave"),
                )
            ),
        ),
        Table("multitask", "Many objects, seen and unseen", _many_objects()),
    )
}
