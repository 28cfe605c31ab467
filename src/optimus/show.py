"""Pictures for people: a scene as the policy's cameras see it, a plan as a strip, a film of an episode."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from textwrap import wrap

import imageio.v3 as iio
import mujoco
import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from optimus.closed_loop import ClosedLoop
from optimus.data.atomic import make_folder, write_whole
from optimus.data.episode import IMAGE_SUFFIX, Episode, Observation
from optimus.demonstrate import ExpertConfig, plan_for
from optimus.env import ManipulationEnv
from optimus.errors import ModelError
from optimus.logic import Operator
from optimus.motion.plan import Infeasible, Plan, Segment, Step
from optimus.objects.shapes import Rgba
from optimus.render import Rig
from optimus.robots import Robot
from optimus.rollout import rollout
from optimus.scene import Camera
from optimus.se3 import Array
from optimus.state import State
from optimus.task import Task
from optimus.validate import validate

Picture = NDArray[np.uint8]

EMPTY_HAND: Rgba = (0.15, 0.45, 0.95, 0.9)
LOADED_HAND: Rgba = (0.95, 0.45, 0.05, 0.9)
FILMS = {".webp": "WEBP", ".gif": "GIF"}
FILM_FRAMES, FRAME_MS, LAST_FRAME_MS = 48, 80, 1200
"""Of a looping film: pictures at most, and for how long each is shown, and the last one."""
SENTENCES = {
    "pick": "pick {0} up from {1}",
    "place": "place {0} on {1}",
    "stack": "stack {0} on {1}",
    "open": "open {0}",
    "close": "close {0}",
}


def sentence(operator: Operator) -> str:
    """What a step of a plan does, in words."""
    return SENTENCES.get(operator.skill, f"{operator.skill} " + " ".join(operator.args)).format(*operator.args)


def _font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size)


def captioned(picture: Picture, caption: str, height: int = 34) -> Picture:
    """The picture with text above it: on one line, or in smaller letters on two."""
    out = Image.new("RGB", (picture.shape[1], picture.shape[0] + height), (255, 255, 255))
    out.paste(Image.fromarray(picture), (0, height))
    draw, room = ImageDraw.Draw(out), picture.shape[1] - 16
    text, font = caption, _font(16)
    if draw.textlength(caption, font) > room:
        text = "\n".join(wrap(caption, len(caption) // 2 + 12))
        fonts = [_font(size) for size in range(14, 6, -1)]
        font = next((f for f in fonts if draw.multiline_textbbox((0, 0), text, f)[2] <= room), fonts[-1])
    draw.multiline_text((8, height // 2), text, fill=(25, 25, 30), font=font, anchor="lm", spacing=2)
    return np.asarray(out)


def grid(pictures: Sequence[Picture], columns: int, gap: int = 6) -> Picture:
    """Pictures of one size in rows."""
    h, w = pictures[0].shape[:2]
    rows = -(-len(pictures) // columns)
    out = np.full((rows * (h + gap) - gap, columns * (w + gap) - gap, 3), 255, np.uint8)
    for i, picture in enumerate(pictures):
        y, x = (i // columns) * (h + gap), (i % columns) * (w + gap)
        out[y : y + h, x : x + w] = picture
    return out


def png(picture: Picture) -> bytes:
    """The picture as a PNG file's bytes."""
    buffer = io.BytesIO()
    Image.fromarray(picture).save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def observation_strip(observation: Observation, size: int) -> Picture:
    """The cameras side by side, as the policy sees them, enlarged without smoothing; of no width where it sees nothing."""
    views = [observation[k] for k in observation if k.endswith(IMAGE_SUFFIX)]
    enlarged = [np.asarray(Image.fromarray(v).resize((size, size), Image.Resampling.NEAREST)) for v in views]
    return grid(enlarged, len(enlarged)) if enlarged else np.empty((size, 0, 3), np.uint8)


