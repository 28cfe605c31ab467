"""Facts about the world, operators that change them, and the search for skeletons. Knows no robot and no geometry."""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import count, product
from typing import Any


@dataclass(frozen=True, order=True)
class Atom:
    """A ground fact: a predicate's name and the names of the things it speaks of."""

    predicate: str
    args: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.predicate}({', '.join(self.args)})"


Facts = frozenset[Atom]


@dataclass(frozen=True)
class Predicate:
    """A relation and its own geometric test: `holds(scene, state, *names)`; `kinds` are those of its arguments."""

    name: str
    kinds: tuple[str, ...]
    holds: Callable[..., bool]

    def __call__(self, *args: str) -> Atom:
        if len(args) != len(self.kinds):
            raise TypeError(f"{self.name} takes {len(self.kinds)} arguments, not {len(args)}")
        return Atom(self.name, args)


@dataclass(frozen=True)
class Operator:
    """A ground action: a skill's name, its objects, what it needs to hold, and what it makes true and false."""

    skill: str
    args: tuple[str, ...]
    needs: Facts
    adds: Facts
    deletes: Facts
    cost: float = 1.0

    def __str__(self) -> str:
        return f"{self.skill}({', '.join(self.args)})"

    def apply(self, facts: Facts) -> Facts:
        return (facts - self.deletes) | self.adds


Skeleton = tuple[Operator, ...]

OBSTRUCTS = "Obstructs"


def obstructs(blocker: str, operator: Operator) -> Atom:
    """The learned fact that `blocker`, where it is now, is in the way of `operator`."""
    return Atom(OBSTRUCTS, (blocker, operator.skill, *operator.args))


def applicable(operator: Operator, facts: Facts) -> bool:
    """Whether its needs hold and nothing known stands in its way."""
    key = (operator.skill, *operator.args)
    return operator.needs <= facts and not any(f.predicate == OBSTRUCTS and f.args[1:] == key for f in facts)


def ground(kinds: Mapping[str, Iterable[str]], parameters: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Every tuple of distinct names that fits the parameter kinds."""
    for names in product(*(tuple(kinds[kind]) for kind in parameters)):
        if len(set(names)) == len(names):
            yield names


def skeletons(
    facts: Facts, goal: Facts, operators: tuple[Operator, ...], revisits: int = 3, limit: int = 20_000
) -> Iterator[Skeleton]:
    """Action skeletons from `facts` to `goal`, cheapest first (A* on the number of missing goal atoms, halved so that an
    operator which adds two of them is not overrated). A set of facts is expanded at most `revisits` times."""
    tie = count()

    def missing(f: Facts) -> float:
        return 0.5 * len(goal - f)

    queue: list[tuple[float, int, float, Facts, Skeleton]] = [(missing(facts), next(tie), 0.0, facts, ())]
    expanded: dict[Facts, int] = {}
    while queue and limit > 0:
        limit -= 1
        _, _, cost, here, done = heapq.heappop(queue)
        if goal <= here:
            yield done
            continue
        if expanded.get(here, 0) >= revisits:
            continue
        expanded[here] = expanded.get(here, 0) + 1
        for operator in operators:
            if applicable(operator, here):
                after = operator.apply(here)
                if after != here:
                    total = cost + operator.cost
                    heapq.heappush(queue, (total + missing(after), next(tie), total, after, (*done, operator)))


def evaluate(
    predicates: Iterable[Predicate], kinds: Mapping[str, Iterable[str]], scene: Any, state: Any
) -> Facts:
    """Every atom of `predicates` that holds in `state`."""
    return frozenset(
        predicate(*names)
        for predicate in predicates
        for names in ground(kinds, predicate.kinds)
        if predicate.holds(scene, state, *names)
    )
