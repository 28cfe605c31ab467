"""The symbolic part of a problem as PDDL, for any planner of that language: propositional, one action a ground operator."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass

from optimus.logic import OBSTRUCTS, Atom, Facts, Operator, atoms_of

_FOREIGN = re.compile(r"[^a-z0-9]+")


@dataclass(frozen=True, eq=False)
class Pddl:
    """A domain and a problem, as text, and what their actions stand for."""

    domain: str
    problem: str
    actions: dict[str, Operator]
    """By the name that each has in the text."""

    def plan(self, text: str) -> tuple[Operator, ...]:
        """The operators of a plan file: one `(action)` a line, comments after a semicolon."""
        lines = (line.split(";")[0].strip(" ()\t") for line in text.lower().splitlines())
        return tuple(self.actions[line] for line in lines if line)


def to_pddl(facts: Facts, goal: Facts, operators: tuple[Operator, ...], name: str = "optimus") -> Pddl:
    """The problem of getting from `facts` to `goal` at the least total cost (costs are whole numbers in PDDL: they are rounded).

    What was learned to be in the way of an operator becomes a condition that it must not hold.
    """
    atoms = atoms_of(facts, goal, operators)
    symbols = dict(zip(atoms, _identifiers(map(str, atoms)), strict=True))
    actions = dict(zip(_identifiers(map(str, operators)), operators, strict=True))
    domain = [f"(define (domain {name})", "  (:requirements :strips :negative-preconditions :action-costs)"]
    domain += ["  (:predicates", *(f"    ({s})" for s in symbols.values()), "  )", "  (:functions (total-cost) - number)"]
    domain += [_action(identifier, operator, symbols) for identifier, operator in actions.items()]
    problem = [f"(define (problem {name}-problem)", f"  (:domain {name})", "  (:init (= (total-cost) 0)"]
    problem += [*(f"    ({symbols[a]})" for a in sorted(facts)), "  )"]
    problem += [f"  (:goal {_all(goal, symbols)})", "  (:metric minimize (total-cost)))"]
    return Pddl("\n".join([*domain, ")", ""]), "\n".join([*problem, ""]), actions)


def _action(identifier: str, operator: Operator, symbols: dict[Atom, str]) -> str:
    key = (operator.skill, *operator.args)
    hindering = [a for a in symbols if a.predicate == OBSTRUCTS and a.args[1:] == key]
    # PDDL, like `Operator.apply`, adds after it deletes: what is both stays true
    effects = [f"(not ({symbols[a]}))" for a in sorted(operator.deletes - operator.adds)]
    effects += [f"({symbols[a]})" for a in sorted(operator.adds)]
    effects.append(f"(increase (total-cost) {round(operator.cost)})")
    return "\n".join(
        [
            f"  (:action {identifier} :parameters ()",
            f"    :precondition {_all(operator.needs, symbols, hindering)}",
            f"    :effect (and {' '.join(effects)}))",
        ]
    )


def _all(atoms: Facts, symbols: dict[Atom, str], never: Iterable[Atom] = ()) -> str:
    parts = [f"({symbols[a]})" for a in sorted(atoms)] + [f"(not ({symbols[a]}))" for a in never]
    return f"(and {' '.join(parts)})"


def _identifiers(names: Iterable[str]) -> list[str]:
    """One identifier a name. PDDL knows neither case nor brackets, so different names may look alike: those get a number."""
    taken: set[str] = set()
    found = []
    for name in names:
        # a predicate or a skill comes first, which begins with a letter, as PDDL asks for
        plain = _FOREIGN.sub("-", name.lower()).strip("-")
        identifier, number = plain, 1
        while identifier in taken:
            number += 1
            identifier = f"{plain}--{number}"
        taken.add(identifier)
        found.append(identifier)
    return found
