#!/usr/bin/env python3
"""Draws hour.svg, the curves of long runs over time: `plot.py RUN...` (needs matplotlib).

Thick lines are held-out views, thin lines what the runs were trained on. A curve's name is that of its run's folder.
"""

import json
import sys
from pathlib import Path

import matplotlib
import matplotlib.pyplot as plt

matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "organza"
matplotlib.rcParams["font.family"] = "sans-serif"
HERE = Path(__file__).parent
COLORS = ["#0b6e99", "#d9730d", "#6b6b6b"]


def finish(name, corner="lower right"):
    plt.grid(alpha=0.3)
    plt.legend(frameon=False, loc=corner)
    for side in ("top", "right"):
        plt.gca().spines[side].set_visible(False)
    plt.tight_layout()
    plt.savefig(HERE / f"{name}.svg", metadata={"Date": None})
    plt.close()


def main():
    plt.figure(figsize=(6.4, 3.6))
    for color, run in zip(COLORS, map(Path, sys.argv[1:])):
        records = [json.loads(line) for line in (run / "metrics.jsonl").read_text().splitlines()]
        # a batch of nothing but background has no finite PSNR
        steps = [r for r in records if r["kind"] == "step" and r["psnr"] is not None]
        evaluations = [r for r in records if r["kind"] == "evaluation"]
        size = max(1, len(steps) // 100)
        parts = [steps[i:i + size] for i in range(0, len(steps), size)]
        plt.plot([p[-1]["seconds"] / 60 for p in parts], [sum(r["psnr"] for r in p) / len(p) for p in parts],
                 color=color, alpha=0.35, linewidth=1)
        plt.plot([r["seconds"] / 60 for r in evaluations], [r["psnr"] for r in evaluations],
                 color=color, linewidth=2, label=run.name)
    plt.xlabel("minutes of training")
    plt.ylabel("PSNR (dB)")
    finish("hour")


if __name__ == "__main__":
    main()
