"""MP4: H.264 by PyAV, one thread, nothing in it that differs from run to run."""

from __future__ import annotations

import importlib.util
import os
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Final

from layfigure_frontends.film.reel import Film, Size

if TYPE_CHECKING:
    from av.video.frame import VideoFrame
    from av.video.stream import VideoStream

    from layfigure_frontends.film.reel import Pixels

# Measured on films of one figure at 640x480: as near to the original as 4:2:0 colour comes, and 2.5 ms a picture.
_ENCODER = {
    "preset": "superfast",
    "crf": "17",
    "x264-params": "bframes=0:rc-lookahead=0:mbtree=0:subme=0",
}
_CODEC: Final = "libx264"
_BT709 = 1
_LIMITED = 1
_SECONDS_BETWEEN_KEYS = 2


def notes(film: Film) -> tuple[str, ...]:
    """Say what H.264 needs of a film that it has not."""
    even = _even(film.size)
    if even == film.size:
        return ()
    return (f"H.264 wants even sizes: {film.size} is padded to {even}",)


def check() -> None:
    """Find out whether PyAV is there, without importing it: a film that was made before needs it no more.

    Raises:
        LayfigureError: it is not.
    """
    from layfigure.errors import LayfigureError

    if importlib.util.find_spec("av") is None:
        install = f"{_interpreter()} -m pip install 'layfigure[video]'"
        raise LayfigureError(f"writing .mp4 needs PyAV; install it with: {install} (or write .webp, .gif or .apng)")


def _interpreter() -> str:
    """Return the running Python as a shell finds it: from the folder one is in where that is shorter."""
    running = sys.executable or "python"
    try:
        beside = os.path.relpath(running)
    except (OSError, ValueError):  # the folder is gone, or lies on another drive
        beside = running
    shortest = min(running, beside, key=len)
    return shlex.quote(shortest) if os.name == "posix" else f'"{shortest}"'


def write(film: Film, pictures: Iterator[Pixels], path: Path) -> None:
    """Write an H.264 film that starts playing before it is loaded whole.

    Raises:
        FileError: the file cannot be written.
        LayfigureError: PyAV, or in it the encoder, is missing, or it cannot be loaded.
    """
    from layfigure.errors import LayfigureError
    from layfigure.files.writing import write_beside

    check()
    try:
        import av
        import av.video.reformatter
    except ImportError as error:
        advice = "install it anew, or write .webp, .gif or .apng"
        raise LayfigureError(f"PyAV is there, but cannot be loaded ({error}); {advice}") from None

    if _CODEC not in av.codecs_available:
        raise LayfigureError(f"this PyAV has no {_CODEC}; write .webp, .gif or .apng, or frames/%04d.png")
    write_beside(path, lambda place: _write(place, film, pictures))


def _even(size: Size) -> Size:
    return Size(size.width + size.width % 2, size.height + size.height % 2)


def _write(place: Path, film: Film, pictures: Iterator[Pixels]) -> None:
    import av

    try:
        with av.open(
            str(place), "w", format="mp4", options={"movflags": "+faststart", "fflags": "+bitexact"}
        ) as container:
            stream = container.add_stream(_CODEC, rate=film.rate, options=_ENCODER)
            _describe(stream, film)
            for frame in _frames(film, pictures):
                container.mux(stream.encode(frame))
            container.mux(stream.encode())
    except av.FFmpegError as error:
        raise OSError(error.errno, error.strerror) from None


def _describe(stream: VideoStream, film: Film) -> None:
    context = stream.codec_context
    stream.width, stream.height = _even(film.size)
    stream.pix_fmt = "yuv420p"
    context.time_base = 1 / film.rate
    context.thread_count = 1
    context.gop_size = max(round(_SECONDS_BETWEEN_KEYS * film.rate), 1)
    context.colorspace = context.color_primaries = context.color_trc = _BT709
    context.color_range = _LIMITED
    context.flags |= 1 << 23  # bitexact: no version string


def _frames(film: Film, pictures: Iterator[Pixels]) -> Iterator[VideoFrame]:
    import av
    import numpy as np
    from av.video.reformatter import VideoReformatter

    reformatter = VideoReformatter()
    width, height = _even(film.size)
    padding = ((0, height - film.size.height), (0, width - film.size.width))
    for number, picture in enumerate(pictures):
        padded = np.pad(picture, padding, mode="edge") if width * height != picture.size else picture
        bytes_ = np.ascontiguousarray(padded, dtype="<u4").view(np.uint8).reshape(height, width, 4)
        frame = av.VideoFrame.from_numpy_buffer(bytes_, format="bgra")
        frame = reformatter.reformat(frame, width, height, "yuv420p", dst_colorspace=_BT709, threads=1)
        frame.pts, frame.time_base = number, 1 / film.rate
        yield frame
