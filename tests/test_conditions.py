"""Pushed, slipped, slippery and heavy: against mechanics, and against episodes in which nothing happens."""

from collections import Counter

import numpy as np
import pytest

from optimus.conditions import PUSH_SPEED, SLIP_STEPS, USUAL, Conditions, Mishap
from optimus.data.episode import MISHAP
from optimus.demonstrate import MISHAPS, Attempt, ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import OptimusError, UnknownNameError
from optimus.tasks import task

GRAVITY = 9.81


def played(seed: int, conditions: Conditions) -> tuple[Attempt, Mishap, np.ndarray, np.ndarray]:
    """The expert at `stack`: its attempt, the mishap, and positions and velocities of the blocks `(steps, blocks, 3)` before every
    step."""
    env = ManipulationEnv(conditions.of(task("stack")), images=False, worlds=conditions.world)
    mishap = conditions.mishap(seed)
    attempt = demonstrate(env, seed, ExpertConfig(), mishap=mishap)
    assert attempt.episode is not None and attempt.episode.states is not None
    qpos, qvel = np.split(attempt.episode.states[:, 1 : 1 + env.world.model.nq + env.world.model.nv], [env.world.model.nq], axis=1)
    places = np.stack([qpos[:, at : at + 3] for at in env.world.movable_qpos.values()], axis=1)
    return attempt, mishap, places, np.stack([qvel[:, at : at + 3] for at in env.world.movable_dof.values()], axis=1)


def test_under_usual_conditions_nothing_happens() -> None:
    plain = demonstrate(ManipulationEnv(task("stack"), images=False), 3, ExpertConfig())
    watched, mishap, _, _ = played(3, USUAL)
    assert mishap.at is None and plain.episode is not None and watched.episode is not None
    np.testing.assert_array_equal(plain.episode.states, watched.episode.states)


def test_a_push_gives_one_free_thing_its_impulse_once() -> None:
    _, mishap, places, speeds = played(3, Conditions("push"))
    assert mishap.at is not None
    gained = speeds[mishap.at] - speeds[mishap.at - 1]
    struck = np.linalg.norm(gained, axis=1) > 0.1
    assert struck.sum() == 1
    np.testing.assert_allclose(np.linalg.norm(gained[struck]), PUSH_SPEED, rtol=0.02)
    np.testing.assert_allclose(gained[struck][0, 2], 0.0, atol=0.01)
    moved = np.linalg.norm(places[mishap.at + 10] - places[mishap.at], axis=1)
    assert moved[struck] > 0.005 and moved[~struck] < 0.002


def test_what_slips_falls_freely_and_the_expert_takes_it_again() -> None:
    attempt, mishap, places, _ = played(3, Conditions("slip"))
    assert mishap.at is not None
    before, after = places[mishap.at][:, 2], places[mishap.at + SLIP_STEPS][:, 2]
    fallen = float((before - after).max())
    assert 0.01 < fallen <= 0.5 * GRAVITY * (SLIP_STEPS / 20) ** 2 + 0.002
    assert attempt.retries


def test_a_share_of_the_demonstrations_has_mishaps() -> None:
    half = ExpertConfig(mishaps=0.5)
    kinds = Counter(half.mishap(seed) for seed in range(400))
    assert kinds.keys() == {None, "push", "slip", "miss"} and 160 < kinds[None] < 240
    assert max(kinds[kind] for kind in MISHAPS) - min(kinds[kind] for kind in MISHAPS) < 50
    assert {ExpertConfig().mishap(seed) for seed in range(20)} == {None}


def test_a_demonstration_says_what_happened_in_it() -> None:
    always = ExpertConfig(mishaps=1.0)
    seed = next(seed for seed in range(20) if always.mishap(seed) == "slip")
    attempt = demonstrate(ManipulationEnv(task("stack"), images=False), seed, always)
    expected, mishap, _, _ = played(seed, Conditions("slip"))
    assert attempt.episode is not None and expected.episode is not None
    np.testing.assert_array_equal(attempt.episode.states, expected.episode.states)
    assert attempt.info[MISHAP] == {"kind": "slip", "at": mishap.at}


