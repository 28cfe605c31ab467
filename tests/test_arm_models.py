"""Models of arms as people have them: what they say beside what is needed, what they leave out, what they get wrong."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from optimus.demonstrate import ExpertConfig, demonstrate
from optimus.env import ManipulationEnv
from optimus.errors import RobotFileError
from optimus.kinematics import Kinematics
from optimus.robots import PANDA
from optimus.robots.file import read_robot
from optimus.robots.menagerie import fetch
from optimus.robots.model import robot_spec
from optimus.se3 import error_between
from optimus.tasks import task
from optimus.world import compile_scene
from test_any_arm import panda_file, wild

__all__ = ["wild"]


def altered_panda(folder: Path, *changes: tuple[str, str]) -> Path:
    """The stranger's file, of a model in which something is otherwise."""
    model = shutil.copytree(fetch(), folder / "panda") / "panda.xml"
    text = model.read_text()
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    model.write_text(text)
    file = panda_file(folder)
    file.write_text(file.read_text().replace(str(fetch() / "panda.xml"), str(model)))
    return file


def test_neither_a_models_own_compensation_nor_its_springs_move_the_arm(tmp_path: Path) -> None:
    changes = [('<body name="', '<body gravcomp="1" name="'), ('name="joint2"', 'name="joint2" stiffness="40" springref="1"')]
    env = ManipulationEnv(task("stack"), images=False, robot=read_robot(altered_panda(tmp_path, *changes)))
    env.reset(seed=0)
    before = env.state().tcp
    for _ in range(30):
        env.step(np.array([0, 0, 0, 0, 0, 0, -1], np.float32))
    np.testing.assert_allclose(env.state().tcp.pos, before.pos, atol=5e-4)


def test_names_that_the_model_uses_itself_and_tendons_on_joints_that_go_are_no_trouble(tmp_path: Path) -> None:
    sites = '<site name="tcp" pos="0 0 0.1034"/><camera name="eye_in_hand"/>'
    spare = '<fixed name="spare"><joint joint="joint7" coef="1"/></fixed>'
    driven = '<general name="along" tendon="spare"/>'
    added = {'<inertial mass="0.73"': sites, '<fixed name="split">': spare}
    changes = [(old, new + old) for old, new in added.items()]
    file = altered_panda(tmp_path, *changes, ("<actuator>", f"<actuator>{driven}"))
    file.write_text(file.read_text().replace(', "joint7"', "").replace(str(list(PANDA.home)), str(list(PANDA.home[:-1]))))
    world = compile_scene(task("stack").problem(0, read_robot(file)).scene)
    assert world.model.ntendon == 1 and world.model.nu == 7  # six joints and the gripper


def test_the_closed_form_knows_where_the_arm_stands() -> None:
    moved = replace(PANDA, base_pos=(-0.1, 0.05, 0.1), base_quat=(np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)))
    k = Kinematics(compile_scene(task("stack").problem(0, moved).scene))
    target = k.fk(k.home)
    starts = k.ways(target, k.home)
    assert len(starts) >= 4
    for q in starts:
        assert np.abs(error_between(target, k.fk(q))).max() < 1e-3


@pytest.mark.parametrize("shape", ['<box size="0.02 0.01 0.02"/>', '<cylinder radius="0.01" length="0.02"/>'])
def test_a_pad_touches_in_place_of_primitive_shapes_which_are_seen_and_weigh_as_before(wild: Path, shape: str) -> None:
    urdf = next(wild.parent.rglob("wild.urdf"))
    urdf.write_text(urdf.read_text().replace('<box size="0.02 0.01 0.02"/>', shape))
    without = robot_spec(read_robot(wild)).compile()
    wild.write_text(wild.read_text() + "pad = { pos = [0.0, 0.0, 0.005], half = [0.004, 0.004, 0.004] }\n")
    model = robot_spec(read_robot(wild)).compile()
    for name in ("left", "right"):
        body = model.body(name)
        of = [g for g in range(model.ngeom) if model.geom_bodyid[g] == body.id]
        touching = [g for g in of if model.geom_contype[g] or model.geom_conaffinity[g]]
        np.testing.assert_allclose([model.geom_size[g] for g in touching], [[0.004] * 3])
        assert any(model.geom_group[g] < 3 for g in of)  # renderers draw these
        np.testing.assert_allclose(body.mass, without.body(name).mass)


def test_fingers_that_weigh_by_their_shapes_alone_keep_their_mass_under_a_pad(tmp_path: Path) -> None:
    file = altered_panda(tmp_path)
    model = file.parent / "panda" / "panda.xml"
    text, count = re.subn(r'(<body name="(left|right)_finger"[^>]*>)\s*<inertial[^>]*/>', r"\1", model.read_text())
    assert count == 2
    model.write_text(text)
    assert robot_spec(read_robot(file)).compile().body("left_finger").mass > 0.0


