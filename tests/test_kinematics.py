"""Forward and inverse kinematics against finite differences and MuJoCo's own forward kinematics."""

import numpy as np
import pytest

from optimus.collision import CollisionChecker
from optimus.kinematics import Kinematics
from optimus.se3 import Pose, error_between, quat_from_rotvec, quat_mul
from optimus.state import State
from optimus.tasks import task
from optimus.world import World, compile_scene


@pytest.fixture(scope="module")
def world() -> World:
    return compile_scene(task("stack").problem(0).scene)


@pytest.fixture(scope="module")
def kinematics(world: World) -> Kinematics:
    return Kinematics(world)


def random_q(kinematics: Kinematics, seed: int) -> np.ndarray:
    return np.random.default_rng(seed).uniform(kinematics.low, kinematics.high)


@pytest.mark.parametrize("seed", range(5))
def test_jacobian_is_the_derivative(kinematics: Kinematics, seed: int) -> None:
    q, h = random_q(kinematics, seed), 1e-6
    base = kinematics.fk(q)
    jacobian = kinematics.jacobian()
    for i in range(7):
        moved = kinematics.fk(q + h * np.eye(7)[i])
        np.testing.assert_allclose(jacobian[:, i], error_between(moved, base) / h, atol=1e-4)


@pytest.mark.parametrize("seed", range(20))
def test_every_solution_reaches_the_target_within_limits(kinematics: Kinematics, seed: int) -> None:
    rng = np.random.default_rng(seed)
    target = Pose(rng.uniform((0.35, -0.3, 0.05), (0.65, 0.3, 0.4)), kinematics.fk(kinematics.home).quat)
    found = list(kinematics.solutions(target, kinematics.home))
    assert len(found) >= 2
    for q in found:
        error = error_between(target, kinematics.fk(q))
        assert np.linalg.norm(error[:3]) < 1e-3 and np.linalg.norm(error[3:]) < 5e-3
        assert kinematics.within_limits(q)


def at_rest(kinematics: Kinematics, q: np.ndarray, target: Pose) -> np.ndarray:
    """Where the null space comes to rest from `q`, by the pseudo-inverse and in small steps."""
    for _ in range(70):
        error, jacobian = error_between(target, kinematics.fk(q)), kinematics.jacobian()
        back = np.linalg.pinv(jacobian)
        q = q + back @ error + 0.2 * (np.eye(7) - back @ jacobian) @ (kinematics.home - q)
    return q


def test_where_the_arm_settles_is_where_its_null_space_comes_to_rest(kinematics: Kinematics) -> None:
    """Each place of rest once, and none missed. Some null spaces are so flat that the arm is still on its way: not one in ten."""
    upright, off, count = kinematics.fk(kinematics.home).quat, [], [0, 0]
    for seed in range(12):
        rng = np.random.default_rng(seed)
        turned = quat_mul(quat_from_rotvec(rng.uniform((-0.5, -1.2, -1.0), (0.5, 0.2, 1.0))), upright)
        target = Pose(rng.uniform((0.35, -0.3, 0.05), (0.65, 0.3, 0.4)), turned)
        solutions = list(kinematics.solutions(target, kinematics.home))[:12]
        settled = list(kinematics.settled(solutions, target))
        count = [count[0] + len(settled), count[1] + len(solutions)]
        for i, q in enumerate(settled):
            assert np.abs(error_between(target, kinematics.fk(q))).max() < 2e-3
            assert all(np.abs(q - other).max() > 0.05 for other in settled[:i])
        ends = [at_rest(kinematics, q, target) for q in solutions]
        off += [min(np.abs(q - other).max() for other in ends) for q in settled]
        easy = [q for q in ends if (q > kinematics.low + 0.2).all() and (q < kinematics.high - 0.2).all()]
        off += [min(np.abs(q - other).max() for other in settled) for q in easy]
    assert len(off) > 30 and np.mean(np.array(off) < 0.15) > 0.9
    assert count[0] < count[1] / 3


def test_out_of_reach_has_no_solution(kinematics: Kinematics) -> None:
    assert not list(kinematics.solutions(Pose.of((1.5, 0.0, 0.3), (np.pi, 0.0, 0.0)), kinematics.home))


def test_home_is_where_the_robot_file_says(kinematics: Kinematics) -> None:
    tcp = kinematics.fk(kinematics.home)
    np.testing.assert_allclose(tcp.pos, (0.5, 0.0, 0.25), atol=1e-3)
    np.testing.assert_allclose(tcp.matrix[:, 2], (0.0, 0.0, -1.0), atol=1e-3)


def test_collisions_name_what_meets(world: World, kinematics: Kinematics) -> None:
    checker = CollisionChecker(world)
    poses = {"cubeA": Pose.of((0.5, 0.0, 0.02)), "cubeB": Pose.of((0.6, 0.1, 0.025))}
    checker.look_at(State(world.home, 0.08, poses, kinematics.fk(world.home)))
    assert checker.check(world.home) is None
    down = kinematics.fk(world.home)
    into_table = kinematics.refine(world.home, Pose(np.array([0.45, -0.1, -0.02]), down.quat), 40)
    into_cube = kinematics.refine(world.home, Pose(np.array([0.6, 0.135, 0.03]), down.quat), 40)
    assert into_table is not None and into_cube is not None
    table, cube = checker.check(into_table), checker.check(into_cube)
    assert table is not None and "table" in (table.a, table.b)
    assert cube is not None and "cubeB" in (cube.a, cube.b)
