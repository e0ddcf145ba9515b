#!/usr/bin/env python3
"""Runs `organza bench` and other programs in alternation on the same files, and prints the ratios as Markdown.

    python bench/compare.py --rounds 3 \\
        --pair 'forward' \\
            'organza bench scene.safetensors cameras.json tiles.json --backend cpu --forward --json' forward_s \\
            'python peer.py scene.safetensors cameras.json tiles.json' total_s

A pair is our command and the key of our time, then the peer's command and the key of its time. Each command
prints a JSON object, its last output. A key may be a sum: `kernels:dense+hash_grid` adds up the seconds of these entries of
the list `kernels`. A round runs every pair, ours first in even rounds and last in odd ones, so that other
work of the machine slows down both. The ratio is the median of the rounds' ratios, peer by ours: above 1, ours is faster. Peak
memory is what a command prints as `peak_memory_bytes`, or else the peak of its largest process. The standard library is enough.
"""

import argparse
import json
import os
import platform
import shlex
import statistics
import subprocess
import sys
from pathlib import Path


def last_object(text):
    """The last JSON object that a program has printed. Other text may come before it."""
    decoder = json.JSONDecoder()
    for line_start in reversed([0] + [i + 1 for i, c in enumerate(text) if c == "\n"]):
        if text[line_start:line_start + 1] == "{":
            try:
                value, end = decoder.raw_decode(text[line_start:])
            except json.JSONDecodeError:
                continue
            if not text[line_start + end:].strip():
                return value
    raise ValueError("no JSON object at the end of its output")


def value_of(found, key):
    """A value, or the sum of the seconds of some kernels."""
    name, colon, kernels = key.partition(":")
    if not colon:
        return float(found[key])
    seconds = {kernel["name"]: kernel["seconds"] for kernel in found[name]}
    return sum(seconds[kernel] for kernel in kernels.split("+"))


def run(command, key):
    """Runs a command: its value, and its peak memory in bytes."""
    words = shlex.split(command)
    try:
        process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
    except OSError as error:
        sys.exit(f"error: cannot run `{words[0]}`: {error.strerror}")
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"error: exit code {process.returncode} of `{command}`")
    try:
        found = last_object(text)
        value = value_of(found, key)
    except (KeyError, TypeError, ValueError) as error:
        sys.exit(f"error: no value `{key}` from `{command}`: {error}")
    # what a program says of itself leaves out what it did afterwards; kilobytes otherwise, but bytes on macOS
    peak = usage.ru_maxrss * (1 if sys.platform == "darwin" else 1024)
    return value, found.get("peak_memory_bytes") or peak


def cpu_name():
    """The system's name of its CPU."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.machine()


def machine():
    """The machine, and how busy it is."""
    return f"{cpu_name()}, {os.cpu_count()} cores; load average before the first run {os.getloadavg()[0]:.1f}"


def measure(pairs, rounds):
    """The rounds of every pair, ours and the peer's (value, memory): those that were done when Ctrl-C was pressed."""
    found = {name: [] for name, *_ in pairs}
    try:
        measure_rounds(pairs, rounds, found)
    except KeyboardInterrupt:
        print("interrupted: the table has the rounds that were done", file=sys.stderr)
    return found


def measure_rounds(pairs, rounds, found):
    for index in range(rounds):
        for name, *commands in pairs:
            sides = [commands[:2], commands[2:]]
            order = [0, 1] if index % 2 == 0 else [1, 0]
            results = {side: run(*sides[side]) for side in order}
            found[name].append((results[0], results[1]))
            ours, peer = results[0][0], results[1][0]
            print(f"round {index + 1}, {name}: ours {ours:.4f}, peer {peer:.4f}, {peer / ours:.2f}", file=sys.stderr)


def table(found):
    """Markdown: medians, the ratios' median and range, memory."""
    lines = ["| measured | organza | peer | peer / organza | range | memory: organza | peer | organza / peer |",
             "| --- | ---: | ---: | ---: | --- | ---: | ---: | ---: |"]
    for name, rounds in found.items():
        if not rounds:
            continue
        ours, peer = (statistics.median(pair[side][0] for pair in rounds) for side in (0, 1))
        ratios = sorted(pair[1][0] / pair[0][0] for pair in rounds)
        memory = [max(pair[side][1] for pair in rounds) for side in (0, 1)]
        mib = [f"{bytes_ / 2**20:,.0f} MiB" for bytes_ in memory]
        lines.append(f"| {name} | {ours:.3f} s | {peer:.3f} s | **{statistics.median(ratios):.1f}** | "
                     f"{ratios[0]:.1f} to {ratios[-1]:.1f} | {mib[0]} | {mib[1]} | {memory[0] / memory[1]:.2f} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pair", nargs=5, action="append", required=True,
                        metavar=("NAME", "OURS", "KEY", "PEER", "PEER_KEY"))
    parser.add_argument("--rounds", type=int, default=3, help="runs of each command [3]")
    args = parser.parse_args()
    if args.rounds < 1:
        parser.error("--rounds must be at least 1")
    where = machine()
    found = measure(args.pair, args.rounds)
    done = max(len(rounds) for rounds in found.values())
    print(f"{where}; {done} {'round' if done == 1 else 'rounds'}\n\n{table(found)}")


if __name__ == "__main__":
    main()
