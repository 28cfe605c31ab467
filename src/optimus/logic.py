"""Facts about the world, operators that change them, and the search for skeletons. Knows no robot and no geometry."""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
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


def atoms_of(facts: Facts, goal: Facts, operators: tuple[Operator, ...]) -> list[Atom]:
    """Every atom that a problem speaks of; sorted, so that nothing depends on the order of a set."""
    return sorted(facts.union(goal, *(o.needs | o.adds | o.deletes for o in operators)))


@dataclass(eq=False)
class _Coded:
    """A problem in integers: a set of facts is one, with a bit a fact; operators go by their number."""

    atoms: list[Atom]
    start: int
    goal: int
    operators: tuple[Operator, ...]

    @staticmethod
    def of(facts: Facts, goal: Facts, operators: tuple[Operator, ...]) -> _Coded:
        atoms = atoms_of(facts, goal, operators)
        bits = {atom: 1 << i for i, atom in enumerate(atoms)}
        coded = _Coded(atoms, sum(bits[a] for a in facts), sum(bits[a] for a in goal), operators)
        coded._index(bits)
        return coded

    def _index(self, bits: dict[Atom, int]) -> None:
        operators, numbers = self.operators, {atom: i for i, atom in enumerate(self.atoms)}
        hindering: dict[tuple[str, ...], int] = {}
        for atom in self.atoms:
            if atom.predicate == OBSTRUCTS:
                hindering[atom.args[1:]] = hindering.get(atom.args[1:], 0) | bits[atom]
        self._needs = [sum(bits[a] for a in o.needs) for o in operators]
        self._adds = [sum(bits[a] for a in o.adds) for o in operators]
        self._keeps = [~sum(bits[a] for a in o.deletes) for o in operators]
        self._hindered = [hindering.get((o.skill, *o.args), 0) for o in operators]
        self._needed = [[numbers[a] for a in o.needs] for o in operators]
        self._added = [[numbers[a] for a in o.adds] for o in operators]
        self._users: list[list[int]] = [[] for _ in self.atoms]
        self._makers: list[list[int]] = [[] for _ in self.atoms]
        for k in range(len(operators)):
            for i in self._needed[k]:
                self._users[i].append(k)
            for i in self._added[k]:
                self._makers[i].append(k)
        # an operator is looked at only where the fact that it shares with the fewest others holds
        self._free = [k for k, needed in enumerate(self._needed) if not needed]
        self._waiting: dict[int, list[int]] = {}
        for k, needed in enumerate(self._needed):
            if needed:
                rarest = min(needed, key=lambda i: (len(self._users[i]), i))
                self._waiting.setdefault(1 << rarest, []).append(k)
        self._costs = [o.cost for o in operators]
        self._whole = all(float(c).is_integer() for c in self._costs)

    def after(self, here: int) -> Iterator[tuple[int, int]]:
        """`(operator, facts after it)` of all that can be done in `here` and changes it, in the operators' order."""
        candidates = list(self._free)
        rest = here
        while rest:
            lowest = rest & -rest
            rest ^= lowest
            candidates += self._waiting.get(lowest, ())
        for k in sorted(candidates):
            needs = self._needs[k]
            if here & needs == needs and not here & self._hindered[k]:
                there = here & self._keeps[k] | self._adds[k]
                if there != here:
                    yield k, there

    def _on_the_way(self, here: int) -> int:
        """The facts that do not hold in `here` but must at some time before the goal does, -1 if it is out of reach; with
        nothing ever made false (so that an obstruction or a delete can only make the true answer larger).

        A fact's landmarks are itself and what all the operators that make it have in common: a fixed point, found by starting
        from all bits set (-1: not reached yet) and taking away.
        """
        marks = [0 if here >> i & 1 else -1 for i in range(len(self.atoms))]
        queue = [k for k, needs in enumerate(self._needs) if here & needs == needs]
        queued = bytearray(len(self.operators))
        while queue:
            following: list[int] = []
            for k in queue:
                queued[k] = 0
                before = 0
                for i in self._needed[k]:
                    before |= marks[i]
                if before == -1:
                    continue
                for i in self._added[k]:
                    fewer = marks[i] & (before | 1 << i)
                    if fewer != marks[i]:
                        marks[i] = fewer
                        for user in self._users[i]:
                            if not queued[user]:
                                queued[user] = 1
                                following.append(user)
            queue = following
        found, rest = 0, self.goal & ~here
        while rest:
            lowest = rest & -rest
            rest ^= lowest
            found |= marks[lowest.bit_length() - 1]
        return found

    def at_least(self, here: int) -> float:
        """A cost that every way from `here` to the goal exceeds or equals: each fact that must come true costs its cheapest
        maker's share, an operator sharing its cost out among all such facts that it makes."""
        marks = self._on_the_way(here)
        if marks == -1:
            return math.inf
        total, rest = 0.0, marks
        shares: dict[int, float] = {}
        while rest:
            lowest = rest & -rest
            rest ^= lowest
            cheapest = math.inf
            for k in self._makers[lowest.bit_length() - 1]:
                if k not in shares:
                    shares[k] = self._costs[k] / (self._adds[k] & marks).bit_count()
                cheapest = min(cheapest, shares[k])
            total += cheapest
        # rounding must not carry the sum over the truth; whole costs add up to whole costs
        return float(math.ceil(total - 1e-6)) if self._whole else total * (1 - 1e-9)


