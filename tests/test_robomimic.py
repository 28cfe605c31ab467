"""robomimic's HDF5, read by the rules of its documentation with h5py alone; and files that try to be more than data."""

from __future__ import annotations

import json
import tempfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import gymnasium
import h5py
import mujoco
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

from optimus.collect import CollectConfig, collect
from optimus.control import CONTROL_HZ
from optimus.data.curate import CurationConfig, curate, load_curation
from optimus.data.store import EpisodeStore
from optimus.demonstrate import ExpertConfig
from optimus.env import ManipulationEnv
from optimus.errors import DatasetError, StorageError
from optimus.exchange.robomimic import RobomimicConfig, export_robomimic
from optimus.exchange.robomimic_import import RobomimicSource, import_robomimic
from optimus.expert import TimeLaw
from optimus.rerender import RenderConfig, rerender
from optimus.robots import PANDA
from optimus.robots.catalogue import robot
from optimus.scene import Camera
from optimus.tasks import task as task_named
from synthetic import CAMERAS, make_dataset, make_episode
from test_robomimic_import import robosuite_like

NO_STATES = RobomimicConfig(states=False)


def test_the_file_is_as_the_format_says(tmp_path: Path) -> None:
    store = make_dataset(tmp_path / "data", 10)
    curation = load_curation(store.path)
    said = export_robomimic(store.path, tmp_path / "d.hdf5")
    with h5py.File(tmp_path / "d.hdf5", "r", swmr=True, libver="latest") as opened:  # as robomimic's loader opens it
        file: Any = opened
        data = file["data"]
        assert json.loads(data.attrs["env_args"]).keys() >= {"env_name", "type", "env_kwargs"}
        assert data.attrs["total"] == sum(demo.attrs["num_samples"] for demo in data.values()) == said["steps"]
        assert sorted(data) == sorted(f"demo_{i}" for i in range(len(curation.kept)))
        masks = {key: {n.decode() for n in file[f"mask/{key}"][()]} for key in ("train", "valid")}
        assert masks["train"] | masks["valid"] == set(data) and not masks["train"] & masks["valid"]
        for number, seed in enumerate(curation.kept):
            demo, episode = data[f"demo_{number}"], store.read(seed)
            assert (f"demo_{number}" in masks["valid"]) == (seed in curation.validation)
            assert np.array_equal(demo["actions"], episode.actions) and demo.attrs["num_samples"] == len(episode)
            assert demo["dones"][()].tolist() == [0] * (len(episode) - 1) + [1] and demo["rewards"][-1] == 1
            assert demo["obs"].keys() == demo["next_obs"].keys() == {*episode.observations, "object"}
            for name, array in episode.observations.items():
                assert demo[f"obs/{name}"].dtype == array.dtype and np.array_equal(demo[f"obs/{name}"], array)
                assert np.array_equal(demo[f"next_obs/{name}"][:-1], array[1:])
            assert demo["obs/front_image"].dtype == np.uint8 and demo["obs/front_image"].shape[1:] == (84, 84, 3)


@settings(max_examples=12)
@given(st.integers(0, 2**32 - 1), st.sampled_from([0.5, 1.0, 2.0]), st.booleans())
def test_the_paper_s_filter_finds_the_same_in_the_exported_file(seed: int, sd: float, boxed: bool) -> None:
    """The rule of the paper's released filter, on the file alone: lengths beyond the file's mean + k standard deviations, and any
    position of `robot0_eef_pos` outside bounds on x, y and z."""
    rng = np.random.default_rng(seed)
    low, high = np.array([-0.17, -0.17, -1.0]), np.array([0.17, 0.17, 1.0])
    box: dict[str, Any] = {"workspace_min": tuple(low.tolist()), "workspace_max": tuple(high.tolist())} if boxed else {}
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        store = EpisodeStore.create(folder / "data", "square", (), {})
        for number in range(24):
            store.write(make_episode(number, int(rng.integers(8, 30)), cameras=(), skeleton=("a",) if number % 2 else ("b", "c")))
        curation = curate(folder / "data", CurationConfig(max_length_sd=sd, length_over="all", **box))
        export_robomimic(folder / "data", folder / "d.hdf5", RobomimicConfig(everything=True, states=False))
        with h5py.File(folder / "d.hdf5", "r") as file:
            demos: Any = file["data"]
            lengths = [demo.attrs["num_samples"] for demo in demos.values()]
            longest = np.mean(lengths) + sd * np.std(lengths)
            kept = set()
            for demo in demos.values():
                hand = demo["obs/robot0_eef_pos"][()]
                outside = boxed and bool((hand.min(0) < low).any() or (hand.max(0) > high).any())
                if demo.attrs["num_samples"] <= longest and not outside:
                    kept.add(json.loads(demo.attrs["ep_meta"])["seed"])
            mask: Any = file["mask"]
            masked = {n.decode() for key in ("train", "valid") for n in mask[key][()]}
            assert {json.loads(demos[n].attrs["ep_meta"])["seed"] for n in masked} == kept == set(curation.kept)


