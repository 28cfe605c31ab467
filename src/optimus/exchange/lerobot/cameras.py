"""The videos of one camera in a LeRobotDataset: many episodes a file, and how well they came out."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from optimus.data.atomic import make_folder
from optimus.errors import DatasetError
from optimus.exchange import video
from optimus.exchange.lerobot.tables import place

VIDEO_BYTES = 200 * 2**20
"""A video that is as large as this [bytes] is followed by another: LeRobot's own limit."""
VIDEO_PATH = "videos/{video_key}/chunk-{chunk_index:03d}/file-{file_index:03d}.mp4"


class CameraFiles:
    """One camera's frames, episode after episode, in as many files as they need."""

    def __init__(self, root: Path, key: str, fps: int, crf: int) -> None:
        self.root, self.key, self.fps, self.crf = root, key, fps, crf
        self.number = 0
        self._writer: video.VideoWriter | None = None

    def path(self, number: int) -> Path:
        """The file of that number."""
        return self.root / VIDEO_PATH.format(video_key=self.key, **place(number))

    def add(self, images: NDArray[np.uint8]) -> dict[str, Any]:
        """Append an episode `(T, height, width, 3)`; where it lies: chunk, file, and from when to when [s]."""
        if self._writer is not None and self._writer.size >= VIDEO_BYTES:
            self.close()
            self.number += 1
        if self._writer is None:
            make_folder(self.path(self.number).parent)
            self._writer = video.VideoWriter(self.path(self.number), self.fps, images.shape[1], images.shape[2], self.crf)
        first = self._writer.frames
        for image in images:
            self._writer.add(image)
        times = {"from_timestamp": first / self.fps, "to_timestamp": self._writer.frames / self.fps}
        return {f"videos/{self.key}/{name}": value for name, value in {**place(self.number), **times}.items()}

    def close(self) -> None:
        """End the file that is being written."""
        writer, self._writer = self._writer, None
        if writer is not None:
            writer.close()

    def compare(self, originals: Iterable[NDArray[np.uint8]]) -> dict[str, float]:
        """Decode all files and compare every frame with its original: PSNR [dB] over all pixels, and of the worst frame."""
        decoded = (frame for number in range(self.number + 1) for frame in video.frames_of(self.path(number)))
        errors = []
        for original in originals:
            frame = next(decoded, None)
            if frame is None:
                raise DatasetError(f"{self.key}: the video ends after {len(errors)} frames; nothing was written")
            errors.append(float(np.mean((frame.astype(np.float32) - original) ** 2)))
        if next(decoded, None) is not None:
            raise DatasetError(f"{self.key}: the video has more than its {len(errors)} frames; nothing was written")
        return {"psnr_db": round(video.psnr(float(np.mean(errors))), 2), "worst_frame_db": round(video.psnr(max(errors)), 2)}
