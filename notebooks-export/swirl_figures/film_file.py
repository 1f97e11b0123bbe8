"""Pictures to a film's file, .gif or .mp4, which appears under its name only when it is whole."""

import os
import subprocess

from PIL import Image

from .output import partial_of, put_in_place

MARK = "made by swirl animate"

#: Of a gif's picture: colours enough for lines on white, and few enough for a small file.
_COLOURS = 64


def write_film(pictures, path, fps):
    """By way of `.NAME.partial`. OSError where it cannot be written."""
    partial = partial_of(path)
    try:
        (_write_gif if path.suffix == ".gif" else _write_mp4)(pictures, partial, fps)
        put_in_place(partial, path)
    finally:
        partial.unlink(missing_ok=True)


def _write_gif(pictures, partial, fps):
    images = [Image.fromarray(picture).convert("RGB").quantize(_COLOURS, dither=Image.Dither.NONE) for picture in pictures]
    with partial.open("wb") as file:  # a gif counts hundredths of a second
        images[0].save(file, format="GIF", save_all=True, append_images=images[1:], loop=0, comment=MARK.encode(),
                       duration=max(20, 10 * round(100 / fps)))


def _write_mp4(pictures, partial, fps):
    process = None
    try:
        for picture in pictures:
            if process is None:
                height, width = picture.shape[:2]
                process = subprocess.Popen(_command(width, height, fps, partial), stdin=subprocess.PIPE,
                                           stderr=subprocess.PIPE)
            process.stdin.write(picture.tobytes())
        errors = process.communicate()[1]
    except BrokenPipeError:
        errors = process.communicate()[1]
    except BaseException:
        if process is not None:
            process.kill()
            process.wait()
        raise
    if process.returncode != 0:
        words = errors.decode(errors="replace").split()
        raise OSError(0, "ffmpeg: " + " ".join(words)[-300:])


def _command(width, height, fps, partial):
    """H.264 that browsers and slides show; the same bytes for the same pictures."""
    return ["ffmpeg", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgba", "-s", f"{width}x{height}", "-r", f"{fps:g}",
            "-i", "-", "-an", "-c:v", "libx264", "-preset", "veryfast", "-crf", "22", "-pix_fmt", "yuv420p", "-threads", "1",
            "-metadata", f"comment={MARK}", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-movflags", "+faststart",
            "-y", "-f", "mp4", os.fspath(partial)]
