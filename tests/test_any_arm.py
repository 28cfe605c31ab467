"""Arms that are not a Franka: robot files, URDFs from the wild, numeric inverse kinematics, and success in physics."""

import json
import re
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

from optimus.cli import main
from optimus.collect import CollectConfig, open_dataset
from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import OptimusError, RobotFileError, UnknownNameError
from optimus.kinematics import Kinematics
from optimus.robots import PANDA, Robot
from optimus.robots.catalogue import robot
from optimus.robots.file import read_robot
from optimus.robots.menagerie import fetch
from optimus.robots.urdf import read_urdf
from optimus.se3 import Pose, error_between, quat_from_rotvec, quat_mul
from optimus.tasks import TASKS, task
from optimus.world import compile_scene

GUIDE = Path(__file__).parent.parent / "docs" / "add_a_robot.md"


@pytest.fixture(scope="module")
def ur5e() -> Robot:
    return robot("ur5e")


@pytest.fixture(scope="module")
def kinematics(ur5e: Robot) -> Kinematics:
    return Kinematics(compile_scene(task("stack").problem(0, ur5e).scene))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", ["stack", "pick-place"])
def test_a_six_joint_arm_solves_the_tasks(ur5e: Robot, name: str, seed: int) -> None:
    attempt = demonstrate(ManipulationEnv(task(name), images=False, robot=ur5e), seed, ExpertConfig())
    assert attempt.success, attempt.failure


def example(folder: Path) -> Path:
    """The robot file in the guide, in a file."""
    (text,) = re.findall(r"```toml\n(.*?)```", GUIDE.read_text(encoding="utf-8"), re.DOTALL)
    path = folder / "example.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_guides_example_is_the_known_robot(tmp_path: Path, ur5e: Robot) -> None:
    read = read_robot(example(tmp_path))
    assert read.name == "my-arm"
    assert replace(read, name="ur5e") == ur5e  # with everything written out there and derived here
    attempt = demonstrate(ManipulationEnv(task("stack"), images=False, robot=read), 7, ExpertConfig())
    assert attempt.success, attempt.failure


def test_every_task_takes_another_robot(ur5e: Robot) -> None:
    for name in TASKS:
        problem, other = task(name).problem(3), task(name).problem(3, ur5e)
        assert other.scene == replace(problem.scene, robot=ur5e)
        assert problem.scene.robot == PANDA


def test_datasets_say_whose_they_are_unless_it_is_the_tasks_own(tmp_path: Path, ur5e: Robot) -> None:
    for given, recorded in ((None, None), (PANDA, None), (ur5e, "ur5e")):
        store = open_dataset(CollectConfig("stack", tmp_path / str(given and given.name), 1, robot=given))
        assert store.config.get("robot") == recorded
    with pytest.raises(OptimusError):
        open_dataset(CollectConfig("stack", tmp_path / "ur5e", 1))


# ---- inverse kinematics


@pytest.mark.parametrize("seed", range(10))
def test_numeric_solutions_reach_the_target_in_several_ways(kinematics: Kinematics, seed: int) -> None:
    rng = np.random.default_rng(seed)
    turn = quat_from_rotvec((0.0, 0.0, rng.uniform(-1.5, 1.5)))
    target = Pose(rng.uniform((0.35, -0.35, 0.03), (0.65, 0.35, 0.4)), quat_mul(turn, kinematics.fk(kinematics.home).quat))
    found = list(kinematics.solutions(target, kinematics.home))
    assert len(found) >= 4
    for q in found:
        error = error_between(target, kinematics.fk(q))
        assert np.linalg.norm(error[:3]) < 1e-3 and np.linalg.norm(error[3:]) < 5e-3
        assert kinematics.within_limits(q)
    signs = {bool(q[-2] > 0) for q in found}
    assert signs == {True, False}  # the wrist one way and the other


def test_numeric_search_is_a_function_of_its_history_alone(kinematics: Kinematics) -> None:
    target = kinematics.fk(kinematics.home).shifted((0.05, 0.1, -0.1))
    first, second = (list(Kinematics(kinematics.world).solutions(target, kinematics.home)) for _ in range(2))
    np.testing.assert_array_equal(first, second)


