"""The skeleton search against an optimal planner of others' making, on problems that both read from the same operators."""

import subprocess
import sys
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from optimus.logic import Atom, Facts, Operator, applicable, obstructs, skeletons
from optimus.objects.shapes import block, slab
from optimus.pddl import Pddl, to_pddl
from optimus.planner import with_unblocking
from optimus.predicates import On, facts_of
from optimus.robots import PANDA
from optimus.scene import Fixture, Movable, Scene
from optimus.se3 import Pose
from optimus.skills import SKILLS
from optimus.state import State

EDGE = 0.04
TABLE = Fixture("table", slab(0.4, 0.4, 0.05, (1.0, 1.0, 1.0, 1.0)), (0.5, 0.0, -0.025))

found = find_spec("up_fast_downward")
DRIVER = Path((found.submodule_search_locations or [""])[0] if found else "missing") / "downward" / "fast-downward.py"
with_fast_downward = pytest.mark.skipif(not DRIVER.exists(), reason="Fast Downward is not installed")

Problem = tuple[Facts, Facts, tuple[Operator, ...]]


def towers(rng: np.random.Generator, names: list[str], more: float) -> list[list[str]]:
    """Random towers, each from the bottom up; a block begins a new one with probability `more`."""
    found: list[list[str]] = []
    for i in rng.permutation(len(names)):
        if not found or rng.random() < more:
            found.append([names[i]])
        else:
            found[int(rng.integers(len(found)))].append(names[i])
    return found


def problem(rng: np.random.Generator, blocks: int, learned: int = 0) -> Problem:
    """Blocks in random towers, wanted in others; `learned` times, a block is said to be in the way of some operator."""
    names = [f"b{i}" for i in range(blocks)]
    scene = Scene(PANDA, (TABLE,), tuple(Movable(n, block(EDGE, (1.0, 0.0, 0.0, 1.0))) for n in names), ())
    poses = {
        name: Pose.of((0.3 + 0.1 * k, 0.0, EDGE * (height + 0.5)))
        for k, tower in enumerate(towers(rng, names, 0.4))
        for height, name in enumerate(tower)
    }
    facts = facts_of(scene, State(np.array(PANDA.home), 0.08, poses, Pose.of((0.0, 0.0, 1.0))))
    operators = tuple(o for skill in SKILLS.values() for o in skill.operators(scene, facts))
    in_the_way = frozenset(
        obstructs(names[int(rng.integers(blocks))], operators[int(rng.integers(len(operators)))]) for _ in range(learned)
    )
    goal = frozenset(On(upper, lower) for tower in towers(rng, names, 0.3) for lower, upper in pairwise(tower))
    return facts | in_the_way, goal, with_unblocking(operators, in_the_way)


def optimum(pddl: Pddl, folder: Path) -> tuple[Operator, ...] | None:
    """The cheapest plan by Fast Downward's blind A*, None if it proves that there is none."""
    (folder / "domain.pddl").write_text(pddl.domain)
    (folder / "problem.pddl").write_text(pddl.problem)
    command = [sys.executable, str(DRIVER), "--plan-file", "plan", "domain.pddl", "problem.pddl", "--search", "astar(blind())"]
    # invariants make the search quicker, not its answer another; of propositions alone, they take seconds to find
    command += ["--translate-options", "--invariant-generation-max-time", "0"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode in (10, 11, 12):  # proved unsolvable
        return None
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr
    return pddl.plan((folder / "plan").read_text())


def carried_out(plan: tuple[Operator, ...], facts: Facts) -> Facts:
    for operator in plan:
        assert applicable(operator, facts), operator
        facts = operator.apply(facts)
    return facts


@with_fast_downward
@pytest.mark.parametrize("seed", range(20))
def test_the_first_skeleton_is_as_short_as_the_optimum(seed: int, tmp_path: Path) -> None:
    rng = np.random.default_rng(seed)
    facts, goal, operators = problem(rng, blocks=3 + seed % 3, learned=3 * (seed % 2))
    best = optimum(to_pddl(facts, goal, operators), tmp_path)
    first = next(skeletons(facts, goal, operators), None)
    assert (first is None) == (best is None)
    if first is not None and best is not None:
        assert goal <= carried_out(best, facts) and goal <= carried_out(first, facts)
        assert len(first) == len(best)


@with_fast_downward
def test_both_know_when_there_is_no_way(tmp_path: Path) -> None:
    facts, _, operators = problem(np.random.default_rng(0), blocks=3)
    goal = frozenset({On("b0", "b1"), On("b1", "b0")})
    assert next(skeletons(facts, goal, operators), None) is None
    assert optimum(to_pddl(facts, goal, operators), tmp_path) is None


def test_random_problems_are_not_trivial() -> None:
    lengths = [len(next(skeletons(*problem(np.random.default_rng(s), 5)), ())) for s in range(10)]
    assert max(lengths) >= 8 and len(set(lengths)) > 2, lengths


def test_names_that_differ_in_case_or_brackets_alone_stay_apart() -> None:
    a, b = Atom("On", ("cubeA", "x")), Atom("On", ("cubea", "x"))
    operators = (Operator("move", ("A",), frozenset({a}), frozenset({b}), frozenset({a})),)
    operators += (Operator("move", ("a",), frozenset({b}), frozenset({a}), frozenset({b})),)
    pddl = to_pddl(frozenset({a}), frozenset({b}), operators)
    assert len(pddl.actions) == 2
    assert pddl.domain.count("(on-cubea-x)") and pddl.domain.count("(on-cubea-x--2)")
    assert pddl.plan("(move-a)\n; cost = 1 (unit cost)\n") == operators[:1]