def show_scene(task: Task, seed: int, out: Path, robot: Robot | None = None) -> str:
    """Write a picture of the start of `seed`; returns what it shows, in words."""
    env = ManipulationEnv(task, robot=robot)
    observation, info = env.reset(seed=seed)
    names = [k.removesuffix(IMAGE_SUFFIX) for k in observation if k.endswith(IMAGE_SUFFIX)]
    views = [observation[n + IMAGE_SUFFIX] for n in names]
    pictures = [captioned(env.render(), f"{task.name}, seed {seed} {info['variant']}".strip())]
    for name, view in zip(names, views, strict=True):
        big = np.asarray(Image.fromarray(view).resize((480, 480), Image.Resampling.NEAREST))
        pictures.append(captioned(big, f"{name} (84 x 84, as the policy sees it)"))
    write_whole(out, png(grid(pictures, len(pictures))))
    return f"{task.summary}; goal: {', '.join(sorted(map(str, env.problem.goal)))}"


def show_plan(task: Task, seed: int, out: Path, config: ExpertConfig | None = None, robot: Robot | None = None) -> Plan:
    """Write a plan of `seed` as a strip: the start, then each skill with the path of its motion; returns the plan.

    With `config.check`, `ModelError` says what is wrong with an invalid plan, and nothing is drawn.
    """
    config = config or ExpertConfig()
    env = ManipulationEnv(task, images=False, robot=robot)
    env.reset(seed=seed)
    goal = env.problem.goal
    plan = plan_for(env, seed, config).plan
    if isinstance(plan, Infeasible):
        raise ModelError(f"no plan for {task.name} with seed {seed}: {plan}")
    wrong = validate(plan, env.world.scene, goal, config.law) if config.check else []
    if wrong:
        raise ModelError(f"the plan for {task.name} with seed {seed} is invalid: {'; '.join(map(str, wrong))}")
    rig = Rig(env.world, 440, 640)
    camera = task.people_camera
    wanted = ", ".join(sorted(str(a) for a in goal))
    pictures, state = [], plan.start
    for number, step in enumerate(plan.steps, 1):
        pictures += _step_pictures(rig, env, state, step, number, camera)
        state = replace(step.after, opening=0.05) if step.after.held is not None else step.after
    pictures.append(captioned(_view(rig, env, state, camera), f"goal: {wanted}"))
    write_whole(out, png(grid(pictures, 3)))
    return plan


def show_film(task: Task, seed: int, out: Path, robot: Robot | None = None, size: int = 256) -> Episode:
    """Write a short looping film of the expert solving `seed`; see `Loop`. `ModelError` if there is no plan or it fails."""
    loop = Loop(out, size)
    env, config = ManipulationEnv(task, images=False, robot=robot), ExpertConfig()
    observation, _ = env.reset(seed=seed)
    planned = plan_for(env, seed, config)
    if isinstance(planned.plan, Infeasible):
        raise ModelError(f"no plan for {task.name} with seed {seed}: {planned.plan}")
    expert = ClosedLoop(env, planned.workspace, planned.plan, config.law, planned.rng, config.budget)
    episode = rollout(env, observation, expert, "expert", watch=loop)
    if not episode.success:
        raise ModelError(f"the expert fails at {task.name} with seed {seed}: {episode.failure}")
    loop.write()
    return episode


