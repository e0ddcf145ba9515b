"""Rendering."""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence
from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _organza
from ._cameras import Cameras, Tiles
from ._images import Images, whole

Channel = Literal["depth", "alpha", "visibility", "normal"]
Array = NDArray[np.float32]

# no image depends on it
_TILE_SIDE = 64


class Renderer(_organza.Renderer):
    """Renders scenes on a device.

    `backend` is "auto" (a GPU if there is one), "gpu" or "cpu"; `threads` are the CPU's, one for each core unless given;
    `adapter` is a part of a GPU's name; `place` chooses among equally capable GPUs, counted from 0 and around. Raises `organza.Error`
    where a GPU was asked for and none can be used.

    All calls let other threads of Python run, and Ctrl-C interrupts them.
    """

    def __init__(
        self,
        backend: str = "auto",
        threads: int | None = None,
        adapter: str | None = None,
        place: int = 0,
    ) -> None:
        # the constructor of the compiled class has taken the arguments
        self._lock = threading.Lock()
        self._last: tuple[_organza.Scene, _organza.DeviceScene] | None = None

    @property
    def device(self) -> str:
        """Which device it is, and why it was taken."""
        return super().device

    def upload(self, scene: _organza.Scene) -> _organza.DeviceScene:
        """Copies a scene to the device. `MemoryError` where it does not fit."""
        return super().upload(scene)

    def _on_device(self, scene: _organza.Scene | _organza.DeviceScene) -> _organza.DeviceScene:
        if isinstance(scene, _organza.DeviceScene):
            return scene
        with self._lock:
            if self._last is None or self._last[0] is not scene:
                self._last = (scene, self.upload(scene))
            return self._last[1]

    @overload
    def render(
        self,
        scene: _organza.Scene | _organza.DeviceScene,
        cameras: Cameras,
        tiles: None = None,
    ) -> Images: ...

    @overload
    def render(
        self, scene: _organza.Scene | _organza.DeviceScene, cameras: Cameras, tiles: Tiles
    ) -> Array: ...

    def render(
        self,
        scene: _organza.Scene | _organza.DeviceScene,
        cameras: Cameras,
        tiles: Tiles | None = None,
    ) -> Array:
        """Renders whole images `[C, H, W, 3]`, or a batch of tiles `[K, 3, S, S]`, as `float32`.

        Values are not clamped: they can be outside 0 to 1. A `Scene` is uploaded first, and stays on the device until another
        one is rendered. Raises `ValueError` where a tile has no camera, or where whole images have several sizes.
        """
        return self._render(scene, cameras, tiles, ())[0]

    def render_channels(
        self,
        scene: _organza.Scene | _organza.DeviceScene,
        cameras: Cameras,
        tiles: Tiles | None = None,
        channels: Sequence[Channel] = ("depth", "alpha", "visibility", "normal"),
    ) -> tuple[Array, dict[str, Array]]:
        """Like `render`, with channels besides the color: `[C, H, W, planes]`, or `[K, planes, S, S]` of tiles.

        "depth" is in world units along the camera's axis, "alpha" the sum of the weights (it can exceed 1), "visibility" the mean
        transmittance; "normal" has 3 planes, all others 1. They are 0 where no Gaussian has a weight.
        """
        return self._render(scene, cameras, tiles, channels)

    def _render(
        self,
        scene: _organza.Scene | _organza.DeviceScene,
        cameras: Cameras,
        tiles: Tiles | None,
        channels: Sequence[Channel],
    ) -> tuple[Array, dict[str, Array]]:
        scene = self._on_device(scene)
        if tiles is not None:
            return self.render_tiles(scene, cameras._core, tiles._core, list(channels))
        width, height = one_size(cameras)
        images = np.empty((len(cameras), height, width, 3), np.float32)
        beside: dict[str, Array] = {}
        # one after the other, so that tiles take memory for one
        for index, camera in enumerate(cameras):
            batch = Tiles.cover(camera, _TILE_SIDE)
            found, more = self.render_tiles(scene, camera._core, batch._core, list(channels))
            images[index] = whole(found, 1, width, height)[0]
            for name, values in more.items():
                shape = (len(cameras), height, width, values.shape[1])
                beside.setdefault(name, np.empty(shape, np.float32))
                beside[name][index] = whole(values, 1, width, height)[0]
        return images.view(Images), beside

    def record(
        self,
        scene: _organza.Scene | _organza.DeviceScene,
        cameras: Cameras,
        tiles: Tiles,
        channels: Sequence[Channel] = (),
    ) -> _organza.Tape:
        """Renders a batch of tiles and keeps what its gradient needs: `Tape.tiles`, then `Tape.backward`."""
        scene = self._on_device(scene)
        return super().record(scene, cameras._core, tiles._core, list(channels))

    def gradient(
        self,
        scene: _organza.Scene | _organza.DeviceScene,
        cameras: Cameras,
        tiles: Tiles,
        grad_tiles: ArrayLike,
    ) -> dict[str, Array]:
        """The gradient of a loss L for every tensor of the scene, by its name, given `grad_tiles [K, 3, S, S]`, dL/dY.

        The networks see positions and directions as constants: position, rotation and scale have the gradient of the projection
        alone. Raises `organza.Error` if a gradient is not finite.
        """
        return self.record(scene, cameras, tiles).backward(grad_tiles)

    def __repr__(self) -> str:
        return f"<organza.Renderer: {self.device}>"


def one_size(cameras: Cameras) -> tuple[int, int]:
    """Width and height of all images."""
    sizes = set(cameras.sizes)
    if len(sizes) != 1:
        reason = f"whole images need cameras of one size, found {sorted(sizes)}"
        raise ValueError(f"{reason}: render cameras of one size at a time, or tiles")
    return sizes.pop()
