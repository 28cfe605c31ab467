"""The expert's time per action: planning shared out over the actions, and what its controller takes at each."""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.closed_loop import ClosedLoop
from optimus.data.episode import Observation
from optimus.demonstrate import ExpertConfig, plan_for
from optimus.env import ManipulationEnv
from optimus.motion.plan import Infeasible
from optimus.rollout import Agent, rollout
from optimus.tasks import task as task_named


class Timed:
    """An agent whose CPU time is taken."""

    def __init__(self, agent: Agent) -> None:
        self.agent = agent
        self.seconds = 0.0
        self.actions = 0

    def act(self, observation: Observation) -> NDArray[np.float32] | None:
        """The agent's action; one that it does not have (it is done) is not counted."""
        began = time.process_time()
        answer = self.agent.act(observation)
        if answer is not None:
            self.seconds += time.process_time() - began
            self.actions += 1
        return answer


def expert_time(task: str, episodes: int, seed: int) -> dict[str, dict[str, Any]]:
    """CPU seconds per action over as many problems, one core: all together, the controller's alone (planning again, where that
    was needed, included), and what is paid before the first action."""
    env, config = ManipulationEnv(task_named(task), images=False), ExpertConfig()
    planning, acting, actions = [], 0.0, 0
    for i in range(seed, seed + episodes):
        observation, _ = env.reset(seed=i)
        planned = plan_for(env, i, config)
        planning.append(planned.seconds)
        if isinstance(planned.plan, Infeasible):
            continue
        timed = Timed(ClosedLoop(env, planned.workspace, planned.plan, config.law, planned.rng, config.budget))
        rollout(env, observation, timed, "expert")
        acting, actions = acting + timed.seconds, actions + timed.actions
    each, shared = max(1, actions), {"episodes": episodes, "actions": actions}
    return {
        "": {"seconds": (sum(planning) + acting) / each, **shared},
        "controller alone": {"seconds": acting / each, **shared},
        "before the first action": {"seconds": float(np.mean(planning)), **shared},
    }