class Loop:
    """Watches a rollout for a short looping film (WebP or GIF, by the name's end): however long it takes, at most `FILM_FRAMES`
    pictures of the people's view. Pass it as `watch`. `ModelError` for another ending."""

    def __init__(self, out: Path, size: int) -> None:
        if out.suffix not in FILMS:
            raise ModelError(f"cannot write a looping film as {out.name}; its name has to end with {' or '.join(FILMS)}")
        self.out, self.size = out, size
        self._frames: list[Image.Image] = []

    def __call__(self, env: ManipulationEnv) -> None:
        self._frames.append(Image.fromarray(env.picture(self.size)))

    def write(self) -> None:
        """Write what was seen so far."""
        count = len(self._frames)
        chosen = [self._frames[round(i)] for i in np.linspace(0, count - 1, min(count, FILM_FRAMES))]
        shown = [FRAME_MS] * (len(chosen) - 1) + [LAST_FRAME_MS]
        buffer = io.BytesIO()
        kind = FILMS[self.out.suffix]
        chosen[0].save(buffer, kind, save_all=True, append_images=chosen[1:], duration=shown, loop=0, quality=45)
        write_whole(self.out, buffer.getvalue())


def _view(
    rig: Rig, env: ManipulationEnv, state: State, camera: Camera, paths: tuple[tuple[Array, Rgba], ...] = ()
) -> Picture:
    data = mujoco.MjData(env.world.model)
    env.world.write(data, state)
    return rig.view(data, camera, paths).copy()


def _step_pictures(
    rig: Rig, env: ManipulationEnv, before: State, step: Step, number: int, camera: Camera
) -> list[Picture]:
    """Before a skill, and at each action of the gripper in it: every time with the way that the tcp takes next."""
    works = [i for i, segment in enumerate(step.segments) if segment.gripper_action]
    text = f"{number}. {sentence(step.operator)}"
    first = _ways(step.segments[: works[0]] if works else step.segments)
    pictures = [captioned(_view(rig, env, before, camera, first), f"{text}: the way there")]
    state = before
    for this, following in pairwise([*works, len(step.segments)]):
        state = _at_work(state, step, this)
        onward = _ways(step.segments[this + 1 : following])
        pictures.append(captioned(_view(rig, env, state, camera, onward), f"{text}: {step.segments[this].name}"))
    return pictures


def _ways(segments: tuple[Segment, ...]) -> tuple[tuple[Array, Rgba], ...]:
    return tuple((np.array([p.pos for p in s.poses]), LOADED_HAND if s.shut else EMPTY_HAND) for s in segments)


def _at_work(before: State, step: Step, number: int) -> State:
    """The state in which the gripper acts in that segment of `step`."""
    action = step.segments[number]
    doors = dict(before.doors)
    for segment in step.segments[:number]:
        doors |= {name: float(angles[-1]) for name, angles in segment.doors.items()}
    # what is put down lies where it will; what is taken, where it was
    poses = step.after.poses if before.held is not None else before.poses
    opening = 0.05 if action.shut else before.opening
    return replace(before, q=action.q[-1], tcp=action.end, opening=opening, poses=poses, doors=doors, held=None)


class Film:
    """Watches a rollout: the people's view beside what the policy sees. Pass it as `watch`."""

    def __init__(self) -> None:
        self.frames: list[Picture] = []

    def __call__(self, env: ManipulationEnv) -> None:
        side = observation_strip(env.observe(), 240)
        self.frames.append(np.concatenate([env.picture(240), side], axis=1))

    def write(self, path: Path, fps: int = 20) -> None:
        """An MP4 (H.264) of all frames."""
        make_folder(path.parent)
        aside = path.with_name(f".tmp-{path.name}")
        frames = np.stack([f[: f.shape[0] // 2 * 2, : f.shape[1] // 2 * 2] for f in self.frames])
        iio.imwrite(aside, frames, fps=fps, codec="libx264", macro_block_size=2, output_params=["-crf", "30"])
        aside.replace(path)

    def strip(self, count: int = 8) -> Picture:
        """Some frames side by side: the people's view above the policy's."""
        chosen = [self.frames[round(i)] for i in np.linspace(0, len(self.frames) - 1, count)]
        size = chosen[0].shape[0]
        tiles = [np.concatenate(np.split(f[:, : size * (f.shape[1] // size)], f.shape[1] // size, axis=1)) for f in chosen]
        return grid(tiles, len(tiles), gap=3)