def test_numeric_search_gives_up_out_of_reach(kinematics: Kinematics) -> None:
    assert not list(kinematics.solutions(Pose.of((1.5, 0.0, 0.3), (np.pi, 0.0, 0.0)), kinematics.home))


# ---- what is derived


def panda_file(folder: Path) -> Path:
    """The Panda's MJCF, described as a stranger would."""
    path = folder / "stranger.toml"
    path.write_text(f"""
model = {json.dumps(str(fetch() / "panda.xml"))}
joints = {json.dumps(list(PANDA.joints))}
home = {list(PANDA.home)}
hand = "hand"
tcp = {{ pos = {list(PANDA.tcp)} }}
[gripper]
joints = ["finger_joint1", "finger_joint2"]
bodies = ["left_finger", "right_finger"]
actuator = "actuator8"
pad = {{ pos = [0.0, 0.004, 0.0445], half = [0.0085, 0.004, 0.0095] }}
""")
    return path


def test_an_mjcf_tells_what_we_know_of_the_panda(tmp_path: Path) -> None:
    read = read_robot(panda_file(tmp_path))
    np.testing.assert_allclose(read.camera_pos, PANDA.camera_pos, atol=1e-9)
    np.testing.assert_allclose(read.camera_target, PANDA.camera_target, atol=1e-9)
    same = replace(read, name="panda", source=PANDA.source, ik="panda", untouching=(), speed_limits=PANDA.speed_limits)
    assert replace(same, camera_pos=PANDA.camera_pos, camera_target=PANDA.camera_target) == PANDA
    attempt = demonstrate(ManipulationEnv(task("stack"), images=False, robot=read), 1, ExpertConfig())
    assert attempt.success, attempt.failure  # with the numeric search, in spite of the redundant joint


def test_fingers_open_where_they_are_furthest_apart_and_move_alike(ur5e: Robot) -> None:
    assert ur5e.finger_open == (0.0, 0.0) and ur5e.finger_signs == (1.0, -1.0)
    world = compile_scene(task("stack").problem(0, ur5e).scene)
    env = ManipulationEnv(task("stack"), images=False, robot=ur5e)
    env.reset(seed=0)
    assert env.state().opening == pytest.approx(2 * ur5e.finger_travel, abs=1e-3)
    for _ in range(15):
        env.step(np.array([0, 0, 0, 0, 0, 0, 1], np.float32))
    # pressed against each other by all of the hand's force, they give a little
    np.testing.assert_allclose(world.finger_gaps(env.data), 0.0, atol=2.5e-3)


def test_the_base_can_be_moved(ur5e: Robot) -> None:
    moved = replace(ur5e, base_pos=(0.1, 0.0, 0.05), base_quat=(0.0, 0.0, 0.0, 1.0))
    here, there = (Kinematics(compile_scene(task("stack").problem(0, r).scene)).fk(np.array(r.home)) for r in (ur5e, moved))
    np.testing.assert_allclose(there.pos, (0.1 - here.pos[0], -here.pos[1], 0.05 + here.pos[2]), atol=1e-9)


# ---- URDFs from the wild

