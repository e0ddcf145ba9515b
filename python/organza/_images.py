"""Rendered images that notebooks show."""

from __future__ import annotations

import os
import struct
import zlib

import numpy as np


class Images(np.ndarray):
    """Rendered images `[C, H, W, 3]`, or one of them `[H, W, 3]`: numbers of `float32`, 0 to 1 but not clamped.

    It is an array of numpy in every way; a notebook shows it as a picture, and `save` writes that.
    """

    def to_bytes(self) -> np.ndarray:
        """The nearest of 256 levels, `uint8`; what is outside 0 to 1 is clamped, and NaN is 0."""
        values = np.nan_to_num(np.asarray(self), nan=0.0)
        return np.floor(np.clip(values, 0.0, 1.0) * 255.0 + 0.5).astype(np.uint8)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a PNG; several images stand side by side."""
        with open(path, "wb") as file:
            file.write(self._png())

    def _repr_png_(self) -> bytes | None:
        is_image = self.ndim in (3, 4) and self.shape[-1] == 3 and self.size > 0
        return self._png() if is_image else None

    def _png(self) -> bytes:
        if self.ndim not in (3, 4) or self.shape[-1] != 3 or self.size == 0:
            raise ValueError(f"{list(self.shape)} is no image, expected [H, W, 3] or [C, H, W, 3]")
        pixels = self.to_bytes()
        if pixels.ndim == 4:
            pixels = np.concatenate(list(pixels), axis=1)
        height, width, _ = pixels.shape
        # each row begins with its filter: none
        rows = np.concatenate([np.zeros((height, 1), np.uint8), pixels.reshape(height, -1)], axis=1)

        def chunk(kind: bytes, data: bytes) -> bytes:
            check = zlib.crc32(kind + data)
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)

        header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
        return (
            b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6))
            + chunk(b"IEND", b"")
        )


def whole(tiles: np.ndarray, count: int, width: int, height: int) -> np.ndarray:
    """`[C * rows * columns, planes, S, S]` as `[C, H, W, planes]`: the inverse of `Tiles.cover`. Also of torch's tensors."""
    _, planes, side, _ = tiles.shape
    rows, columns = -(-height // side), -(-width // side)
    # camera, row, column, plane, y, x to camera, row, y, column, x, plane
    tiles = tiles.reshape(count, rows, columns, planes, side, side)
    tiles = tiles.permute(0, 1, 4, 2, 5, 3) if hasattr(tiles, "permute") else tiles.transpose(0, 1, 4, 2, 5, 3)
    return tiles.reshape(count, rows * side, columns * side, planes)[:, :height, :width]
