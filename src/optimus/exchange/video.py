"""Camera images as H.264 video and back, by PyAV."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import av
import numpy as np
from av.video.stream import VideoStream
from numpy.typing import NDArray

from optimus.errors import DatasetError

CODEC = "libx264"
KEYFRAMES = 2
"""Every second frame stands alone, as LeRobot has it: a frame drawn at random is decoded from at most one other."""


class VideoWriter:
    """Frames of one size, one after another, into an MP4 file; `close` when done."""

    def __init__(self, path: Path, fps: int, height: int, width: int, crf: int) -> None:
        """`crf`: x264's constant rate factor, 0 (lossless in its colour space) to 51."""
        self.path, self.frames, self._fps = path, 0, fps
        self._container = av.open(str(path), "w")
        stream = self._container.add_stream(CODEC, rate=fps, options={"crf": str(crf), "g": str(KEYFRAMES), "bf": "0"})
        if not isinstance(stream, VideoStream):
            raise DatasetError(f"{CODEC} is not a video codec of this build of PyAV; install PyAV from its own wheels")
        stream.height, stream.width = height, width
        # colour at full resolution: 6 to 11 dB better for small pictures than 4:2:0 at the same size; some browsers do not play it
        stream.pix_fmt = "yuv444p"
        stream.thread_count = 1
        # said in the file, or players would guess another matrix for small pictures than the one that is used here
        stream.codec_context.colorspace, stream.codec_context.color_range = 5, 1
        self._stream = stream

    def add(self, image: NDArray[np.uint8]) -> None:
        """The next frame, `(height, width, 3)` RGB."""
        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(image), format="rgb24")
        frame.pts, frame.time_base = self.frames, Fraction(1, self._fps)
        self._container.mux(self._stream.encode(frame))
        self.frames += 1

    @property
    def size(self) -> int:
        """Bytes written so far, some frames late."""
        return self.path.stat().st_size if self.path.exists() else 0

    def close(self) -> None:
        """Write what is left and end the file."""
        self._container.mux(self._stream.encode(None))
        self._container.close()


def frames_of(path: Path) -> Iterator[NDArray[np.uint8]]:
    """The frames of a video in order, each `(height, width, 3)` RGB."""
    with av.open(str(path)) as container:
        for frame in container.decode(video=0):
            yield np.asarray(frame.to_ndarray(format="rgb24"), np.uint8)


def facts(path: Path) -> dict[str, Any]:
    """What LeRobot's `info.json` says of a video."""
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        return {
            "video.height": stream.height,
            "video.width": stream.width,
            "video.codec": stream.codec.canonical_name,
            "video.pix_fmt": stream.pix_fmt,
            "video.is_depth_map": False,
            "video.fps": int(stream.average_rate or 0),
            "video.channels": 3,
            "has_audio": False,
        }


def psnr(error: float) -> float:
    """Peak signal-to-noise ratio [dB] of 8-bit images with this mean squared error; infinite for none."""
    return float("inf") if error == 0 else float(10 * np.log10(255.0**2 / error))
