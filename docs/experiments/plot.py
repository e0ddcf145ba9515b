#!/usr/bin/env python3
"""Plots and tabulates the runs of run.sh: `plot.py RUNS` (needs matplotlib)."""

import json
import sys
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "organza"
matplotlib.rcParams["font.family"] = "sans-serif"
HERE = Path(__file__).parent
FIGURES = {
    "transmittance": {"base": "T learned", "visible": "T = 1"},
    "branch": {"base": "S > 1 divided", "undivided": "never divided"},
    "tiles": {"base": "20 tiles of 32 from many images", "neighbors": "20 tiles of 32 from 5 images", "images": "one whole image"},
    "growth": {"base": "split", "relocate": "relocate", "fixed": "none"},
}
STEPS = 600
COLORS = ["#0b6e99", "#d9730d", "#6b6b6b"]


def curve(run):
    records = [json.loads(line) for line in (run / "metrics.jsonl").read_text().splitlines()]
    points = [(r["step"], r["psnr"]) for r in records if r["kind"] == "evaluation"]
    return points


def finish(name, corner="lower right"):
    plt.grid(alpha=0.3)
    plt.legend(frameon=False, loc=corner)
    for side in ("top", "right"):
        plt.gca().spines[side].set_visible(False)
    plt.tight_layout()
    plt.savefig(HERE / f"{name}.svg", metadata={"Date": None})
    plt.close()


def long(runs):
    """The curves of the long runs over time: held-out views, and thin lines for the batches that they trained on."""
    plt.figure(figsize=(6.4, 3.6))
    for color, run in zip(COLORS, runs):
        records = [json.loads(line) for line in (run / "metrics.jsonl").read_text().splitlines()]
        # a batch of nothing but background has no finite PSNR
        steps = [r for r in records if r["kind"] == "step" and r["psnr"] is not None]
        evaluations = [r for r in records if r["kind"] == "evaluation"]
        size = max(1, len(steps) // 100)
        parts = [steps[i:i + size] for i in range(0, len(steps), size)]
        plt.plot([p[-1]["seconds"] / 60 for p in parts], [sum(r["psnr"] for r in p) / len(p) for p in parts],
                 color=color, alpha=0.35, linewidth=1)
        plt.plot([r["seconds"] / 60 for r in evaluations], [r["psnr"] for r in evaluations],
                 color=color, linewidth=2, label=run.name.removeprefix("hour-"))
    plt.xlabel("minutes of training")
    plt.ylabel("PSNR (dB)")
    finish("hour")


def main():
    runs = Path(sys.argv[1])
    if hours := sorted(runs.glob("hour-*")):
        long(hours)
    rows = {}
    for figure, names in FIGURES.items():
        plt.figure(figsize=(6.4, 3.6))
        for color, (name, label) in zip(COLORS, names.items()):
            found = [curve(run) for run in sorted(runs.glob(f"{name}-[0-9]")) if (run / "metrics.jsonl").exists()]
            # a run that is not over yet
            found = [points for points in found if points[-1][0] == STEPS]
            if not found:
                continue
            for points in found:
                plt.plot(*zip(*points), color=color, alpha=0.35, linewidth=1)
            steps = [step for step, _ in found[0]]
            mean = [sum(points[i][1] for points in found) / len(found) for i in range(len(steps))]
            plt.plot(steps, mean, color=color, linewidth=2, label=label)
            at = dict(zip(steps, mean))
            rows[name] = [at[200], at[400], mean[-1], max(p[-1][1] for p in found) - min(p[-1][1] for p in found) if len(found) > 1 else float("nan")]
        plt.xlabel("steps")
        plt.ylabel("held-out PSNR (dB)")
        finish(figure)
    print("| run | 200 steps | 400 steps | 600 steps | spread of two seeds |\n| --- | ---: | ---: | ---: | ---: |")
    for name, (early, middle, last, spread) in rows.items():
        print(f"| {name} | {early:.2f} | {middle:.2f} | {last:.2f} | {spread:.2f} |")


if __name__ == "__main__":
    main()