def test_a_root_that_floats_is_welded_and_what_does_not_compile_is_named(wild: Path) -> None:
    urdf = next(wild.parent.rglob("wild.urdf"))
    text = urdf.read_text()
    urdf.write_text(text.replace('name="fixed" type="fixed"', 'name="fixed" type="floating"'))
    assert compile_scene(task("stack").problem(0, read_robot(wild)).scene).model.nu == 4  # two joints, two fingers
    urdf.write_text(text.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 0 0"/>'))
    with pytest.raises(RobotFileError, match="axis"):
        read_robot(wild)


def test_a_geared_motor_is_as_strong_as_its_gear_makes_it(tmp_path: Path) -> None:
    file = altered_panda(tmp_path)
    model = file.parent / "panda" / "panda.xml"
    text = model.read_text()
    for i, motor in ((1, 'forcerange="-2 2" gear="40"'), (2, 'ctrlrange="-3 3" gear="30"')):
        text, count = re.subn(rf'<general [^>]*name="actuator{i}"[^>]*/>', f'<motor joint="joint{i}" {motor}/>', text)
        assert count == 1
    model.write_text(text)
    assert read_robot(file).torque_limits[:3] == (80.0, 90.0, PANDA.torque_limits[2])


def test_other_options_of_a_model_are_the_worlds_without_a_word(
    tmp_path: Path, recwarn: pytest.WarningsRecorder, capfd: pytest.CaptureFixture[str]
) -> None:
    file = altered_panda(tmp_path, ("<option ", '<option timestep="0.001" gravity="0 0 0" '))
    world = compile_scene(task("stack").problem(0, read_robot(file)).scene)
    usual = compile_scene(task("stack").problem(0).scene).model.opt
    assert world.model.opt.timestep == usual.timestep and np.array_equal(world.model.opt.gravity, usual.gravity)
    assert not recwarn.list and "onflict" not in "".join(capfd.readouterr())


def test_an_edited_file_that_a_model_includes_is_noticed(tmp_path: Path) -> None:
    file = altered_panda(tmp_path)
    folder = file.parent / "panda"
    (folder / "arm.xml").write_text('<mujoco><include file="panda.xml"/></mujoco>')
    file.write_text(file.read_text().replace("panda.xml", "arm.xml"))
    before = task("stack").fingerprint(0, read_robot(file))
    assert task("stack").fingerprint(0, read_robot(file)) == before
    text = (folder / "panda.xml").read_text()
    (folder / "panda.xml").write_text(text.replace("<body name=", "<!-- another --><body name=", 1))
    assert task("stack").fingerprint(0, read_robot(file)) != before


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ('<mass value="1.0"/>', '<mass value="${m}"/>', r"value of the mass of link .* is '\$\{m\}', no number; is this a xacro"),
        ('effort="7" velocity="1"', 'effort="7" velocity="${v}"', r"velocity of joint spare is '\$\{v\}'"),
    ],
)
def test_a_urdf_with_a_number_that_is_none_is_named(wild: Path, old: str, new: str, said: str) -> None:
    model = next(wild.parent.rglob("wild.urdf"))
    assert old in model.read_text()
    model.write_text(model.read_text().replace(old, new))
    with pytest.raises(RobotFileError, match=said):
        read_robot(wild)


def test_a_joint_of_an_mjcf_that_turns_without_end_turns_far_enough(tmp_path: Path) -> None:
    file = altered_panda(tmp_path, ('name="joint7"', 'name="joint7" limited="false"'))
    arm = Kinematics(compile_scene(task("stack").problem(0, read_robot(file)).scene))
    np.testing.assert_allclose((arm.low[-1], arm.high[-1]), (-2 * np.pi, 2 * np.pi), atol=0.05)
    assert np.all(arm.low < arm.high)


def test_the_models_own_gears_and_limits_do_not_weaken_the_arm(tmp_path: Path) -> None:
    """A motor's force is the joint's torque, and as much of it as the robot file says; what reads an actuator goes with it."""
    own = shutil.copytree(fetch(), tmp_path / "own")
    text = (own / "panda.xml").read_text()
    for i in range(1, 8):
        text = re.sub(rf'(<joint [^>]*name="joint{i}")', r'\1 actuatorfrcrange="-1 1"', text, count=1)
        text = re.sub(rf'(<general [^>]*name="actuator{i}")', r'\1 gear="100"', text, count=1)
    text = text.replace("</mujoco>", '<sensor><actuatorfrc actuator="actuator8"/></sensor></mujoco>')
    assert text.count('gear="100"') == 7 and text.count("actuatorfrcrange") == 7
    (own / "panda.xml").write_text(text)
    written = panda_file(tmp_path).read_text().replace(str(fetch()), str(own)).replace('actuator = "actuator8"\n', "")
    (tmp_path / "strong.toml").write_text(written.replace("[gripper]", f"torque_limits = {[*PANDA.torque_limits]}\n[gripper]"))
    strong = read_robot(tmp_path / "strong.toml")
    attempt = demonstrate(ManipulationEnv(task("stack"), images=False, robot=strong), 3, ExpertConfig())
    assert attempt.success, attempt.failure
