"""The numbers that host/core/src/metrics/tests.rs is held to, by scikit-image: python3 metrics.py

Images are made of integers, so that Rust makes the same ones to the bit.
"""

import numpy
from skimage import __version__
from skimage.metrics import peak_signal_noise_ratio, structural_similarity


def noise(index):
    """Integers without a pattern, below 2^24: the finalizer of MurmurHash3."""
    mask = 0xFFFFFFFF
    x = (index + 1) * 0x9E3779B9 & mask
    x = (x ^ (x >> 16)) * 0x85EBCA6B & mask
    x = (x ^ (x >> 13)) * 0xC2B2AE35 & mask
    return (x ^ (x >> 16)) >> 8


def scene(x, y, channel):
    """A ramp, blocks and stripes, 0 to 1023: smooth parts, edges and texture."""
    ramp = (5 * x + (3 + channel) * y) % 512
    block = 200 if (x // 9 + y // 7 + channel) % 3 == 0 else 0
    stripe = 60 * ((x * (channel + 1) + 2 * y) // 3 % 5)
    return (ramp + block + stripe) % 1024


def images(kind, width, height):
    image = numpy.zeros((height, width, 3), numpy.float32)
    truth = numpy.zeros((height, width, 3), numpy.float32)
    for y in range(height):
        for x in range(width):
            for channel in range(3):
                at = (y * width + x) * 3 + channel
                if kind == "random":
                    a, b = noise(2 * at), noise(2 * at + 1)
                    scale = 1 << 24
                else:
                    # a photograph, and a render of it that is a little brighter, smoother and noisy
                    b = 14 * scene(x, y, channel)
                    a = 7 * (scene(x, y, channel) + scene(x + 1, y, channel)) + 300 + noise(at) % 800
                    scale = 1 << 14
                image[y, x, channel] = numpy.float32(a) / numpy.float32(scale)
                truth[y, x, channel] = numpy.float32(b) / numpy.float32(scale)
    return image.astype(numpy.float64), truth.astype(numpy.float64)


print(f"// scikit-image {__version__}")
for kind in ["random", "natural"]:
    for width, height in [(11, 11), (40, 12), (12, 40), (64, 48), (97, 61)]:
        image, truth = images(kind, width, height)
        psnr = peak_signal_noise_ratio(truth, image, data_range=1)
        ssim = structural_similarity(
            truth, image, data_range=1, channel_axis=-1, gaussian_weights=True, sigma=1.5,
            use_sample_covariance=False,
        )
        print(f'("{kind}", [{width}, {height}], {psnr:.14}, {ssim:.15}),')
