#!/usr/bin/env python3
"""Measures the worth of each part of the method: trains without it, or with another, and prints the table of docs/experiments.md.

    python bench/parts.py RUNS ORGANZA CAPTURE...

The first row has PSNR and SSIM, the others what they have more or less. The same command goes on after Ctrl-C.
"""

import json
import subprocess
import sys
from pathlib import Path

# folder of the runs: what differs, and options
PARTS = {
    "base": ("defaults", []),
    "visible": ("T = 1", ["--set", "ablation.learn_transmittance=false"]),
    "undivided": ("no division where S > 1", ["--set", "ablation.divide=false"]),
    "whole": ("whole photographs and short steps of T from the start", ["--set", "run.coarse=0"]),
    "cooldown": ("no cooldown", ["--set", "optimizer.cooldown=0"]),
    "flat": ("one color for each Gaussian", ["--set", "scene.slope=0"]),
    "unshaped": ("one falloff for all Gaussians", ["--set", "scene.shape=0"]),
    "decay": ("no weight decay of T's grid", ["--set", "optimizer.transmittance_decay=0"]),
    "fixed": ("no growth", ["--set", "densification.end=0"]),
    "neighbors": ("tiles in groups of four neighbors", ["--set", "run.tiles_per_view=4"]),
    "seed": ("another seed", ["--seed", "1"]),
}


def train(organza, captures, folder, options):
    """PSNR and SSIM of each capture."""
    scores = {}
    for capture in captures:
        run = folder / Path(capture).resolve().name
        begin = ["--resume", run] if (run / "config.toml").exists() else [capture, "-o", run, "--steps", "400", *options]
        command = [organza, "train", *begin, "--backend", "cpu", "--quiet", "--json"]
        result = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
        if result["outcome"] == "stopped":
            sys.exit(f"{run} was stopped; the same command goes on")
        scores[run.name] = (result["psnr"], result["ssim"])
    return scores


def main():
    runs, organza, *captures = sys.argv[1:]
    base = None
    for name, (part, options) in PARTS.items():
        scores = train(organza, captures, Path(runs) / name, options)
        if base is None:
            base = scores
            print(f"| what differs | {' | '.join(base)} |\n| --- |{' ---: |' * len(base)}")
            cells = [f"{psnr:.2f}, {ssim:.3f}" for psnr, ssim in scores.values()]
        else:
            differences = ((psnr - base[name][0], ssim - base[name][1]) for name, (psnr, ssim) in scores.items())
            cells = [f"{psnr:+.2f}, {ssim:+.3f}".replace("-", "−") for psnr, ssim in differences]
        print(f"| {part} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
