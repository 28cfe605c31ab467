"""`render`: images for demonstrations whose states are known."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from optimus.cli.options import Dataset, Json, RobotName, Workers, chosen_robot
from optimus.cli.output import bar, say
from optimus.errors import OptimusError

if TYPE_CHECKING:
    from optimus.scene import Camera


def render(
    dataset: Dataset,
    out: Path,
    cameras: tuple[str, ...] = (),
    size: int = 84,
    depth: bool = False,
    segmentation: bool = False,
    randomise: int | None = None,
    workers: Workers = 0,
    robot: RobotName = None,
    json: Json = False,
) -> None:
    """Render a dataset's episodes (again) from their stored states, into a dataset of its own; a second call goes on where the
    first was stopped. With the same cameras and size the images are exactly those that collection renders.

    Try:
        optimus render data/states --out data/stack
        optimus render data/stack --out data/large --size 256 --depth --segmentation
        optimus render data/stack --out data/varied --randomise 7
        optimus render data/stack --out data/side --cameras robot0_eye_in_hand side=1.2,0.6,0.5:0.5,0,0.05:45

    Args:
        out: the new dataset's folder
        cameras: names of the scene's cameras, or new views NAME=X,Y,Z:X,Y,Z[:FOVY]: where it stands and what it looks at [m], and
            its vertical field of view [deg]; by default the scene's own
        size: side of the images [pixels]; a policy sees as large a share of each as of 84, and takes longer
        depth: also the distance along each camera's axis [m]
        segmentation: also what each pixel shows, as numbers whose names the episode lists
        randomise: a seed: light, colours, textures and cameras' poses differ from episode to episode
    """
    from optimus.rerender import RenderConfig, rerender

    if not 8 <= size <= 2048:
        raise OptimusError(f"--size {size}: images are 8 to 2048 pixels wide")
    named, views = tuple(c for c in cameras if "=" not in c), tuple(_view(c) for c in cameras if "=" in c)
    config = RenderConfig(named, views, size, depth, segmentation, randomise)
    with bar(None, f"render {dataset.name}", "demo") as shown:

        def progress(done: int, total: int) -> None:
            shown.total, shown.n = total, done
            shown.refresh()

        made = rerender(dataset, out, config, workers, chosen_robot(robot), progress)
    result = {"dataset": str(out), "episodes": len(made.seeds), "cameras": list(made.cameras), "size": size}
    say(result, json, f"{len(made.seeds)} episodes in {out}, seen by {', '.join(made.cameras)} at {size} x {size}")


def _view(text: str) -> Camera:
    """A camera from `NAME=X,Y,Z:X,Y,Z[:FOVY]`."""
    from optimus.scene import Camera

    name, _, rest = text.partition("=")
    parts = rest.split(":")
    try:
        pos, target = ((float(x), float(y), float(z)) for x, y, z in (part.split(",") for part in parts[:2]))
        fovy = [float(part) for part in parts[2:]] or [45.0]
    except ValueError:
        pos, target, fovy = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), []
    if not name.isidentifier() or len(fovy) != 1 or not 1.0 <= fovy[0] <= 170.0:
        wanted = "a new view is NAME=X,Y,Z:X,Y,Z[:FOVY], e.g. side=1.2,0.6,0.5:0.5,0,0"
        raise OptimusError(f"--cameras {text}: {wanted}")
    return Camera(name, pos, target, fovy[0])
