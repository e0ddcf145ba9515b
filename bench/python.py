#!/usr/bin/env python3
"""Measures what calls from Python take, beside the native calls that they make.

usage: python bench/python.py FOLDER [--rounds 15] [--threads 2] [--backend cpu]

FOLDER has scene.safetensors, cameras.json and tiles.json, as bench/synthetic.py writes them. Needs the package and the program organza,
and torch.

Each round measures a native call and then the same from Python, so that other programs slow both. `organza bench` measures the native
calls: forward ends with the tiles in the host's memory, backward with the gradients on the device.
From Python, gradients are read into arrays, too. A training step by torch's Adam renders, compares, runs the backward pass and updates every
parameter; a native one does all of that on the device, for as many tiles of as many images of a scene of the same size.
"""

import argparse
import json
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import torch

import organza
import organza.torch


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--backend", default="cpu")
    arguments = parser.parse_args()
    torch.set_num_threads(arguments.threads)
    renderer = organza.Renderer(arguments.backend, threads=arguments.threads)
    scene = organza.Scene.load(arguments.folder / "scene.safetensors")
    cameras = organza.Cameras.load(arguments.folder / "cameras.json")
    tiles = organza.Tiles.load(arguments.folder / "tiles.json")
    rounds = arguments.rounds
    print(f"{renderer.device}; {len(scene)} Gaussians, {len(tiles)} tiles of {tiles.side}, {rounds} rounds")
    uploaded = renderer.upload(scene)
    shape = (len(tiles), 3, tiles.side, tiles.side)
    ones, target = np.ones(shape, np.float32), torch.zeros(shape)

    command = ["organza", "bench", *(arguments.folder / name for name in ("scene.safetensors", "cameras.json", "tiles.json"))]
    command += ["--backend", arguments.backend, "--threads", str(arguments.threads), "--repeat", "1", "--json"]

    def native(name):
        forward = ["--forward"] if name == "forward_s" else []
        return lambda: json.loads(subprocess.run(command + forward, check=True, capture_output=True).stdout)[name]

    def record():
        renderer.record(uploaded, cameras, tiles).backward(ones)

    pair("forward", native("forward_s"), timed(lambda: renderer.render(uploaded, cameras, tiles)), rounds)
    pair("forward and backward", native("forward_backward_s"), timed(record), rounds)
    module = organza.torch.Scene(scene, renderer)

    def autograd():
        module.zero_grad(set_to_none=True)
        module(cameras, tiles).sum().backward()

    pair("forward and backward, by torch.autograd", native("forward_backward_s"), timed(autograd), rounds)
    optimizer = torch.optim.Adam(module.parameters(), lr=1e-3)

    def step():
        optimizer.zero_grad(set_to_none=True)
        (module(cameras, tiles) - target).square().mean().backward()
        optimizer.step()

    with tempfile.TemporaryDirectory() as folder, training(renderer, scene, cameras, tiles, Path(folder)) as run:
        pair("training step, by torch's Adam", timed(lambda: next(run)), timed(step), rounds)


class training:
    """A native run with as many Gaussians, tiles and values as the scene that is measured."""

    def __init__(self, renderer, scene, cameras, tiles, folder):
        file = folder / "transforms.json"
        cameras.save(file)
        described = json.loads(file.read_text())
        for index, (image, frame) in enumerate(zip(renderer.render(scene, cameras), described["frames"])):
            frame["file_path"] = f"{index:04}.png"
            image.save(folder / frame["file_path"])
        file.write_text(json.dumps(described))
        settings = {
            "run.steps": 100_000,
            "run.evaluate_every": 0,
            "run.tiles_per_step": len(tiles),
            "run.tile_size": tiles.side,
            "run.tiles_per_view": len(tiles) // len(cameras),
            "start.gaussians": len(scene),
            "densification.max_gaussians": len(scene),
            "densification.end": 0,
            # each step has whole photographs, and trains all tensors, as torch's does
            "run.coarse": 0,
            "optimizer.transmittance_every": 1,
        }
        config = scene.config
        for name in ("sh_degree", "material", "extra", "step"):
            settings[f"scene.{name}"] = config[name]
        for field in ("color", "transmittance"):
            settings[f"scene.{field}_mlp.hidden"] = config[f"{field}_mlp"]["hidden"]
            for name in ("levels", "features", "log2_table", "base_resolution", "growth"):
                settings[f"scene.{field}_grid.{name}"] = config[f"{field}_grid"][name]
        dataset = organza.load_dataset(folder, hold_out_every=0)
        self.run = organza.train(dataset, organza.TrainConfig(settings=settings), renderer=renderer)

    def __enter__(self):
        return iter(self.run)

    def __exit__(self, *_):
        self.run.close()


def timed(call):
    def seconds():
        begin = time.perf_counter()
        call()
        return time.perf_counter() - begin

    return seconds


def pair(name, native, python, rounds):
    native(), python()
    found = [(native(), python()) for _ in range(rounds)]
    ratios = sorted(b / a for a, b in found)
    medians = [statistics.median(column) for column in zip(*found)]
    least = [min(column) for column in zip(*found)]
    middle = statistics.median(ratios)
    quarter = rounds // 4
    print(f"{name}: native {medians[0]:.3f} s, from Python {medians[1]:.3f} s; ratio {middle:.3f}, half of the rounds "
          f"{ratios[quarter]:.2f} to {ratios[-1 - quarter]:.2f}; least {least[0]:.3f} s, {least[1]:.3f} s", flush=True)


if __name__ == "__main__":
    main()
