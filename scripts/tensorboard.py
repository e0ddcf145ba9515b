#!/usr/bin/env python3
"""Writes the log of a training run, and its pictures, for TensorBoard.

    pip install tensorboardX pillow tensorboard
    python scripts/tensorboard.py run
    tensorboard --logdir run/tensorboard

It replaces what it has written before, so run it again while a training goes on.
"""

import json
import re
import sys
from pathlib import Path

import numpy as np
from PIL import Image
from tensorboardX import SummaryWriter


def scalars(record):
    """The tag and the value of each number of a record."""
    if record["kind"] == "step":
        for name in ["loss", "psnr", "gaussians", "tiles_per_second"]:
            yield f"train/{name}", record[name]
        for name, rate in record["rates"].items():
            yield f"learning_rate/{name}", rate
    elif record["kind"] == "evaluation":
        for name in ["psnr", "ssim"]:
            yield f"held_out/{name}", record[name]


def main():
    run = Path(sys.argv[1])
    folder = run / "tensorboard"
    for old in folder.glob("events.out.tfevents.*"):
        old.unlink()
    with SummaryWriter(str(folder)) as writer:
        for line in (run / "metrics.jsonl").read_text().splitlines():
            record = json.loads(line)
            for tag, value in scalars(record):
                if value is not None:
                    writer.add_scalar(tag, value, record["step"])
        # names such as `view-1-step-000500.jpg`; a photograph has no step
        for path in sorted((run / "pictures").glob("*.jpg")):
            name, step = re.fullmatch(r"(.+?)(?:-(\d{6,}))?", path.stem).groups()
            writer.add_image(name, np.asarray(Image.open(path).convert("RGB")), int(step or 0), dataformats="HWC")


main()
