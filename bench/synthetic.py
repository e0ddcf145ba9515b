#!/usr/bin/env python3
"""Writes a synthetic workload: Gaussians in a shell, networks of full size with random weights, 16 views around them.

    pip install numpy safetensors
    python bench/synthetic.py OUT_DIR [--gaussians 20000] [--tiles 64] [--side 64] [--step 0.03] [--hidden 64] [--occupancy 32]

OUT_DIR gets scene.safetensors, cameras.json and tiles.json. The same options give the same files.
A program without an occupancy grid is compared with `--occupancy 0`, which evaluates all steps of rays.
"""

import argparse
import json
import math
from pathlib import Path

import numpy as np
from safetensors.numpy import save_file

VIEWS, WIDTH, HEIGHT, FOCAL = 16, 640, 480, 620.0
GRID = {"levels": 16, "features": 2, "log2_table": 19, "base_resolution": 16, "growth": 1.4472692}
MATERIAL, EXTRA, SH_DEGREE = 32, 2, 3


def entries(grid):
    """Entries of all levels of a hash grid."""
    total = 0
    for level in range(grid["levels"]):
        resolution = math.ceil(grid["base_resolution"] * grid["growth"] ** level - 1.0) + 1
        total += min((resolution**3 + 7) // 8 * 8, 1 << grid["log2_table"])
    return total


def network(random, name, widths, shift):
    """Weights by He; `shift` is added to the last layer's biases."""
    tensors = {}
    for layer, (inputs, outputs) in enumerate(zip(widths, widths[1:])):
        is_last = layer + 2 == len(widths)
        tensors[f"{name}.{layer}.weight"] = random.normal(0, math.sqrt(2 / inputs), (outputs, inputs))
        tensors[f"{name}.{layer}.bias"] = random.normal(0, 0.1, outputs) + (shift if is_last else 0.0)
    return tensors


def scene(random, gaussians, step, hidden, occupancy):
    """Tensors and configuration. Gaussians shrink as their number grows: they cover the same volume."""
    features = GRID["levels"] * GRID["features"]
    config = {"sh_degree": SH_DEGREE, "material": MATERIAL, "extra": EXTRA, "color_grid": GRID,
              "transmittance_grid": GRID, "color_mlp": {"hidden": [hidden] * 2},
              "transmittance_mlp": {"hidden": [hidden] * 2}, "step": step, "occupancy": occupancy, "blur": 0.3,
              "background": [0.1, 0.2, 0.3], "aabb": [[-1.5] * 3, [1.5] * 3]}
    direction = random.normal(size=(gaussians, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    tensors = {
        "gaussians.position": direction * random.uniform(0.3, 1.2, (gaussians, 1)),
        "gaussians.rotation": random.normal(size=(gaussians, 4)),
        "gaussians.log_scale": random.normal(math.log(0.6 / gaussians ** (1 / 3)), 0.4, (gaussians, 3)),
        "gaussians.opacity": random.normal(0, 1.5, gaussians),
        "gaussians.material": random.normal(size=(gaussians, MATERIAL)),
        "gaussians.extra": random.normal(size=(gaussians, EXTRA)),
        "color.grid": random.normal(0, 0.3, (entries(GRID), GRID["features"])),
        "transmittance.grid": random.normal(0, 0.3, (entries(GRID), GRID["features"])),
    }
    tensors |= network(random, "color.mlp", [(SH_DEGREE + 1) ** 2 + features + MATERIAL, hidden, hidden, 3], 0.0)
    # most of the light gets through
    tensors |= network(random, "transmittance.mlp", [features + EXTRA, hidden, hidden, 1], 3.0)
    return {name: np.ascontiguousarray(value, np.float32) for name, value in tensors.items()}, config


def cameras():
    """On a wavy circle, looking at the middle: nerfstudio's transforms.json."""
    frames = []
    for view in range(VIEWS):
        angle = 2 * math.pi * view / VIEWS
        eye = np.array([3.4 * math.cos(angle), 3.4 * math.sin(angle), 0.6 * math.sin(3 * angle)])
        back = eye / np.linalg.norm(eye)
        right = np.cross([0, 0, 1.0], back)
        right /= np.linalg.norm(right)
        matrix = np.eye(4)
        matrix[:3] = np.stack([right, np.cross(back, right), back, eye], 1)
        frames.append({"file_path": f"images/{view:04}.png", "transform_matrix": matrix.tolist()})
    return {"w": WIDTH, "h": HEIGHT, "fl_x": FOCAL, "fl_y": FOCAL, "cx": WIDTH / 2, "cy": HEIGHT / 2, "frames": frames}


def write(out, gaussians=20_000, tiles=64, side=64, step=0.03, hidden=64, occupancy=32):
    """Writes the three files into a folder, and returns their paths."""
    # tiles have a generator of their own, so that other changes do not move them
    random, places = np.random.default_rng(5), np.random.default_rng(6)
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    tensors, config = scene(random, gaussians, step, hidden, occupancy)
    files = [out / name for name in ("scene.safetensors", "cameras.json", "tiles.json")]
    save_file(tensors, files[0], {"format": "organza.scene", "version": "1", "config": json.dumps(config)})
    files[1].write_text(json.dumps(cameras()))
    chosen = [{"camera": int(places.integers(VIEWS)),
               "origin": [int(places.integers(0, WIDTH - side)), int(places.integers(0, HEIGHT - side))]}
              for _ in range(tiles)]
    files[2].write_text(json.dumps({"side": side, "tiles": chosen}))
    return files


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out")
    parser.add_argument("--gaussians", type=int, default=20_000)
    parser.add_argument("--tiles", type=int, default=64)
    parser.add_argument("--side", type=int, default=64, help="of a tile, in pixels")
    parser.add_argument("--step", type=float, default=0.03, help="sigma: half of it, twice the samples")
    parser.add_argument("--hidden", type=int, default=64, help="width of the networks' hidden layers")
    parser.add_argument("--occupancy", type=int, default=32, help="cells along a side of the occupancy grid; 0: none")
    args = parser.parse_args()
    for file in write(**vars(args)):
        print(file)


if __name__ == "__main__":
    main()
