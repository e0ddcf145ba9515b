"""Photographs with poses."""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence

import numpy as np

from . import _organza
from ._cameras import Cameras
from ._images import Images
from ._renderer import Renderer


class Dataset:
    """Photographs with camera poses: what a scene is trained on. `load_dataset` reads one."""

    def __init__(self, core: _organza.Dataset) -> None:
        self._core = core

    @classmethod
    def built_in(
        cls, renderer: Renderer, views: int = 48, side: int = 128, hold_out_every: int = 8
    ) -> Dataset:
        """`views` images of `side` x `side` pixels around the built-in scene, which `renderer` renders."""
        if hold_out_every == 1:
            raise ValueError("`hold_out_every` is 1, which leaves nothing to train on")
        # its sizes are a setting, with a range
        _organza.TrainConfig(
            None, None, [f"data.built_in_views={views}", f"data.built_in_side={side}"]
        )
        return cls(_organza.Dataset.built_in(renderer, views, side, hold_out_every))

    @property
    def cameras(self) -> Cameras:
        """The camera of each photograph."""
        return Cameras(self._core.cameras)

    @property
    def names(self) -> list[str]:
        """The name of each photograph."""
        return self._core.names

    @property
    def train(self) -> list[int]:
        """Indices of the photographs to train on."""
        return self._core.train

    @property
    def held_out(self) -> list[int]:
        """Indices of the photographs that are held out to measure on."""
        return self._core.held_out

    @property
    def background(self) -> tuple[float, float, float]:
        """The color behind the scene: red, green and blue, 0 to 1."""
        return tuple(self._core.background)

    @property
    def missing(self) -> list[os.PathLike[str]]:
        """Photographs that the data set names and that are not there."""
        return self._core.missing

    def image(self, index: int) -> Images:
        """A photograph, `float32 [H, W, 3]`, 0 to 1."""
        return (self._core.image(range(len(self))[index]) / np.float32(255.0)).view(Images)

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        return repr(self._core)


def load_dataset(
    path: str | os.PathLike[str],
    *,
    downscale: int = 1,
    hold_out_every: int = 8,
    background: Sequence[float] | None = None,
    allow_outside: bool = False,
    scene: _organza.Scene | None = None,
) -> Dataset:
    """Reads a data set of nerfstudio, Blender or COLMAP: a folder, or a `transforms.json`.

    Photographs become smaller by the factor `downscale`. Every `hold_out_every`-th is held out, beginning with the first; 0 holds
    none out. With a `scene` that was trained on some of them, those are held out that it has not seen. `background` is red, green and blue, 0 to 1: what photographs with an alpha channel are put in front of. The data set
    may name files outside its own folder only with `allow_outside`.

    Raises `FileNotFoundError`, and `ValueError` for what is damaged or not supported. What may be wrong with the data set is a
    warning.
    """
    color = None if background is None else [float(value) for value in background]
    if color is not None and len(color) != 3:
        raise ValueError(f"`background` has {len(color)} values, expected red, green and blue")
    core = _organza.Dataset.load(path, downscale, hold_out_every, color, allow_outside, scene)
    for note in core.notes:
        warnings.warn(note, stacklevel=2)
    return Dataset(core)
