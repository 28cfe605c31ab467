"""The paper's tables: every row is there, what is done is not done again, what is written says what was measured."""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import threading
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import torch
from matplotlib.image import imread

from optimus.conditions import Conditions
from optimus.errors import DatasetError, OptimusError, UnknownNameError
from optimus.learn import checkpoint
from optimus.learn.presets import PRESETS
from optimus.learn.shrink import shrink
from optimus.reproduce import BUDGETS, TABLES, Site, budget, reproduce
from optimus.reproduce import engine as engine_module
from optimus.reproduce import site as site_module
from optimus.reproduce.tables import Cell, Table, papers_figures
from optimus.reproduce.work import Data, ExpertWork, Lesson, PolicyWork, Trial
from optimus.reproduce.write import commands_of
from optimus.statistics import wilson
from optimus.tasks import TASKS, task
from optimus.words import slug

SMALL = Table(
    "table-b2",
    "A table of two cells",
    (
        Cell("Stack", "TAMP-task", ExpertWork("stack", conditions=(("", Conditions()), ("pushed", Conditions("push"))))),
        Cell("Stack", "OPTIMUS", PolicyWork(Lesson((Data("stack"),)), (Trial("", "validation"), Trial("best", "random", "best")))),
    ),
)


def test_every_figure_of_the_paper_has_its_cell() -> None:
    assert set(papers_figures()) == set(TABLES)
    for name, table in TABLES.items():
        there = {(c.row, c.column) for c in table.cells}
        told = {(row, column) for row, columns in table.papers.items() for column in columns}
        assert told <= there, f"{name} lacks {told - there}"
        assert len({slug(c.name) for c in table.cells}) == len(table.cells)


def test_what_the_tables_name_exists() -> None:
    assert all(p in PRESETS for b in BUDGETS.values() for p in b.presets.values())
    site = Site("table-b1", Path("out"), budget("cpu"))
    for table in TABLES.values():
        for cell in table.cells:
            for command in cell.work.commands(site):
                verb, first = command.split()[1:3]
                if verb == "collect":
                    task(first)
    with pytest.raises(UnknownNameError, match="smoke"):
        budget("none")


def test_every_task_and_method_is_in_some_table() -> None:
    methods = {"OPTIMUS", "BC-MLP", "BC-RNN", "BeT"}
    for name, count in (("table-b1", 4), ("long-horizon", 6)):
        assert len(TABLES[name].cells) == 4 * count and {c.column for c in TABLES[name].cells} == methods
    text = json.dumps([c.work.commands(Site("", Path(), budget("cpu"))) for t in TABLES.values() for c in t.cells])
    assert all(re.search(rf"\b{name}\b", text) for name in TASKS)


def test_views_draw_the_same_problems_before_another_camera() -> None:
    for name in ("STACK_CLOSE", "STACK_DISTANT"):
        other, own = task(f"optimus.reproduce.views:{name}").problem(7), task("stack").problem(7)
        assert other.goal == own.goal and other.scene.movables == own.scene.movables
        assert all(np.array_equal(other.poses[n].pos, own.poses[n].pos) for n in own.poses)
        assert other.scene.cameras != own.scene.cameras


