#!/usr/bin/env python3
"""Trains one scene in several ways with one seed, and compares the bits of all tensors.

    python scripts/reproducibility.py runs target/release/organza [DATA] [--steps N] [-- OPTION ...]

`runs` is a new folder. Without DATA it is the built-in scene. What follows `--` goes to every training, as `--downscale 2`. It prints a
Markdown table, and exits with 1 if a row has other bits than the first one.
"""

import argparse
import hashlib
import json
import subprocess
import sys
import time
from pathlib import Path


def digest(run):
    """SHA-256 of the names, types, shapes and bytes of all tensors of a run's checkpoint, and their number."""
    content = (run / "checkpoint.safetensors").read_bytes()
    start = 8 + int.from_bytes(content[:8], "little")
    header = json.loads(content[8:start])
    header.pop("__metadata__", None)
    total = hashlib.sha256()
    for name, tensor in sorted(header.items()):
        begin, end = tensor["data_offsets"]
        total.update(json.dumps([name, tensor["dtype"], tensor["shape"]]).encode())
        total.update(content[start + begin : start + end])
    return total.hexdigest(), len(header)


def main():
    arguments = sys.argv[1:]
    options = []
    if "--" in arguments:
        at = arguments.index("--")
        options = arguments[at + 1 :]
        arguments = arguments[:at]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", type=Path, help="a new folder")
    parser.add_argument("organza", help="the program")
    parser.add_argument("data", nargs="?", help="a data set; without, the built-in scene")
    parser.add_argument("--steps", type=int, default=300)
    args = parser.parse_args(arguments)
    args.runs.mkdir(parents=True)

    def train(run, *more):
        subprocess.run([args.organza, "train", "-q", "-o", run, *more], check=True)

    started = time.monotonic()
    first = args.runs / "0"
    fresh = [*([args.data] if args.data else []), "--steps", str(args.steps), "--seed", "1", *options]
    train(first, *fresh)
    half = str(max(1, round((time.monotonic() - started) / 2)))

    ways = [(f"run {i} of 5", []) for i in range(2, 6)]
    ways += [("1 thread", ["--threads", "1"]), ("2 threads", ["--threads", "2"])]
    ways += [("stopped halfway, and resumed", ["--time-limit", half])]
    ways += [("2 ranks", ["--ranks", "2"]), ("4 ranks", ["--ranks", "4"])]
    print("| training | tensors | SHA-256 of all bits |\n| --- | ---: | --- |")
    expected, tensors = digest(first)
    print(f"| run 1 of 5 | {tensors} | `{expected[:16]}` |", flush=True)
    status = 0
    for index, (name, more) in enumerate(ways, 1):
        run = args.runs / str(index)
        train(run, *fresh, *more)
        if "--time-limit" in more:
            subprocess.run([args.organza, "train", "-q", "--resume", run], check=True)
        found, tensors = digest(run)
        note = "" if found == expected else ": other bits"
        status |= found != expected
        print(f"| {name} | {tensors} | `{found[:16]}`{note} |", flush=True)
    sys.exit(status)


if __name__ == "__main__":
    main()
