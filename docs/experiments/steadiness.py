#!/usr/bin/env python3
"""Measures how steady images are while a camera moves, and plots it: `steadiness.py [SCENE CAMERAS]` (needs matplotlib).

The built-in scene, and another one beside it. Prints the table of docs/experiments.md. tests/pictures/steadiness.rs has the measure
and the sorted renderer.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from plot import COLORS, HERE, finish

PIXELS = 128 * 128
LABELS = {
    "organza": "organza",
    "sorted": "sorted by depth",
    "organza-whole": "organza, footprints without an end",
    "sorted-whole": "sorted, footprints without an end",
}


def measure(files):
    """Second differences by step and kind, in 8-bit levels."""
    with tempfile.TemporaryDirectory() as out:
        environment = {**os.environ, "OUT": out, **dict(zip(["SCENE", "CAMERAS"], files))}
        command = ["cargo", "test", "--test", "pictures", "measure_steadiness", "--", "--ignored"]
        subprocess.run(command, cwd=HERE, env=environment, check=True)
        found = {}
        for path in Path(out).glob("*.raw"):
            step, kind = path.stem.split("-", 1)
            found.setdefault(float(step), {})[kind] = np.fromfile(path, np.float32)
        return dict(sorted(found.items(), reverse=True))


def main():
    scenes = {"the built-in scene": []}
    if len(sys.argv) > 2:
        scenes["a capture"] = [str(Path(path).absolute()) for path in sys.argv[1:3]]
    _, panels = plt.subplots(1, len(scenes), figsize=(6.4 if len(scenes) == 1 else 9.6, 3.8), squeeze=False, sharey=True)
    print("| scene | step | image | mean | above 1 level | largest |\n| --- | ---: | --- | ---: | ---: | ---: |")
    for panel, (name, files) in zip(panels[0], scenes.items()):
        found = measure(files)
        for step, kinds in found.items():
            for kind, label in LABELS.items():
                values = kinds[kind]
                many = (values > 1).sum() / (len(values) / PIXELS)
                print(f"| {name} | {step:g}° | {label} | {values.mean():.4f} | {many:.1f} | {values.max():.2f} |", flush=True)
        for color, kind in zip(COLORS, ("organza", "sorted")):
            largest = [kinds[kind].max() for kinds in found.values()]
            panel.plot(list(found), largest, label=LABELS[kind], color=color, linewidth=2, marker="o", markersize=4)
        panel.set(xscale="log", yscale="log", title=name, xlabel="step of the camera (degrees)")
        panel.set_xticks(list(found), [f"{step:g}" for step in found], minor=False)
        panel.set_yticks([1, 10, 100], ["1", "10", "100"])
        panel.minorticks_off()
        panel.invert_xaxis()
        panel.grid(alpha=0.3)
        panel.spines[["top", "right"]].set_visible(False)
    panels[0][0].set_ylabel("largest second difference\nof a pixel (8-bit levels)")
    finish("steadiness", "lower left")


if __name__ == "__main__":
    main()