@dataclass(order=True)
class _Node:
    """A place in the queue: cheapest first, then nearest to the goal, then first come."""

    total: float
    left: float
    number: int
    cost: float = field(compare=False)
    facts: int = field(compare=False)
    done: tuple[int, ...] = field(compare=False)


class _Search:
    """A* that goes on after the first answer. What would lead to it no sooner is parked until then."""

    def __init__(self, coded: _Coded, revisits: int) -> None:
        self.coded, self._revisits = coded, revisits
        self._number, self._found = count(), False
        self._queue: list[_Node] = []
        self._parked: list[_Node] = []
        self._bound: dict[int, float] = {}
        self._expanded: dict[int, int] = {}
        self._cheapest: dict[int, float] = {}
        self._push(coded.start, 0.0, ())

    def pop(self) -> _Node | None:
        """The next node to look into; None when none is left."""
        while self._queue:
            node = heapq.heappop(self._queue)
            # one bound may be looser than the next, so that a cheaper way here can come later: that one is looked into again
            if not self._found and node.cost >= self._cheapest.get(node.facts, math.inf):
                self._parked.append(node)
            elif not self._found or self._expanded.get(node.facts, 0) < self._revisits:
                return node
        return None

    def expand(self, node: _Node) -> None:
        here, coded = node.facts, self.coded
        self._expanded[here] = self._expanded.get(here, 0) + 1
        self._cheapest[here] = min(node.cost, self._cheapest.get(here, math.inf))
        for k, there in coded.after(here):
            self._push(there, node.cost + coded.operators[k].cost, (*node.done, k))

    def _push(self, there: int, cost: float, done: tuple[int, ...]) -> None:
        if there not in self._bound:
            self._bound[there] = self.coded.at_least(there)
        left = self._bound[there]
        if left < math.inf:
            heapq.heappush(self._queue, _Node(cost + left, left, next(self._number), cost, there, done))

    def note_answer(self, node: _Node) -> None:
        """After the first answer: nothing hereafter is cheaper, which tightens the bounds, and the parked nodes count again."""
        if not self._found:
            self._found = True
            for known, cost in self._cheapest.items():
                self._bound[known] = max(self._bound[known], node.cost - cost)
            self._queue += self._parked
            heapq.heapify(self._queue)


def skeletons(
    facts: Facts, goal: Facts, operators: tuple[Operator, ...], revisits: int = 3, limit: int = 20_000
) -> Iterator[Skeleton]:
    """Action skeletons from `facts` to `goal`, cheapest first: A* with a bound from below by the facts that every way must make
    true. Until the first skeleton a set of facts is expanded again only when a cheaper way leads to it; after that, for the
    other skeletons, in all at most `revisits` times. Ends after `limit` expansions."""
    coded = _Coded.of(facts, goal, operators)
    search = _Search(coded, revisits)
    while limit > 0 and (node := search.pop()) is not None:
        if coded.goal & ~node.facts == 0:
            yield tuple(operators[k] for k in node.done)
            search.note_answer(node)
        else:
            limit -= 1
            search.expand(node)


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