@pytest.mark.parametrize("cameras", [("front", "wrist"), ("wrist", "front")])
def test_what_was_exported_comes_back(tmp_path: Path, cameras: tuple[str, ...]) -> None:
    store = make_dataset(tmp_path / "data", 6, cameras=cameras)
    export_robomimic(store.path, tmp_path / "d.hdf5", RobomimicConfig(compress=True, next_obs=False))
    import_robomimic(tmp_path / "d.hdf5", tmp_path / "back")
    back = EpisodeStore.open(tmp_path / "back")
    assert (back.task, back.cameras, back.config) == (store.task, store.cameras, store.config)
    assert load_curation(back.path).train == load_curation(store.path).train
    for seed in load_curation(store.path).kept:
        one, other = store.read(seed), back.read(seed)
        assert one.skeleton == other.skeleton and one.object_names == other.object_names
        for name in ("actions", "executed", "objects", "initial_state"):
            assert np.array_equal(getattr(one, name), getattr(other, name))
        assert all(np.array_equal(a, other.observations[n]) for n, a in one.observations.items())


@settings(max_examples=15, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data(), st.integers(1, 6), st.integers(2, 9))
def test_any_numbers_survive_the_way_there_and_back(
    tmp_path_factory: pytest.TempPathFactory, data: st.DataObject, steps: int, size: int
) -> None:
    folder = tmp_path_factory.mktemp("any")
    finite = st.floats(-1e6, 1e6, width=32)
    actions = data.draw(arrays.arrays(np.float32, (steps, size), elements=finite))
    position = data.draw(arrays.arrays(np.float32, (steps, 3), elements=finite))
    store = EpisodeStore.create(folder / "data", "square", CAMERAS, {})
    episode = make_episode(3, steps, actions=actions, executed=actions)
    episode.observations["robot0_eef_pos"] = position
    store.write(episode)
    export_robomimic(folder / "data", folder / "d.hdf5", NO_STATES)
    import_robomimic(folder / "d.hdf5", folder / "back")
    back = EpisodeStore.open(folder / "back").read(3)
    assert np.array_equal(back.actions, actions) and np.array_equal(back.observations["robot0_eef_pos"], position)


