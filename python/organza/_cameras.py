"""Cameras, and the tiles of their images."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _organza

# from OpenCV's axes (x right, y down, z forward) to OpenGL's (x right, y up, z back)
_FLIP = np.diag([1.0, -1.0, -1.0, 1.0])


class Cameras:
    """C pinhole cameras in the world. Lengths are in world units, images in pixels; the center of the first pixel is (0.5, 0.5)."""

    def __init__(self, core: _organza.Cameras) -> None:
        self._core = core

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Cameras:
        """Reads nerfstudio's `transforms.json`, or the cameras of a data set's folder, without their lenses' distortion.

        Raises `FileNotFoundError`, and `ValueError` for a file that does not describe pinhole cameras.
        """
        return cls(_organza.Cameras.load(path))

    @classmethod
    def from_matrices(
        cls,
        viewmats: ArrayLike,
        Ks: ArrayLike,
        width: int,
        height: int,
        convention: Literal["opencv", "opengl"] = "opencv",
    ) -> Cameras:
        """Cameras of matrices, as gsplat takes them.

        `viewmats [C, 4, 4]` map world to camera. `convention` says how a camera's axes point: "opencv" is x right, y down, z
        forward; "opengl" is x right, y up, z back. `Ks [C, 3, 3]` are intrinsics in pixels; a skew is not supported.
        Raises `ValueError` where a matrix has another shape, is no rotation with a translation, or is not finite.
        """
        viewmats, Ks = np.asarray(viewmats, np.float64), np.asarray(Ks, np.float64)
        if viewmats.ndim != 3 or viewmats.shape[1:] != (4, 4):
            raise ValueError(f"`viewmats` is {list(viewmats.shape)}, expected [C, 4, 4]")
        if Ks.shape != (len(viewmats), 3, 3):
            raise ValueError(f"`Ks` is {list(Ks.shape)}, expected [{len(viewmats)}, 3, 3]")
        if len(Ks) and np.abs(Ks[:, 0, 1]).max() > 1e-6:
            raise ValueError("a matrix of `Ks` has a skew, which is not supported")
        if convention not in ("opencv", "opengl"):
            raise ValueError(f"there is no convention {convention!r}; expected 'opencv' or 'opengl'")
        try:
            poses = np.linalg.inv(viewmats)
        except np.linalg.LinAlgError:
            raise ValueError("a matrix of `viewmats` has no inverse") from None
        if convention == "opencv":
            poses = poses @ _FLIP
        # the last row is exact, although the inverse is rounded
        poses[:, 3] = np.round(poses[:, 3], 9)
        poses, Ks = np.ascontiguousarray(poses), np.ascontiguousarray(Ks)
        return cls(_organza.Cameras.from_poses(poses, Ks, width, height))

    @classmethod
    def turntable(cls, views: int, side: int) -> Cameras:
        """Cameras around the built-in scene, whose images have `side` x `side` pixels."""
        return cls(_organza.Cameras.turntable(views, side))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes nerfstudio's `transforms.json`."""
        self._core.save(path)

    @property
    def viewmats(self) -> NDArray[np.float64]:
        """World to camera with OpenCV's axes, `[C, 4, 4]`."""
        return np.linalg.inv(self._core.poses() @ _FLIP)

    @property
    def poses(self) -> NDArray[np.float64]:
        """Camera to world with OpenGL's axes, as in `transforms.json`, `[C, 4, 4]`."""
        return self._core.poses()

    @property
    def Ks(self) -> NDArray[np.float64]:
        """Intrinsics in pixels, `[C, 3, 3]`."""
        return self._core.intrinsics()

    @property
    def sizes(self) -> list[tuple[int, int]]:
        """Width and height of each image."""
        return self._core.sizes()

    @property
    def names(self) -> list[str | None]:
        """The photograph of each, as the file names it."""
        return self._core.names()

    def __getitem__(self, index: int | slice | Sequence[int]) -> Cameras:
        """Some of the cameras: always `Cameras`, of one for an integer."""
        places = np.arange(len(self))[index]
        return Cameras(self._core.select([int(place) for place in np.atleast_1d(places)]))

    def __iter__(self) -> Iterator[Cameras]:
        return (self[index] for index in range(len(self)))

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        sizes = sorted(set(self.sizes))
        shown = ", ".join(f"{width} x {height}" for width, height in sizes[:3])
        return f"<organza.Cameras: {len(self)} of {shown}{', ...' if len(sizes) > 3 else ''} pixels>"


class Tiles:
    """A batch of K square tiles of images."""

    def __init__(self, side: int, tiles: ArrayLike) -> None:
        """`side` is S in pixels; `tiles [K, 3]` are whole numbers: the camera's index, x and y of the corner."""
        tiles = np.asarray(tiles)
        if tiles.ndim != 2 or tiles.shape[1] != 3 or not np.issubdtype(tiles.dtype, np.integer):
            found = f"{tiles.dtype} {list(tiles.shape)}"
            raise ValueError(f"`tiles` is {found}, expected whole numbers [K, 3]: camera, x, y")
        self._core = _organza.Tiles(side, np.ascontiguousarray(tiles, np.int64))

    @classmethod
    def _of(cls, core: _organza.Tiles) -> Tiles:
        tiles = cls.__new__(cls)
        tiles._core = core
        return tiles

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Tiles:
        """Reads a tiles file. Raises `FileNotFoundError` and `ValueError`."""
        return cls._of(_organza.Tiles.load(path))

    @classmethod
    def cover(cls, cameras: Cameras, side: int = 64) -> Tiles:
        """The tiles that cover the images of all cameras, one camera after the other, row by row."""
        return cls._of(_organza.Tiles.cover(cameras._core, side))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a tiles file."""
        self._core.save(path)

    @property
    def side(self) -> int:
        """S, in pixels."""
        return self._core.side

    def __array__(self, dtype: object = None, copy: bool | None = None) -> NDArray[np.int64]:
        """`[K, 3]`: camera, x, y."""
        array = self._core.array()
        return array if dtype is None else array.astype(dtype)

    def __len__(self) -> int:
        return len(self._core)

    def __repr__(self) -> str:
        return repr(self._core)
