"""What stands beside the scene: a plan's skeleton, why there is none, which grasps were refused. Small pieces of HTML."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from html import escape

from optimus.motion.plan import Infeasible, Step
from optimus.show import sentence

Rgb = tuple[int, int, int]

SKILL_COLOURS: dict[str, Rgb] = {
    "pick": (47, 111, 176),
    "place": (217, 130, 43),
    "stack": (217, 130, 43),
    "open": (46, 139, 87),
    "close": (140, 90, 170),
}
OTHER_COLOURS: tuple[Rgb, ...] = ((0, 140, 150), (190, 60, 120), (120, 120, 40))
"""For skills that somebody added, in the order of their names."""


def colour_of(skill: str) -> Rgb:
    """The colour of a skill: of its ghosts, and of its line in words."""
    return SKILL_COLOURS.get(skill) or OTHER_COLOURS[sum(skill.encode()) % len(OTHER_COLOURS)]


def skeleton(steps: Sequence[Step], now: int, segment: str) -> str:
    """The plan as a list, a line a step, each in its skill's colour; the present one stands out with its motion."""
    lines = []
    for number, step in enumerate(steps):
        r, g, b = colour_of(step.operator.skill)
        dot = f'<span style="color:rgb({r},{g},{b})">&#9679;</span>'
        text = escape(sentence(step.operator))
        if number == now:
            text = f"<b>{text}</b> <i>({escape(segment)})</i>"
        lines.append(f'<div class="step" data-skill="{escape(step.operator.skill)}">{dot} {number + 1}. {text}</div>')
    return _box("".join(lines), "skeleton")


def why_not(found: Infeasible) -> str:
    """Why there is no plan: the reason, the skill that could not be done, and what was in its way."""
    rows = [f"<b>No plan: {escape(found.reason)}.</b>"]
    if found.skill:
        rows.append(f"Could not be done: {escape(found.skill)}({escape(', '.join(found.objects))}).")
    if found.blockers:
        rows.append(f"In the way: {escape(', '.join(found.blockers))}.")
    return _box("".join(f"<div>{row}</div>" for row in rows), "why-not")


def grasps(thing: str, accepted: int, refused: Mapping[str, int]) -> str:
    """How many grasps of a thing the arm can take, and why not the others."""
    rows = [f"<b>{escape(thing)}</b>: {accepted} of {accepted + sum(refused.values())} grasps can be taken."]
    rows += [f"{count} refused: {escape(why)}" for why, count in Counter(refused).most_common()]
    return _box("".join(f"<div>{row}</div>" for row in rows), "grasps")


def facts(rows: Mapping[str, str]) -> str:
    """A few facts, one a line."""
    return _box("".join(f"<div>{escape(k)}: <b>{escape(v)}</b></div>" for k, v in rows.items()), "facts")


def _box(inside: str, name: str) -> str:
    return f'<div id="{name}" style="font-size:0.85em;line-height:1.5;padding:0.3em 0.9em">{inside}</div>'
