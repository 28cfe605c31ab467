"""The same seed gives the same plan, bit for bit: in another process, after other plans, whatever order sets come in."""

import json
import os
import subprocess
import sys

SCRIPT = """
import hashlib, json, sys
from optimus.demonstrate import ExpertConfig, plan_for
from optimus.env import ManipulationEnv
from optimus.tasks import task

digests = {}
for name, seed in json.loads(sys.argv[1]):
    env = ManipulationEnv(task(name), images=False)
    env.reset(seed=seed)
    plan = plan_for(env, seed, ExpertConfig()).plan
    parts = [repr(plan.skeleton).encode(), plan.start.q.tobytes()]
    for step in plan.steps:
        parts.append(str(step.operator).encode())
        for s in step.segments:
            parts += [repr((s.name, s.shut, s.gripper_action, s.speed, s.steady)).encode(), s.q.tobytes()]
            parts += [array.tobytes() for pose in s.poses for array in (pose.pos, pose.quat)]
            parts += [name.encode() + angles.tobytes() for name, angles in sorted(s.doors.items())]
    digests[f"{name} {seed}"] = hashlib.sha256(b"|".join(parts)).hexdigest()
print(json.dumps(digests))
"""

PROBLEMS = [("stack-three", 5), ("pick-place-two", 6), ("stack-adapt", 7), ("microwave-adapt", 7002)]
"""In the last one something stands before the door, and the sampling planner is called."""


def test_the_same_seed_gives_the_same_plan_in_another_process() -> None:
    runs = []
    for hash_seed, problems in (("1", PROBLEMS), ("2", PROBLEMS[::-1])):
        command = [sys.executable, "-c", SCRIPT, json.dumps(problems)]
        environment = {**os.environ, "PYTHONHASHSEED": hash_seed}
        runs.append(subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True))
    first, second = (json.loads(run.communicate()[0]) for run in runs)
    assert len(first) == len(PROBLEMS) and len(set(first.values())) == len(PROBLEMS)
    assert first == second
