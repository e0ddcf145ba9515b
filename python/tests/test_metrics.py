"""Metrics of images, held to their definitions."""


import numpy as np
import pytest

import organza


@pytest.fixture
def pair():
    random = np.random.default_rng(3)
    truth = random.random((24, 40, 3), np.float32)
    return np.clip(truth + random.normal(0, 0.05, truth.shape), 0, 1).astype(np.float32), truth


def test_psnr_is_its_definition(pair):
    image, truth = pair
    expected = -10 * np.log10(np.mean((image.astype(np.float64) - truth) ** 2))
    assert organza.psnr(image, truth) == pytest.approx(expected, rel=1e-12)
    assert organza.psnr(truth, truth) == np.inf
    assert np.array_equal(organza.psnr(np.stack([image, truth]), np.stack([truth, truth])), [organza.psnr(image, truth), np.inf])
    levels = np.round(255 * image).astype(np.uint8)
    assert organza.psnr(levels, levels / np.float32(255)) == np.inf


def test_ssim_is_its_definition(pair):
    image, truth = (values.astype(np.float64) for values in pair)
    at = np.arange(11) - 5
    window = np.exp(-(at**2) / (2 * 1.5**2))
    window = np.outer(window, window) / window.sum() ** 2

    def mean(values):
        patches = np.lib.stride_tricks.sliding_window_view(values, (11, 11), (0, 1))
        return np.einsum("yxcij,ij->yxc", patches, window)

    x, y = mean(image), mean(truth)
    xx, yy, xy = mean(image**2) - x * x, mean(truth**2) - y * y, mean(image * truth) - x * y
    expected = np.mean((2 * x * y + 1e-4) * (2 * xy + 9e-4) / ((x * x + y * y + 1e-4) * (xx + yy + 9e-4)))
    assert organza.ssim(*pair) == pytest.approx(expected, rel=1e-9)
    assert organza.ssim(image, image) == pytest.approx(1)


def test_bad_comparisons_are_refused(pair):
    image, truth = pair
    for found, expected in [(image, truth[:-1]), (image[..., 0], truth[..., 0]), (image[..., :2], truth[..., :2])]:
        with pytest.raises(ValueError, match="expected two of one shape"):
            organza.psnr(found, expected)
    with pytest.raises(ValueError, match="11 x 11"):
        organza.ssim(image[:10], truth[:10])
