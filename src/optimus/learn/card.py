"""The model card of a run: `README.md` in its folder, what the policy is and how good, for whoever finds it there.

It is made from what the run's other files say, and made anew whenever those change.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from optimus.data.atomic import read_record, write_whole
from optimus.errors import DatasetError
from optimus.learn import checkpoint, metrics

CARD_FILE = "README.md"
EVALUATION = "evaluation-*.json"


def write_card(run: Path) -> None:
    """Write the card of the run in this folder."""
    config = checkpoint.read_config(run)
    sections = [_heading(config), _use(run, config), _network(config), _training(run, config), _success(run), _LICENCE]
    write_whole(run / CARD_FILE, "\n".join(sections).encode())


def _heading(config: dict[str, Any]) -> str:
    inputs = config["inputs"]
    looks = f"the cameras {', '.join(inputs['cameras'])}" if inputs["cameras"] else "how the objects lie (it has no camera)"
    return f"""---
library_name: optimus
tags: [robotics, imitation-learning]
---

# A policy for {inputs["task"]}

A visuomotor policy, trained by behaviour cloning on demonstrations of a task and motion planner in simulation (MuJoCo).

- Control: {inputs.get("control")}; robot: {inputs.get("robot")}; {inputs.get("actions", 7)} numbers an action, the gripper's last.
- It sees {looks} and {", ".join(inputs["proprioception"])}.
"""


def _use(run: Path, config: dict[str, Any]) -> str:
    return f"""## Use

```python
import optimus

policy = optimus.load_policy("{run.name}")  # the path of this folder
policy.reset()
action = policy.act(observation)  # at every step, 20 a second
```

`config.json` says what it is, `model.safetensors` has weights and normalisation. Neither can execute anything.
"""


def _network(config: dict[str, Any]) -> str:
    policy = config["policy"]
    kinds = ", ".join(f"{part}: {policy[part].get('kind', 'the first kind')}" for part in ("encoder", "trunk", "head"))
    count = config.get("parameters")
    return f"""## Network

{f"{count:,} parameters; " if count else ""}context of {policy["context"]} frames; {kinds}. All sizes are in `config.json`.
"""


def _training(run: Path, config: dict[str, Any]) -> str:
    data, lines = config.get("dataset", {}), metrics.read(run)
    newest = lines[-1] if lines else {}
    found = next((line for line in reversed(lines) if "held_out_action_error" in line), {})
    rows = [f"- Demonstrations: {data.get('episodes', 'unknown')}, collected with `{json.dumps(data.get('config', {}))}`"]
    if newest:
        rows.append(f"- Steps: {newest['step']:.0f} of {newest['steps']:.0f}, {newest['seconds'] / 60:.1f} minutes")
    if found:
        error = f"{found['held_out_action_error']:.4g}"
        rows.append(f"- Held-out action error: {error} (units of an action) at step {found['step']:.0f}")
    return "## Training\n\n" + "\n".join(rows) + "\n"


def _success(run: Path) -> str:
    rows = []
    for file in sorted(run.glob(EVALUATION)):
        try:
            report = read_record(file, ("task", "interval", "successes", "episodes"))
            low, high = map(float, report["interval"])
        except (DatasetError, TypeError, ValueError):  # damaged or another's: not worth losing a training for
            continue
        states = file.stem.removeprefix("evaluation-") + _different(report)
        rows.append(
            f"| {report['task']} | {states} | {report['successes']} of {report['episodes']} | "
            f"{100 * low:.0f} to {100 * high:.0f} % |"
        )
    if not rows:
        return "## Success\n\nNot evaluated yet: `optimus evaluate`.\n"
    head = "| task | initial states and conditions | successes | 95 % interval (Wilson) |\n|---|---|---|---|"
    return "## Success\n\n" + "\n".join([head, *rows]) + "\n"


def _different(report: dict[str, Any]) -> str:
    """How many initial states there are, where some were played more than once: the interval counts them all."""
    distinct = report.get("distinct_states", report["episodes"])
    return f" ({distinct} different)" if distinct != report["episodes"] else ""


_LICENCE = """## Licence

The program that made this policy is under the Apache License 2.0. Demonstrations and weights are its output and belong to whoever
made them; models of robots and objects that were used have licences of their own.
"""
