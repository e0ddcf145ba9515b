"""The largest networks, grids and sample counts that the kernels allow, computed by the float64 reference:
four hidden layers of 128, 16 levels, sigma 0.005.

    pip install jax safetensors numpy
    python worst_case.py ../cases/worst

Takes a minute and 1.5 GB.
"""

import json
import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
from safetensors.numpy import load_file, save_file

import reference


def main():
    out = Path(sys.argv[1])
    # a case of the usual form, whose networks and grids are then replaced by larger ones
    reference.random_case(out, seed=11, gaussians=24, degree=7, material=8, extra=2, levels=2, log2_table=9, growth=1.4,
                          hidden=16, side=16, smooth=False, step=0.5, grow=0.3)
    config = reference.load_scene(out / "scene.safetensors")[1]
    scene = {k: v for k, v in load_file(out / "scene.safetensors").items() if "mlp" not in k and "grid" not in k}
    rng = np.random.default_rng(12)
    hidden = [128] * 4
    grid = dict(config["color_grid"], levels=16, growth=1.38)
    config |= {"step": 0.005, "color_grid": grid, "transmittance_grid": grid,
               "color_mlp": {"hidden": hidden}, "transmittance_mlp": {"hidden": hidden}}
    total = reference.grid_levels(grid)[1]
    for name, inputs, outputs, shift in (("color", 64 + 32 + 8, 3, 0.0), ("transmittance", 32 + 2, 1, 6.0)):
        scene[f"{name}.grid"] = rng.normal(0, 0.5, (total, 2))
        sizes = [inputs, *hidden, outputs]
        for i in range(len(sizes) - 1):
            scene[f"{name}.mlp.{i}.weight"] = rng.normal(0, np.sqrt(2 / sizes[i]), (sizes[i + 1], sizes[i]))
            scene[f"{name}.mlp.{i}.bias"] = rng.normal(0, 0.1, sizes[i + 1]) + (shift if i + 2 == len(sizes) else 0.0)
    scene = {k: np.ascontiguousarray(v, dtype=np.float32) for k, v in scene.items()}
    save_file(scene, out / "scene.safetensors", {"format": "organza.scene", "version": "1", "config": json.dumps(config)})

    params, config = reference.load_scene(out / "scene.safetensors")
    cameras = reference.load_cameras(out / "cameras.json")
    tiles, side = reference.load_tiles(out / "tiles.json")
    x = reference.to_cube(config, params["gaussians.position"])
    render = lambda p, poses: reference.render_tiles(p, config, cameras, tiles, side, poses)
    y, vjp = jax.vjp(render, params, jnp.zeros((len(cameras), 6)))
    grad_tiles = np.random.default_rng(13).normal(0.0, 1.0, y.shape).astype(np.float32)
    gradient, pose_gradient = vjp(jnp.array(grad_tiles, dtype=jnp.float64))
    expected = {"tiles": y, "grad_tiles": grad_tiles, **{f"grad.{k}": v for k, v in gradient.items()},
                "grad.poses": pose_gradient,
                "stage.color_encoding": reference.hash_grid(params["color.grid"], config["color_grid"], x)}
    for c, camera in enumerate(cameras):
        eye = camera[0][:3, 3]
        direction = params["gaussians.position"] - eye
        direction = direction / jnp.linalg.norm(direction, axis=-1, keepdims=True)
        v = reference.to_cube(config, eye) - x
        mean, conic, radius, visible, *_ = reference.project(params, config, camera)
        expected |= {
            f"stage.{c}.sh": reference.spherical_harmonics(direction, config["sh_degree"]),
            f"stage.{c}.color": reference.colour(params, config, x, direction),
            f"stage.{c}.sample_count": np.array([reference.segment(p, d, config["step"])[2] for p, d in zip(x, v)]),
            f"stage.{c}.transmittance": reference.transmittance(params, config, x, v, params["gaussians.extra"]),
            f"stage.{c}.mean2d": mean, f"stage.{c}.conic": conic, f"stage.{c}.radius": radius,
            f"stage.{c}.visible": visible,
        }
    save_file({k: np.ascontiguousarray(np.asarray(v, dtype=np.float32)) for k, v in expected.items()},
              out / "expected.safetensors")
    print({k: (v.shape, float(np.mean(v)), float(np.min(v)), float(np.max(v))) for k, v in expected.items()})


if __name__ == "__main__":
    main()
