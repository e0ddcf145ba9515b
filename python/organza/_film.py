"""Films."""

from __future__ import annotations

import os

from . import _organza
from ._cameras import Cameras
from ._renderer import Renderer


def film(
    scene: _organza.Scene | _organza.DeviceScene,
    path: str | os.PathLike[str],
    cameras: Cameras,
    *,
    fps: int = 30,
    renderer: Renderer | None = None,
) -> None:
    """Renders a frame for each camera, and makes a film of them, as `organza film` does.

        organza.film(scene, "film.mp4", dataset.cameras.among(180))

    `Cameras.among`, `Cameras.between` and `Cameras.orbit` are the ways of that command's camera. The ending of `path` says what is written: ".mp4"
    by the program ffmpeg, which must be installed, and only of even width and height; ".png", which is animated; without an ending,
    a new folder of images. `fps` are the frames a second, 1 to 240.

    Raises `ValueError` for another ending, cameras of several sizes or none, a folder that is not empty, or where ffmpeg fails or is not there;
    `OSError` where the film cannot be written. Ctrl-C keeps the old file at `path`, or the frames of a folder so far.
    """
    renderer = renderer or Renderer()
    _organza.film(renderer, renderer._on_device(scene), path, cameras._core, fps)
