"""The skeleton search, against breadth-first search and on puzzles whose answer is known."""

from collections import deque
from heapq import heappop, heappush
from itertools import count, islice, pairwise
from random import Random
from time import process_time

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from optimus.logic import Atom, Facts, Operator, applicable, obstructs, skeletons


def atom(*words: str) -> Atom:
    return Atom(words[0], words[1:])


def blocks_world(names: str) -> tuple[Operator, ...]:
    """The textbook operators: take, put on the table, put on another."""
    ops = []
    for a in names:
        free = frozenset({atom("clear", a), atom("empty")})
        ops.append(Operator("put", (a,), frozenset({atom("held", a)}), free | {atom("on", a, "t")}, frozenset({atom("held", a)})))
        for b in (*names, "t"):
            if b == a:
                continue
            on, uncovered = atom("on", a, b), frozenset({atom("clear", b)}) if b != "t" else frozenset()
            ops.append(Operator("take", (a, b), free | {on}, uncovered | {atom("held", a)}, free | {on}))
            if b != "t":
                needs = frozenset({atom("held", a), atom("clear", b)})
                ops.append(Operator("put", (a, b), needs, free | {on}, needs))
    return tuple(ops)


def world(stacks: list[str]) -> Facts:
    facts = {atom("empty")}
    for stack in stacks:
        facts |= {atom("on", a, b) for a, b in zip(stack[1:], stack, strict=False)}
        facts |= {atom("on", stack[0], "t"), atom("clear", stack[-1])}
    return frozenset(facts)


def shortest(facts: Facts, goal: Facts, operators: tuple[Operator, ...]) -> int:
    queue, seen = deque([(facts, 0)]), {facts}
    while queue:
        here, depth = queue.popleft()
        if goal <= here:
            return depth
        for o in operators:
            after = o.apply(here)
            if o.needs <= here and after not in seen:
                seen.add(after)
                queue.append((after, depth + 1))
    raise AssertionError("no plan")


@settings(max_examples=40)
@given(st.permutations("abcd"), st.permutations("abcd"), st.integers(1, 4))
def test_first_skeleton_is_shortest(start: list[str], end: list[str], cut: int) -> None:
    operators = blocks_world("abcd")
    facts = world([s for s in ("".join(start[:cut]), "".join(start[cut:])) if s])
    goal = frozenset(atom("on", b, a) for a, b in pairwise(end))
    first = next(skeletons(facts, goal, operators))
    assert len(first) == shortest(facts, goal, operators)
    for operator in first:
        assert applicable(operator, facts)
        facts = operator.apply(facts)
    assert goal <= facts


@settings(max_examples=300)
@given(st.randoms(use_true_random=False), st.sampled_from([(1.0,), (1.0, 2.0, 3.0), (0.3, 0.7, 1.9)]))
def test_the_first_skeleton_is_the_cheapest_whatever_operators_do_and_cost(random: Random, costs: tuple[float, ...]) -> None:
    atoms = [atom("p", str(i)) for i in range(7)]

    def some(most: int) -> Facts:
        return frozenset(random.sample(atoms, random.randint(0, most)))

    operators = tuple(
        Operator("do", (str(i),), some(3), some(3), some(2), random.choice(costs)) for i in range(random.randint(2, 12))
    )
    facts, goal = some(3), some(4)
    best = cheapest(facts, goal, operators)
    found = [sum(o.cost for o in s) for s in islice(skeletons(facts, goal, operators), 8)]
    assert np.diff(found).min(initial=0.0) > -1e-6
    assert (best is None) == (not found)
    assert best is None or abs(found[0] - best) < 1e-6


def cheapest(facts: Facts, goal: Facts, operators: tuple[Operator, ...]) -> float | None:
    """Dijkstra's answer, with no bound to lead it astray."""
    tie = count()
    queue: list[tuple[float, int, Facts]] = [(0.0, next(tie), facts)]
    seen: set[Facts] = set()
    while queue:
        cost, _, here = heappop(queue)
        if goal <= here:
            return cost
        if here not in seen:
            seen.add(here)
            for o in operators:
                if o.needs <= here:
                    heappush(queue, (cost + o.cost, next(tie), o.apply(here)))
    return None


def test_a_long_skeleton_is_found_in_a_moment() -> None:
    operators, facts = blocks_world("abcde"), world(["abcde"])
    goal = frozenset(atom("on", a, b) for a, b in pairwise("cebda"))
    began = process_time()
    assert len(next(skeletons(facts, goal, operators))) >= 8
    assert process_time() - began < 0.1


def test_costs_never_fall_from_one_skeleton_to_the_next() -> None:
    found = list(islice(skeletons(world(["a", "b", "c"]), frozenset({atom("on", "a", "b")}), blocks_world("abc")), 12))
    lengths = [len(s) for s in found]
    assert lengths == sorted(lengths) and lengths[0] == 2
    assert len({tuple(map(str, s)) for s in found}) == len(found)


def test_an_obstruction_forbids_an_operator_until_it_is_gone() -> None:
    operators = blocks_world("ab")
    take = next(o for o in operators if str(o) == "take(a, t)")
    facts = world(["a", "b"])
    assert applicable(take, facts)
    assert not applicable(take, facts | {obstructs("b", take)})
