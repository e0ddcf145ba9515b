"""How close images are."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _organza

_Measure = Callable[[NDArray[np.float32], NDArray[np.float32]], float | None]


def psnr(image: ArrayLike, truth: ArrayLike) -> float | NDArray[np.float64]:
    """The peak signal-to-noise ratio in decibels, `-10 log10(MSE)`; infinite for equal images.

    Images are `[H, W, 3]`, or several `[C, H, W, 3]`, which give an array `[C]`. Their colors are numbers from 0 to 1, or `uint8`. Raises
    `ValueError` where the shapes are others.
    """
    return _measured(_organza.psnr, image, truth, "the images have no pixels")


def ssim(image: ArrayLike, truth: ArrayLike) -> float | NDArray[np.float64]:
    """The structural similarity (Wang, Bovik, Sheikh and Simoncelli 2004), 1 for equal images: the mean over the channels and over windows of
    11 x 11 pixels, with Gaussian weights of sigma 1.5.

    Takes what `psnr` takes, but images of 11 x 11 pixels at least.
    """
    return _measured(_organza.ssim, image, truth, "SSIM needs images of 11 x 11 pixels at least")


def _measured(measure: _Measure, image: ArrayLike, truth: ArrayLike, refusal: str) -> float | NDArray[np.float64]:
    image, truth = _colors(image), _colors(truth)
    if image.shape != truth.shape or image.ndim not in (3, 4):
        found = f"{list(image.shape)} and {list(truth.shape)}"
        raise ValueError(f"the images are {found}, expected two of one shape [H, W, 3] or [C, H, W, 3]")
    if image.ndim == 4:
        return np.array([_measured(measure, *pair, refusal) for pair in zip(image, truth)], np.float64)
    value = measure(image, truth)
    if value is None:
        raise ValueError(refusal)
    return value


def _colors(image: ArrayLike) -> NDArray[np.float32]:
    image = np.asarray(image)
    if image.dtype == np.uint8:
        image = image / np.float32(255)
    return np.ascontiguousarray(image, np.float32)