def test_states_are_those_of_the_physics(taught: tuple[Path, Path], tmp_path: Path) -> None:
    """MuJoCo, put into an exported state, has the hand and the things where the episode saw them."""
    said = export_robomimic(taught[0], tmp_path / "d.hdf5", RobomimicConfig(everything=True))
    assert said["states"]
    store = EpisodeStore.open(taught[0])
    env = ManipulationEnv(task_named("stack"), images=False)
    with h5py.File(tmp_path / "d.hdf5", "r") as file:
        demo: Any = file["data/demo_1"]
        episode = store.read(json.loads(demo.attrs["ep_meta"])["seed"])
        env.reset(seed=episode.seed)
        model, states = env.world.model, demo["states"][()]
        assert "<mujoco" in demo.attrs["model_file"] and json.loads(demo.attrs["ep_meta"])["lang"].startswith("put the red block")
        for step in (0, len(episode) // 2, len(episode) - 1):
            time, env.data.qpos[:], env.data.qvel[:] = np.split(states[step], (1, 1 + model.nq))  # robosuite's order
            mujoco.mj_forward(model, env.data)
            assert time == pytest.approx(states[0, 0] + step / CONTROL_HZ)
            assert np.allclose(env.object_positions(), episode.objects[step], atol=1e-6)
            assert np.allclose(env.observe()["robot0_eef_pos"], episode.observations["robot0_eef_pos"][step], atol=1e-6)
    import_robomimic(tmp_path / "d.hdf5", tmp_path / "back")
    back = EpisodeStore.open(tmp_path / "back").read(episode.seed)
    assert back.states is not None and episode.states is not None
    assert np.array_equal(back.states, states) and np.array_equal(back.states, episode.states), "they may be rendered again"


def test_what_is_there_is_not_replaced_unasked(tmp_path: Path) -> None:
    store = make_dataset(tmp_path / "data", 4)
    target = tmp_path / "d.hdf5"
    target.write_text("mine")
    with pytest.raises(StorageError, match="--overwrite"):
        export_robomimic(store.path, target, NO_STATES)
    assert target.read_text() == "mine"
    export_robomimic(store.path, target, RobomimicConfig(states=False, overwrite=True))
    with pytest.raises(StorageError, match=r"dataset\.json"):  # a folder that is no data set is never replaced
        import_robomimic(target, tmp_path, RobomimicSource(overwrite=True))
    import_robomimic(target, store.path, RobomimicSource(overwrite=True))
    assert len(EpisodeStore.open(store.path).seeds) == 4 and sorted(p.name for p in tmp_path.iterdir()) == ["d.hdf5", "data"]
    with pytest.raises(DatasetError, match="not an HDF5"):
        import_robomimic(store.path / "dataset.json", tmp_path / "x")
    with pytest.raises(DatasetError, match="not a dataset"):
        export_robomimic(tmp_path, tmp_path / "y.hdf5")


def test_an_export_that_breaks_off_leaves_the_old_file(tmp_path: Path) -> None:
    store = make_dataset(tmp_path / "data", 4)
    export_robomimic(store.path, tmp_path / "d.hdf5", NO_STATES)
    before = (tmp_path / "d.hdf5").read_bytes()

    def stop(done: int, of: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        export_robomimic(store.path, tmp_path / "d.hdf5", RobomimicConfig(states=False, overwrite=True), stop)
    assert (tmp_path / "d.hdf5").read_bytes() == before and len(list(tmp_path.iterdir())) == 2


def test_the_file_says_how_its_environment_is_made(tmp_path: Path) -> None:
    """Whichever task, arm and gripper: Gymnasium makes it from what `env_args` has."""
    law = TimeLaw(gripper="continuous")
    for name, config in (
        ("stack", CollectConfig("stack", tmp_path / "a", 1, workers=1, images=False, robot=robot("ur5e"))),
        ("cans", CollectConfig("pick-place@can-1", tmp_path / "b", 1, workers=1, images=False, expert=ExpertConfig(law=law))),
    ):
        collect(config)
        export_robomimic(config.out, tmp_path / f"{name}.hdf5")
        with h5py.File(tmp_path / f"{name}.hdf5") as file:
            told = json.loads(str(file["data"].attrs["env_args"]))
        env = gymnasium.make(told["env_name"], **told["env_kwargs"], images=False).unwrapped
        assert isinstance(env, ManipulationEnv)
        assert (env.task.name, env.gripper) == (config.task, config.expert.law.gripper)
        assert env.world.scene.robot.name == ("ur5e" if config.robot else "panda")


@pytest.mark.parametrize("controllers", [None, [{"type": "OSC_POSE"}] * 2, {"type": "OSC_POSE", "output_max": []}])
def test_what_a_file_does_not_say_of_its_environment_is_not_needed(controllers: Any, tmp_path: Path) -> None:
    robosuite_like(tmp_path / "lift.hdf5", count=2)
    told = controllers and {"controller_configs": controllers}
    with h5py.File(tmp_path / "lift.hdf5", "a") as file:
        file["data"].attrs["env_args"] = json.dumps({"env_name": "TwoArm", "env_kwargs": told})
    import_robomimic(tmp_path / "lift.hdf5", tmp_path / "lift")
    assert "position_scale" not in EpisodeStore.open(tmp_path / "lift").config


def test_a_task_whose_module_is_not_here_is_still_named_as_it_is_made(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    store = EpisodeStore.create(tmp_path / "data", "elsewhere:TIDY", CAMERAS, {"control": "osc"})
    store.write(replace(make_episode(0, 5), task=store.task))
    said = export_robomimic(store.path, tmp_path / "d.hdf5")
    assert said["models"] is False and "elsewhere" in caplog.text
    with h5py.File(tmp_path / "d.hdf5") as file:
        told = json.loads(str(file["data"].attrs["env_args"]))
    assert told["env_name"] == "optimus/Task-v0" and told["env_kwargs"]["task"] == "elsewhere:TIDY"


def test_with_its_robot_file_an_export_has_models_and_states(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    arm = replace(PANDA, name="my-arm")
    collect(CollectConfig("stack", tmp_path / "data", 1, workers=1, images=False, robot=arm))
    alone = export_robomimic(tmp_path / "data", tmp_path / "alone.hdf5")
    assert (alone["models"], alone["states"]) == (False, True) and "my-arm" in caplog.text
    assert export_robomimic(tmp_path / "data", tmp_path / "with.hdf5", RobomimicConfig(robot=arm))["models"] is True
    with h5py.File(tmp_path / "with.hdf5") as file:
        assert "<mujoco" in str(file["data/demo_0"].attrs["model_file"])
    with pytest.raises(DatasetError, match="collected with robot my-arm"):
        export_robomimic(tmp_path / "data", tmp_path / "other.hdf5", RobomimicConfig(robot=robot("ur5e")))


def test_the_files_environment_shows_what_was_rendered_and_distances_are_pictures(
    taught: tuple[Path, Path], tmp_path: Path
) -> None:
    aside = Camera("aside", (1.2, 0.6, 0.5), (0.5, 0.0, 0.0))
    seen = rerender(taught[0], tmp_path / "depth", RenderConfig(("agentview",), (aside,), size=16, depth=True), workers=1)
    export_robomimic(seen.path, tmp_path / "depth.hdf5")
    with h5py.File(tmp_path / "depth.hdf5") as file:
        told = json.loads(str(file["data"].attrs["env_args"]))
        depth = file["data/demo_0/obs/agentview_depth"]
        assert isinstance(depth, h5py.Dataset) and depth.shape[1:] == (16, 16, 1)
    import_robomimic(tmp_path / "depth.hdf5", tmp_path / "back")
    back = EpisodeStore.open(tmp_path / "back")
    assert back.cameras == seen.cameras and back.config["rendered"]["depth"] is False, "distances are not taken"
    spaces = gymnasium.make(told["env_name"], **told["env_kwargs"]).observation_space
    assert {name: spaces[name].shape for name in spaces if name.endswith("_image")} == {  # type: ignore[index, attr-defined]
        "agentview_image": (16, 16, 3),
        "aside_image": (16, 16, 3),
    }