@pytest.mark.parametrize(("name", "control"), [("stack", "osc"), ("pick-place", "joint")])
def test_a_grasp_that_misses_shuts_beside_the_thing_and_the_expert_takes_it(name: str, control: str) -> None:
    always = ExpertConfig(mishaps=1.0)
    for seed in [seed for seed in range(30) if always.mishap(seed) == "miss"][:3]:
        env = ManipulationEnv(task(name), images=False, control=control)
        attempt = demonstrate(env, seed, always)
        episode, at = attempt.episode, attempt.info[MISHAP]["at"]
        assert episode is not None and attempt.success, attempt.failure
        hand, fingers = episode.observations["robot0_eef_pos"], np.abs(episode.observations["robot0_gripper_qpos"]).sum(1)
        told = episode.executed[:, -1] > 0
        shut = next(step for step in range(at, len(told)) if told[step] and not told[step + 1]) + 1
        thing = episode.objects[0, 0]
        np.testing.assert_allclose(episode.objects[shut, 0], thing, atol=0.01)  # nobody touched it
        assert fingers[shut] < 0.035  # shut further than on anything that there is to take
        aside = float(np.linalg.norm(hand[shut, :2] - thing[:2]))
        assert 0.03 < aside < 0.08 and hand[shut, 2] < thing[2] + 0.06
        # the answer from where it was led, and after: to open the hand, and up before anything else
        assert (episode.actions[at : shut + 3, -1] == -1.0).all()
        assert hand[shut + 6, 2] > hand[shut, 2] + 0.01


def test_the_same_seed_has_the_same_mishap() -> None:
    assert played(5, Conditions("push"))[1].at == played(5, Conditions("push"))[1].at


def slid(conditions: Conditions, speed: float) -> float:
    """How far the large block of `stack` slides on the table [m]."""
    env = ManipulationEnv(task("stack"), images=False, worlds=conditions.world)
    env.reset(seed=0)
    began, at = env.object_positions()[1], env.world.movable_dof["cubeB"]
    env.data.qvel[at + 1] = speed
    for _ in range(20):
        env.step(np.array([0, 0, 0, 0, 0, 0, -1], np.float32))
    return float(np.linalg.norm(env.object_positions()[1] - began))


def test_friction_stops_a_sliding_block_as_coulomb_says() -> None:
    for friction in (1.0, 0.5):
        expected = 0.5**2 / (2 * friction * GRAVITY)
        assert slid(Conditions(friction=friction), 0.5) == pytest.approx(expected, rel=0.25)


def test_mass_is_scaled_and_nothing_else() -> None:
    usual, heavy = (ManipulationEnv(task("stack"), images=False, worlds=c.world).world for c in (USUAL, Conditions(mass=3.0)))
    ratio = heavy.model.body_mass / np.maximum(usual.model.body_mass, 1e-12)
    movable = [usual.body_ids[n] for n in usual.scene.movable_names]
    np.testing.assert_allclose(ratio[movable], 3.0)
    rest = np.setdiff1d(np.flatnonzero(usual.model.body_mass), movable)
    np.testing.assert_allclose(ratio[rest], 1.0)
    np.testing.assert_allclose(heavy.model.body_subtreemass[movable], 3.0 * usual.model.body_subtreemass[movable])


def test_what_makes_no_sense_is_refused() -> None:
    with pytest.raises(UnknownNameError, match=r"push, slip"):
        Conditions("shove")  # type: ignore[arg-type]
    for wrong in (lambda: Conditions(friction=0.0), lambda: Conditions(mass=float("nan")), lambda: Conditions(horizon=0)):
        with pytest.raises(OptimusError):
            wrong()
    with pytest.raises(OptimusError, match="share of 0 to 1"):
        ExpertConfig(mishaps=30)
