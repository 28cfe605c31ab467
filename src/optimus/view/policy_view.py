"""A policy at work, live: what it sees, where it goes, and the means of its mixture as a fan of lines."""

from __future__ import annotations

import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import torch

from optimus.control import CONTROL_HZ, POSITION_SCALE
from optimus.data.episode import Observation
from optimus.evaluate import RANDOM_SEEDS_FROM, environment
from optimus.learn.agent import trained_agent
from optimus.learn.heads import Mixture, MixtureHead
from optimus.se3 import Array
from optimus.view import words
from optimus.view.pictures import blank, side_by_side
from optimus.view.stage import Rgb, Stage

if TYPE_CHECKING:
    import viser

    from optimus.robots import Robot

FAN_STEPS = 10
"""The lines of the fan are this many actions long."""
LIKELY, UNLIKELY = np.array([214, 48, 49]), np.array([225, 215, 215])


class PolicyView:
    """A policy that plays one problem after another, in real time as far as the machine can."""

    def __init__(self, server: viser.ViserServer, run: Path, seed: int = 0, robot: Robot | None = None) -> None:
        self._server, self._agent = server, trained_agent(run)
        inputs = self._agent.policy.inputs
        self._env = environment(run, inputs, robot)
        self._task = self._env.task
        self._fans = Fans(self._agent.policy.modules()) if inputs.control != "joint" else None
        gui = server.gui
        self._seed = gui.add_number("seed", seed, min=0, step=1, hint="which fresh problem")
        self._again = gui.add_button("start again")
        self._facts = gui.add_html("")
        self._picture = None if inputs.told else gui.add_image(blank(inputs.cameras), label=" | ".join(inputs.cameras))
        self._wanted, self._closed = threading.Event(), threading.Event()
        self._seed.on_update(lambda _: self._wanted.set())
        self._again.on_click(lambda _: self._wanted.set())
        self.steps, self.outcome = 0, "at work"
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """End the thread that plays, and wait for it: the process must not end in the middle of a picture."""
        self._closed.set()
        self._wanted.set()
        self._thread.join()

    def _run(self) -> None:
        torch.set_num_threads(1)
        while not self._closed.is_set():
            self._wanted.clear()
            self._play(RANDOM_SEEDS_FROM + int(self._seed.value))
            if not self._closed.is_set():
                self._wanted.wait()

    def _play(self, seed: int) -> None:
        """One episode; ends early if another is wanted."""
        observation, _ = self._env.reset(seed=seed)
        self._agent.reset(seed)
        self.stage = Stage(self._server, self._env.world, self._task)
        self.steps, self.outcome, over = 0, "at work", False
        while not (over or self._wanted.is_set() or self._closed.is_set()):
            began = time.perf_counter()
            action = self._agent.act(observation)
            self._show(observation)
            observation, _, success, truncated, _ = self._env.step(action)
            self.steps += 1
            over = success or truncated
            if over:
                self.outcome = "success" if success else "out of time"
            time.sleep(max(0.0, 1 / CONTROL_HZ - (time.perf_counter() - began)))
        self._show(observation)

    def _show(self, observation: Observation) -> None:
        self.stage.show(self._env.data.qpos)
        with self._server.atomic():
            if self._picture is not None:
                self._picture.image = side_by_side(observation, self._agent.policy.inputs.cameras)
            if self._fans is not None and self._fans.latest is not None:
                means, weights = self._means(self._fans.latest)
                start = np.broadcast_to(self._env.state().tcp.pos, means.shape)
                colours = [_blend(w / weights.max()) for w in weights]
                self.stage.lines("fan", np.stack([start, start + FAN_STEPS * means], 1), colours, 0.004)
            seconds = self.steps / CONTROL_HZ
            self._facts.content = words.facts({"task": self._task.name, "time": f"{seconds:.1f} s", "so far": self.outcome})

    def _means(self, mixture: Mixture) -> tuple[Array, Array]:
        """The means' displacements `(K, 3)` [m an action] and their weights `(K,)`, for the newest frame."""
        means = self._agent.policy.denormalise(mixture.mean.reshape(-1, *mixture.mean.shape[-2:])[-1])
        weights = torch.softmax(mixture.logits.reshape(-1, mixture.logits.shape[-1])[-1], -1)
        return means[:, :3].numpy().astype(float) * POSITION_SCALE, weights.numpy().astype(float)


class Fans:
    """Keeps the newest mixture that a head among `modules` gave; none if there is no such head."""

    def __init__(self, modules: Any) -> None:
        self.latest: Mixture | None = None
        for module in modules:
            if isinstance(module, MixtureHead):
                module.register_forward_hook(self._keep)

    def _keep(self, module: torch.nn.Module, given: Any, mixture: Mixture) -> None:
        self.latest = mixture


def _blend(share: float) -> Rgb:
    """The colour of a mean, by its weight's share of the greatest."""
    r, g, b = (UNLIKELY + share * (LIKELY - UNLIKELY)).astype(int)
    return (int(r), int(g), int(b))