URDF = """<?xml version="1.0"?>
<robot name="wild">
  <link name="world"/>
  <joint name="fixed" type="fixed"><parent link="world"/><child link="base"/></joint>
  <link name="base"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/><origin xyz="0 0 0.05"/><axis xyz="0 0 1"/></joint>
  <link name="arm">
    <inertial><mass value="1.0"/></inertial>
    <visual><geometry><mesh filename="package://wild_description/meshes/arm.stl"/></geometry></visual>
    <visual><geometry><mesh filename="package://wild_description/meshes/arm.dae"/></geometry></visual>
    <collision><geometry><mesh filename="../meshes/arm.stl"/></geometry></collision>
  </link>
  <joint name="spare" type="revolute"><parent link="arm"/><child link="hand"/><origin xyz="0.3 0 0"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="7" velocity="1" drake:acceleration="2"/></joint>
  <link name="hand">
    <inertial><mass value="0.1"/></inertial>
    <visual><geometry><mesh filename="package://wild_description/meshes/arm.dae"/></geometry></visual>
    <collision><geometry><box size="0.02 0.1 0.02"/></geometry></collision>
  </link>
  <joint name="left" type="prismatic"><parent link="hand"/><child link="left"/><origin xyz="0.1 0.01 0"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.03" effort="5" velocity="1"/></joint>
  <link name="left"><inertial><mass value="0.1"/></inertial>
    <collision><geometry><box size="0.02 0.01 0.02"/></geometry></collision></link>
  <joint name="right" type="prismatic"><parent link="hand"/><child link="right"/><origin xyz="0.1 -0.01 0"/><axis xyz="0 1 0"/>
    <limit lower="-0.03" upper="0" effort="5" velocity="1"/><mimic joint="left" multiplier="-1"/></joint>
  <link name="right"><inertial><mass value="0.1"/></inertial>
    <collision><geometry><box size="0.02 0.01 0.02"/></geometry></collision></link>
</robot>
"""
WILD = """
model = "wild_description/urdf/wild.urdf"
joints = ["turn", "spare"]
home = [0.0, 0.5]
hand = "hand"
tcp = { pos = [0.1, 0.0, 0.0], rpy = [0.0, 1.5707963, 0.0] }
[gripper]
joints = ["left", "right"]
bodies = ["left", "right"]
"""


@pytest.fixture
def wild(tmp_path: Path) -> Path:
    """A robot file beside a ROS package with a URDF as careless as they come."""
    package = tmp_path / "wild_description"
    for folder in ("urdf", "meshes"):
        (package / folder).mkdir(parents=True)
    (package / "urdf" / "wild.urdf").write_text(URDF)
    trimesh.creation.box((0.3, 0.05, 0.05)).export(package / "meshes" / "arm.stl")
    (package / "meshes" / "arm.dae").write_text("not a mesh")
    (tmp_path / "wild.toml").write_text(WILD)
    return tmp_path / "wild.toml"


def test_a_careless_urdf_is_read(wild: Path) -> None:
    read = read_robot(wild)
    assert read.finger_open == (0.03, -0.03) and read.finger_shut == (0.0, 0.0)
    assert read.torque_limits == (100.0, 7.0)
    assert read.speed_limits == (np.pi, 1.0)
    model = read_urdf(wild.parent / "wild_description" / "urdf" / "wild.urdf").compile()
    assert model.neq == 1 and model.body("arm").mass[0] == pytest.approx(1.0)
    groups = {model.body(int(b)).name: set() for b in model.geom_bodyid}
    for geom in range(model.ngeom):
        groups[model.body(int(model.geom_bodyid[geom])).name].add(int(model.geom_group[geom]))
    assert groups["arm"] == {2, 3} and groups["hand"] == {2}  # pictures where there are some, else the collision shape


