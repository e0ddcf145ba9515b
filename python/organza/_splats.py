"""Files for 3D Gaussian Splatting viewers, and scenes of their files."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass

from . import _organza
from ._cameras import Cameras
from ._data import Dataset
from ._renderer import Renderer


@dataclass(frozen=True)
class Exported:
    """The content of a file for 3D Gaussian Splatting viewers, and its PSNR compared with the scene."""

    gaussians: int
    """The Gaussians of the file. Those that are nearly transparent are left out."""
    offset: list[float]
    """To be added to the file's positions. It is 0, unless the scene is so far from the origin that positions of 32 bits would be
    rounded too much."""
    psnr: float
    """How close images of the file are to the scene's own, in decibels: the mean PSNR over the views that the fit has not seen, or over
    all where there are none of these. At most 60."""
    first_psnr: float
    """The same before the first step."""
    scene_psnr: float | None
    """How close the scene's images are to the held-out photographs, in decibels. None without photographs."""
    file_psnr: float | None
    """The same of the file's images. The file loses the difference."""


def export(
    scene: _organza.Scene | _organza.DeviceScene,
    path: str | os.PathLike[str],
    cameras: Cameras | Dataset | None = None,
    *,
    steps: int = 300,
    side: int = 480,
    spz_version: int = 4,
    renderer: Renderer | None = None,
) -> Exported:
    """Writes a scene as Gaussians for 3D Gaussian Splatting viewers. They know no networks: harmonics are fitted to the colors, and opacities to
    the visibility.

        organza.export(scene, "scene.ply", dataset)

    The ending of `path` says how the file is written: ".ply" has all values; ".spz" and ".sog" round them; ".glb" is glTF;
    ".splat" has one color for all directions. `spz_version` 2 is for viewers that do not open version 4. The fit compares the images of `cameras`: every eighth is only measured. Of a data set, the photographs that are
    held out are only measured; the result then says what the file loses beside them. Without `cameras`, 48 stand all around the
    scene's box.

    The fit takes `steps`, 0 to 1,000,000. Each compares one image, whose longest side is made at most `side` pixels, 16 to 4096: fit at
    the size at which the file will be seen.

    Raises `ValueError` for another ending, no cameras, or a number out of range, `OSError` where the file cannot be written, and
    `MemoryError`. Ctrl-C keeps the old file at `path`.
    """
    renderer = renderer or Renderer()
    uploaded = renderer._on_device(scene)
    if isinstance(scene, _organza.DeviceScene):
        scene = scene.download()
    dataset = cameras._core if isinstance(cameras, Dataset) else None
    views = cameras._core if isinstance(cameras, Cameras) else None
    return Exported(**_organza.export(renderer, scene, uploaded, path, views, dataset, steps, side, spz_version))


@dataclass(frozen=True)
class Imported:
    """A scene that was made of Gaussians."""

    scene: _organza.Scene
    psnr: float | None
    """How close its images are to the file's, in decibels: the mean PSNR over the views that training has not seen. None where
    there are fewer than eight cameras."""


def import_splats(
    path: str | os.PathLike[str],
    cameras: Cameras | None = None,
    *,
    steps: int = 1500,
    side: int = 480,
    background: str | Sequence[float] = "black",
    renderer: Renderer | None = None,
) -> Imported:
    """Makes a scene of a file of 3D Gaussian Splatting: ".ply", ".spz", ".sog", ".glb" or ".splat".

    Such a file has no networks. So the Gaussians are rendered as a viewer that sorts, and the scene is trained on these images for
    `steps`, 1 to 10,000,000. `cameras` are best those that the Gaussians were trained with (`dataset.cameras`); every eighth is only
    measured. Without, 48 stand all around the Gaussians. The longest side of an image is made at most `side` pixels, 16 to 4096.
    `background` is a color's name, or red, green and blue, 0 to 1: files do not have it. What may be wrong with the file or the
    cameras is a warning.

    Raises `FileNotFoundError`, `ValueError` for a file that is damaged or of another kind, no cameras, or a number out of range, and
    `MemoryError`.
    """
    color = background if isinstance(background, str) else ",".join(str(float(value)) for value in background)
    views = None if cameras is None else cameras._core
    scene, psnr, notes = _organza.import_splats(renderer or Renderer(), path, views, steps, side, color)
    for note in notes:
        warnings.warn(note, stacklevel=2)
    return Imported(scene, psnr)