def test_a_killed_reproduction_goes_on_and_says_what_was_measured(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(TABLES, "table-b2", SMALL)
    tiny = replace(budget("smoke"), episodes=1, expert_episodes=1, demonstrations=2)

    tried: list[str] = []

    def stop(where: str, stage: str, done: int, total: int, notes: dict[str, str]) -> None:
        tried.append(stage)
        if stage.startswith(where):
            raise KeyboardInterrupt

    for where in ("expert stack osc push", "evaluate"):
        with pytest.raises(KeyboardInterrupt):
            reproduce(Site("table-b2", tmp_path, tiny, workers=1, progress=partial(stop, where)))
    assert tried.count("expert stack osc") == 1 and tried.count("expert stack osc push") == 2
    unfinished = json.loads((tmp_path / "results.json").read_text())
    assert not unfinished["complete"] and unfinished["missing"] == ["Stack OPTIMUS"]
    written = (tmp_path / "table.md").read_text()
    assert "missing: Stack OPTIMUS." in written and "--out DIR --rows Stack --columns TAMP-task\n" in written
    done = {p: p.stat().st_mtime_ns for p in (*tmp_path.rglob("*.safetensors"), *(tmp_path / "cells").iterdir())}
    # as if another machine had trained it, with a GPU
    elsewhere = {"processor": "Another One", "cores": 16, "gpu": "Large"}
    (tmp_path / "policies" / "stack-optimus" / "seed-0" / "done").write_text(json.dumps(elsewhere))
    stages: list[str] = []
    here = replace(tiny, device="auto")
    found = reproduce(Site("table-b2", tmp_path, here, workers=1, progress=lambda stage, *_: stages.append(stage)))
    assert {p: p.stat().st_mtime_ns for p in done} == done
    assert not [s for s in stages if s.startswith(("expert", "train", "collect"))]
    assert found["complete"] and found["hours"] > unfinished["hours"] > 0
    _check_written(tmp_path, found)
    _check_the_best_is_not_tried_again_where_it_is_the_last(Site("table-b2", tmp_path, tiny, workers=1))
    with pytest.raises(DatasetError, match="budget"):
        reproduce(Site("table-b2", tmp_path, budget("cpu")))


def _check_written(out: Path, found: dict[str, Any]) -> None:
    cells = json.loads((out / "results.json").read_text())["cells"]
    assert cells == found["cells"] and [c["row"] for c in cells] == ["Stack", "Stack"]
    measured = [m for cell in cells for m in cell["measured"].values()]
    assert len(measured) == 4 and all(m["interval"] == list(wilson(m["successes"], m["episodes"])) for m in measured)
    run = out / "policies" / "stack-optimus" / "seed-0"
    outcomes = [json.loads(line) for line in next(run.glob("evaluation-validation*.jsonl")).read_text().splitlines()]
    assert sum(o["success"] for o in outcomes) == cells[1]["measured"][""]["successes"] and len(outcomes) == 1
    rows = list(csv.DictReader((out / "table.csv").open()))
    assert [int(r["episodes"]) for r in rows] == [m["episodes"] for m in measured]
    written = (out / "table.md").read_text()
    assert "proves the path" in written and "--rows" not in written
    assert all(command in written for c in found["cells"] for command in c["commands"])
    assert imread(out / "plot.png").std() > 0
    planner, policy = (c["machine"] for c in cells)
    assert policy == {"processor": f"Another One; then {planner['processor']}", "cores": 16, "gpu": "Large"}
    assert all(m["processor"] in written for m in (planner, policy))
    of = {c["commit"] for c in cells}
    assert len(of) == 1 and (of == {None} or f"| {of.pop()} |" in written)


def _check_the_best_is_not_tried_again_where_it_is_the_last(site: Site) -> None:
    lesson = Lesson((Data("stack"),))
    run = lesson.run(site, 0)
    shutil.copy(run / checkpoint.MODEL_FILE, run / checkpoint.BEST_FOLDER)
    files = set(run.rglob("*"))
    last, best = (lesson.tried(site, 0, Trial("", "validation", which)) for which in ("last", "best"))
    assert best == last and set(run.rglob("*")) == files


def _checkout(root: Path, package: str) -> Path:
    """The package committed at that place of a new repository."""
    there = root / package
    shutil.copytree(Path(engine_module.__file__).parents[1], there, ignore=shutil.ignore_patterns("__pycache__"))
    author = ("-c", "user.name=A", "-c", "user.email=a@b.c")
    for words in (("init", "-q"), ("add", "."), (*author, "commit", "-qm", "all")):
        subprocess.run(("git", "-C", str(root), *words), check=True)
    return there


def test_a_commit_is_named_only_where_the_package_runs_from_its_own_checkout(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def commit_of(package: Path) -> str | None:
        monkeypatch.setattr(site_module, "__file__", str(package / "reproduce" / "site.py"))
        return site_module.commit()

    own = _checkout(tmp_path / "own", "src/optimus")
    head = subprocess.check_output(("git", "-C", str(own), "rev-parse", "HEAD"), text=True)
    assert head.startswith(commit_of(own) or "none")
    (own / "py.typed").write_text("changed")
    assert str(commit_of(own)).endswith("-dirty")
    assert commit_of(_checkout(tmp_path / "other", "lib/optimus")) is None


def test_only_the_rows_asked_for_are_filled_and_a_later_call_fills_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    rows = [Cell(row, "TAMP-task", ExpertWork("stack")) for row in ("Stack", "Stack again", "StackThree")]
    monkeypatch.setitem(TABLES, "table-b2", Table("table-b2", "Rows", tuple(rows)))
    tiny = replace(budget("smoke"), expert_episodes=1)
    filled = lambda found: [c["row"] for c in found["cells"]]  # noqa: E731
    assert filled(reproduce(Site("table-b2", tmp_path, tiny, workers=1), ["Stack again"])) == ["Stack again"]
    found = reproduce(Site("table-b2", tmp_path, tiny, workers=1), ["Stack"])
    assert filled(found) == ["Stack", "Stack again"] and found["missing"] == ["StackThree TAMP-task"]
    with pytest.raises(UnknownNameError, match=r"row 'Stak'.*StackThree"):
        reproduce(Site("table-b2", tmp_path, tiny), ["Stak"])
    with pytest.raises(UnknownNameError, match=r"column 'TAMP'.*TAMP-task"):
        reproduce(Site("table-b2", tmp_path, tiny), columns=["TAMP"])


def test_only_the_columns_asked_for_are_filled_and_the_command_says_which(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cells = tuple(Cell(row, f"TAMP-{c}", ExpertWork("stack", c)) for row in ("Stack", "Tower") for c in ("joint", "osc"))
    monkeypatch.setitem(TABLES, "table-b2", Table("table-b2", "Columns", cells))
    site = Site("table-b2", tmp_path, replace(budget("smoke"), expert_episodes=1), workers=1)
    found = reproduce(site, columns=["TAMP-joint"])
    assert [(c["row"], c["column"]) for c in found["cells"]] == [("Stack", "TAMP-joint"), ("Tower", "TAMP-joint")]
    asked = lambda found, *of: [c.partition(" --rows ")[2] for c in commands_of(found, *of)]  # noqa: E731
    assert asked(found) == ["Stack Tower --columns TAMP-joint"]
    found = reproduce(site, ["Tower"])
    assert asked(found) == ["Stack --columns TAMP-joint", "Tower"]
    assert asked(found, "TAMP-joint") == ["Stack Tower --columns TAMP-joint"]
    assert asked(found, "TAMP-osc") == ["Tower --columns TAMP-osc"]


def test_where_a_gpu_trains_cells_are_prepared_ahead_and_the_table_is_the_same(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    works = [PolicyWork(Lesson((Data(t),)), (Trial("", "validation"),)) for t in ("stack", "pick-place")]
    cells = tuple(Cell(row, "OPTIMUS", work) for row, work in zip(("Stack", "Put"), works, strict=True))
    monkeypatch.setitem(TABLES, "table-b2", Table("table-b2", "Two policies", cells))
    tiny = replace(budget("smoke"), demonstrations=2, episodes=1)
    plain = reproduce(Site("table-b2", tmp_path / "plain", tiny, workers=1))
    monkeypatch.setattr(engine_module, "device_kind", lambda device: "cuda")
    # the first trial of the first policy waits for the training of the second one
    trained, seen, priorities = threading.Event(), [], {}

    def progress(stage: str, done: int, total: int, notes: dict[str, str]) -> None:
        seen.append(stage)
        if sys.platform == "linux":
            priorities.setdefault(stage.split()[0], os.getpriority(os.PRIO_PROCESS, threading.get_native_id()))
        if stage.startswith("train pick-place") and done == total:
            trained.set()
        if stage.startswith("evaluate stack"):
            assert trained.wait(120)

    ahead = reproduce(Site("table-b2", tmp_path / "ahead", tiny, workers=2, progress=progress))
    outcomes = lambda found: [c["measured"] for c in found["cells"]]  # noqa: E731
    assert outcomes(ahead) == outcomes(plain) and "train pick-place-optimus" in seen
    assert not priorities or priorities["collect"] > priorities["train"]
    assert ahead["hours"] >= sum(c["hours"] for c in ahead["cells"]) * 0.999 > 0

    def stop(stage: str, done: int, total: int, notes: dict[str, str]) -> None:
        if stage == "collect stack":
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        reproduce(Site("table-b2", tmp_path / "stopped", tiny, workers=2, progress=stop))


def test_a_folder_begun_by_an_earlier_version_goes_on(tmp_path: Path) -> None:
    site = Site("table-b2", tmp_path, budget("cpu"))
    site.open()
    recorded = json.loads((tmp_path / "reproduce.json").read_text())
    del recorded["asked"]["budget"]["recipe"], recorded["asked"]["budget"]["presets"]["OPTIMUS locating"]
    (tmp_path / "reproduce.json").write_text(json.dumps(recorded))
    Site("table-b2", tmp_path, budget("cpu")).open()
    recorded["asked"]["budget"]["presets"]["OPTIMUS"] = "optimus-30m"
    (tmp_path / "reproduce.json").write_text(json.dumps(recorded))
    with pytest.raises(DatasetError, match="another folder"):
        Site("table-b2", tmp_path, budget("cpu")).open()


def test_an_unknown_table_is_named(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="figure-a1"):
        engine_module.reproduce(Site("table-z9", tmp_path, budget("smoke")))
    with pytest.raises(UnknownNameError, match="'GMM loss, planner at random', 'Gaussian loss'"):  # as a shell takes them
        engine_module.reproduce(Site("figure-a1", tmp_path, budget("smoke")), ["Gaussian"])


def test_a_shrunk_policy_is_half_as_large_and_answers_alike(taught: tuple[Path, Path], tmp_path: Path) -> None:
    shrink(taught[1], tmp_path / "small")
    large, small = (p / checkpoint.MODEL_FILE for p in (taught[1], tmp_path / "small"))
    assert small.stat().st_size < 0.6 * large.stat().st_size
    a, b = (dict(checkpoint.load(p).named_parameters()) for p in (taught[1], tmp_path / "small"))
    for name, weight in a.items():
        assert (weight - b[name]).abs().max() <= 2**-8 * weight.abs().max()


def test_what_cannot_be_leaves_no_folder(tmp_path: Path) -> None:
    with pytest.raises(OptimusError, match="seed"):
        Site("table-b2", tmp_path / "a", budget("smoke"), seed=-1)
    if not torch.cuda.is_available():
        with pytest.raises(OptimusError, match="no GPU"):
            reproduce(Site("table-b2", tmp_path / "b", replace(budget("smoke"), device="cuda")), ["PickPlace"], ["OPTIMUS"])
    assert list(tmp_path.iterdir()) == []
    site = Site("table-b2", tmp_path / "c", budget("smoke"))
    site.open()
    with pytest.raises(DatasetError, match=r"budget's demonstrations = \d+, not 7; name another"):
        Site("table-b2", tmp_path / "c", replace(budget("smoke"), demonstrations=7)).open()
    (tmp_path / "c" / "reproduce.json").write_text("{")
    with pytest.raises(DatasetError, match="cannot read"):
        site.open()
    (tmp_path / "d").mkdir()
    (tmp_path / "d" / "dataset.json").write_text("{}")
    with pytest.raises(DatasetError, match="holds a dataset"):
        Site("table-b2", tmp_path / "d", budget("smoke")).open()
