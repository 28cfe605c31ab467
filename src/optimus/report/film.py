"""An episode as a film for people, from its recorded images."""

from pathlib import Path

import imageio.v3 as iio
import numpy as np

from optimus.data.atomic import written_aside
from optimus.data.episode import Episode
from optimus.errors import DatasetError

HEIGHT = 336
"""Of the film [pixels], about; images are enlarged by a whole number, without smoothing."""


def write_episode_film(episode: Episode, path: Path, fps: int = 20, overwrite: bool = False) -> int:
    """An MP4 (H.264, as browsers play it) of all cameras side by side, one frame a step; how many frames."""
    if not episode.cameras:
        raise DatasetError(f"episode {episode.seed} has no images to play")
    views = [episode.observations[f"{camera}_image"] for camera in episode.cameras]
    height = min(view.shape[1] for view in views)
    times = 2 * max(1, round(HEIGHT / height / 2))  # even, as the colours of this kind of film need it
    frames = np.concatenate([v[:, :height].repeat(times, 1).repeat(times, 2) for v in views], axis=2)
    with written_aside(path, overwrite) as made:
        options = {"fps": fps, "codec": "libx264", "macro_block_size": 2, "output_params": ["-crf", "20", "-f", "mp4"]}
        iio.imwrite(made, frames, extension=".mp4", plugin="FFMPEG", **options)
    return len(frames)
