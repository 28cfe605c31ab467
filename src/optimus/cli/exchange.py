"""`export` and `import`: data sets to and from the formats of other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from tyro.conf import Positional, arg

from optimus.cli.options import Dataset, Json, RobotName, chosen_robot
from optimus.cli.output import bar, counted, say, table
from optimus.errors import OptimusError

Target = Annotated[Literal["robomimic", "lerobot"], Positional, arg(metavar="{robomimic,lerobot}", help="the format")]
Source = Annotated[Literal["robomimic"], Positional, arg(metavar="{robomimic}", help="the format")]


def export(
    to: Target,
    dataset: Dataset,
    out: Path,
    all: bool = False,
    overwrite: bool = False,
    images: bool = False,
    crf: int | None = None,
    compress: bool = False,
    next_obs: bool = True,
    states: bool = True,
    robot: RobotName = None,
    json: Json = False,
) -> None:
    """Write a data set in another program's format: robomimic's HDF5 file, or LeRobot's folder (LeRobotDataset v3.0).

    The episodes that curation kept, split as it split them; without curation all of them. The file or folder is there whole or not
    at all.

    Try:
        optimus export robomimic data/stack --out stack.hdf5
        optimus export lerobot data/stack --out lerobot/stack
        optimus export lerobot data/stack --out lerobot/stack --images

    Args:
        out: the HDF5 file, or the folder of LeRobot's data set
        all: also the episodes that curation dropped
        overwrite: replace what is there already
        images: with lerobot: images as PNG within the tables, exact, in place of videos
        crf: with lerobot: how much the videos lose, 0 (almost nothing) to 51; by default 12
        compress: with robomimic: images by gzip, smaller and slower to read
        next_obs: with robomimic: with next_obs, which doubles the file and which behaviour cloning does not read
        states: with robomimic: with the physics states; where they were not recorded every episode is carried out again
    """
    only = {"lerobot": {"--images": images, "--crf": crf is not None}}
    only["robomimic"] = {"--compress": compress, "--no-next-obs": not next_obs, "--no-states": not states}
    for target, options in only.items():
        if target != to and (wrong := [name for name, given in options.items() if given]):
            raise OptimusError(f"{wrong[0]} goes with `export {target}` alone")
    if crf is not None and not 0 <= crf <= 51:
        raise OptimusError(f"--crf is 0 to 51, not {crf}")
    arm = chosen_robot(robot)
    with bar(None, f"export {to}", "episode") as shown:
        progress = counted(shown)
        if to == "robomimic":
            from optimus.exchange.robomimic import RobomimicConfig, export_robomimic

            result = export_robomimic(dataset, out, RobomimicConfig(all, states, next_obs, compress, overwrite, arm), progress)
        else:
            try:
                from optimus.exchange.lerobot import LerobotConfig, export_lerobot
            except ImportError as error:
                raise OptimusError(f"{error}; LeRobot's format needs `pip install optimus-tamp[exchange]`") from error
            quality = LerobotConfig.crf if crf is None else crf
            result = export_lerobot(dataset, out, LerobotConfig(all, images, quality, overwrite, arm), progress)
    say(result, json, table(result))


def import_(
    source: Source,
    file: Annotated[Path, Positional, arg(help="the HDF5 file")],
    out: Path,
    observations: tuple[str, ...] = (),
    instruction: str = "",
    overwrite: bool = False,
    json: Json = False,
) -> None:
    """Make a data set of another program's demonstrations, to be curated, looked at and learned from like any other.

    Try:
        optimus import robomimic lift.hdf5 --out data/lift
        optimus import robomimic lift.hdf5 --out data/lift --instruction "lift the cube" --observations robot0_joint_pos
        optimus train data/lift --out runs/lift

    Args:
        out: the folder of the new data set
        observations: names of the low-dimensional observations to take; by default what the arm knows of itself
        instruction: what was wanted, for demonstrations that do not say it
        overwrite: replace the data set that is there already
    """
    from optimus.exchange.robomimic_import import RobomimicSource, import_robomimic

    with bar(None, f"import {source}", "demo") as shown:
        result = import_robomimic(file, out, RobomimicSource(observations, instruction, overwrite), counted(shown))
    say(result, json, table(result))
