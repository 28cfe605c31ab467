"""The skeleton search, against breadth-first search and on puzzles whose answer is known."""

from collections import deque
from itertools import islice, pairwise

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


@settings(deadline=None, max_examples=40)
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
