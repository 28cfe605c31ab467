"""Goals that contradict themselves are refused before anything is planned."""

from __future__ import annotations

from collections.abc import Collection
from itertools import combinations
from typing import Any

from optimus.errors import ModelError
from optimus.logic import Facts, Predicate
from optimus.predicates import Clear, HandEmpty, Holding, On, Open, Released, Shut


def require_consistent(goal: Facts, movable: Collection[str] = ()) -> None:
    """`ModelError` that names two facts of a goal which cannot hold at the same time, if there are such; a `movable` thing carries
    one other."""
    kinds = (On, Holding, Released, Open, Shut)
    named: dict[Predicate, list[Any]] = {kind: [a.args for a in sorted(goal) if a.predicate == kind.name] for kind in kinds}
    for (a, at), (b, other) in combinations(named[On], 2):
        if a == b:
            raise ModelError(f"the goal has {a} on {at} and on {other} at once")
        if at == other and at in movable:
            raise ModelError(f"the goal has {a} and {b} on {at}, which carries one thing: what can be moved does")
    for a, at in named[On]:
        if at in movable and Clear(at) in goal:
            raise ModelError(f"the goal has {a} on {at}, and nothing on it")
    _require_ground(dict(named[On]))
    for (door,) in named[Open]:
        if (door,) in named[Shut]:
            raise ModelError(f"the goal has {door} open and shut at once")
    held, down = [name for (name,) in named[Holding]], {args[0] for args in (*named[On], *named[Released])}
    for name in held:
        if name in down or HandEmpty() in goal:
            raise ModelError(f"the goal has {name} held and let go of at once")
    if len(held) > 1:
        raise ModelError(f"the goal has {' and '.join(held)} held: a hand holds one thing")


def _require_ground(below: dict[str, str]) -> None:
    for name in below:
        chain = [name]
        while (under := below.get(chain[-1])) is not None:
            if under in chain:
                raise ModelError(f"the goal stacks in a circle: {' on '.join([*chain, under])}")
            chain.append(under)