def test_joints_that_are_not_named_stay_where_they_are(wild: Path) -> None:
    wild.write_text(WILD.replace('["turn", "spare"]', '["turn"]').replace("[0.0, 0.5]", "[0.0]"))
    world = compile_scene(task("stack").problem(0, read_robot(wild)).scene)
    with pytest.raises(KeyError):
        world.model.joint("robot/spare")
    assert world.model.nu == 3 and isinstance(world.model, mujoco.MjModel)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('["turn", "spare"]', '["turn", "elbow"]', r"no joint 'elbow' .*turn, spare, left, right"),
        ('["left", "right"]\nbodies', '["left", "wrong"]\nbodies', r"no joint 'wrong'"),
        ('bodies = ["left", "right"]', 'bodies = ["left", "thumb"]', r"no body 'thumb' .*hand"),
        ('bodies = ["left", "right"]', 'bodies = ["left"]', r"gripper.bodies should be 2"),
        ('hand = "hand"', 'hand = "flange"', r"no body 'flange'"),
        ("home = [0.0, 0.5]", "home = [0.0]", r"home should be 2 numbers"),
        ("home = [0.0, 0.5]", "home = [0.0, 0.5]\ntorque_limits = [nan, 1.0]", r"torque_limits should be finite"),
        ("home = [0.0, 0.5]", "home = [0.0, 0.5]\nspeed_limits = [-1.0, 1.0]", r"speed_limits should be above 0"),
        ("[gripper]", "camera = { pos = [0, 0, 0], target = [0, 0, 0] }\n[gripper]", r"\[camera\] stands at what it looks at"),
        ("home = [0.0, 0.5]", "home = [0.0, 1.5]", r"home is outside the range of spare"),
        ("home = [0.0, 0.5]", "", r"lacks home"),
        ('hand = "hand"', "", r"lacks hand"),
        ("tcp = {", "tpc = {", r"unknown keys: tpc; valid: .*tcp"),
        ("rpy = [0.0, 1.57", "quat = [0.0, 1.57", r"\[tcp\] has unknown keys: quat; valid: pos, rpy"),
        ("home = [", "home = [[", r"is not a robot file"),
        ("wild.urdf", "tame.urdf", r"no model file .*tame.urdf"),
        ('"wild_description/', '"package:no-such-package/', r"'no-such-package' .*not installed: pip install no-such-package"),
        ('"wild_description/urdf/wild', '"package:airo-models/tame', r"no file tame.urdf .*ur5e.urdf"),
        ("[gripper]", '[gripper]\nmodel = "wild_description/urdf/wild.urdf"', r"needs a mount"),
        ("[gripper]", '[gripper]\nactuator = "motor"', r"no actuator 'motor' .*none"),
        ("[gripper]", "[gripper]\nshut = [0.0, 0.0]\nopen = [0.0, 0.0]", r"do not move"),
        ('joints = ["left", "right"]', 'joints = ["left", "spare"]', r"spare does not slide"),
        ('["turn", "spare"]\nhome = [0.0, 0.5]', '["turn", "left"]\nhome = [0.0, 0.0]', r"left stands in joints and in gripper"),
        ("[gripper]", "[gripper]\nshut = [0.0, 0.0]\nopen = [0.5, -0.5]", r"gripper.open: 0.5 is outside the range of left, 0"),
        ("[gripper]", "[gripper]\nshut = [0.03, -0.03]\nopen = [0.0, 0.0]", r"80 mm apart at gripper.shut and 20 at gripper.open"),
        ("[gripper]", '[gripper]\nmount = { body = "hand" }', r"gripper.model names none"),
        ('hand = "hand"', 'hand = "world"', r"hand: world is not moved by spare, the arm's last joint"),
        ('hand = "hand"', 'hand = "arm"', r"hand: arm is not moved by spare"),
    ],
)
def test_mistakes_in_a_robot_file_are_named(wild: Path, old: str, new: str, said: str) -> None:
    assert old in WILD
    wild.write_text(WILD.replace(old, new))
    with pytest.raises(RobotFileError, match=said) as caught:
        read_robot(wild)
    assert "\n" not in str(caught.value) and str(wild) in str(caught.value)


def test_a_missing_mesh_is_named(wild: Path) -> None:
    (wild.parent / "wild_description" / "meshes" / "arm.dae").unlink()
    with pytest.raises(RobotFileError, match=r"package://wild_description/meshes/arm\.dae"):
        read_robot(wild)


def test_unknown_and_missing_robots_are_named(tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="panda, ur5e"):
        robot("ur6")
    with pytest.raises(RobotFileError, match=r"no robot file .*none\.toml"):
        robot(str(tmp_path / "none.toml"))


def test_the_command_line_takes_a_robot(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "picture.png"
    for arguments in (["show", "stack", "--out", str(out)], ["bench", "expert", "stack", "--episodes", "1"]):
        monkeypatch.setattr("sys.argv", ["optimus", *arguments, "--robot", str(example(tmp_path)), "--json"])
        main()
    assert out.stat().st_size > 10_000
    result = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert result["robot"] == "my-arm" and result["successes"] == 1


def test_a_name_is_of_one_robot(tmp_path: Path) -> None:
    """A dataset knows its robot by the name alone."""
    mine = tmp_path / "mine.toml"
    mine.write_text(example(tmp_path).read_text().replace('"my-arm"', '"ur5e"'))
    assert robot(str(mine)) == robot("ur5e")
    moved = re.sub(r"base = \{[^}]*\}", "base = { pos = [0.0, 0.04, 0.0] }", mine.read_text())
    mine.write_text(moved)
    with pytest.raises(RobotFileError, match=r"mine\.toml: 'ur5e' is another robot"):
        robot(str(mine))
