#!/usr/bin/env python3
"""How time and memory grow: `organza bench` over synthetic workloads that differ in one number, as tables and a plot.

    pip install numpy safetensors matplotlib
    python bench/growth.py --organza target/release/organza --plot growth.svg [--options '--backend cpu']

Prints Markdown. Each series changes one number of the workload of bench/synthetic.py and leaves the others.
"""

import argparse
import json
import shlex
import subprocess
import sys
import tempfile

import synthetic
from compare import last_object, machine

SERIES = {
    "gaussians": ("Gaussians", [1_000, 10_000, 100_000, 1_000_000]),
    "tiles": ("tiles of 64 x 64", [1, 4, 16, 64, 256, 1_024]),
    "step": ("sigma, the length of a step", [0.24, 0.12, 0.06, 0.03, 0.015]),
    "hidden": ("width of hidden layers", [16, 32, 64, 128]),
}


def bench(organza, files, repeat, options):
    """Measurements of `organza bench` for some files."""
    command = [organza, "bench", *map(str, files), "--repeat", str(repeat), "--json", "--quiet", *options]
    result = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if result.returncode != 0:
        sys.exit(f"error: exit code {result.returncode} of `{shlex.join(command)}`")
    return last_object(result.stdout)


def measure(series, args):
    """A row for each value of a series."""
    rows = []
    for value in SERIES[series][1]:
        if f"{series}={value}" in args.leave_out:
            continue
        with tempfile.TemporaryDirectory() as folder:
            files = synthetic.write(folder, **{series: value})
            rows.append((value, bench(args.organza, files, args.repeat, shlex.split(args.options))))
        found = rows[-1][1]
        print(f"{series} {value:,}: {found['forward_s']:.4f}, {found['forward_backward_s']:.4f}", file=sys.stderr)
    return rows


def mib(bytes_):
    return "-" if bytes_ is None else f"{bytes_ / 2**20:,.0f}"


def table(series, rows):
    lines = [f"| {SERIES[series][0]} | pairs | intersections | samples | forward, s | forward and backward, s | "
             "memory forward, MiB | and backward, MiB |", "| ---: |" + " ---: |" * 7]
    for value, found in rows:
        counts = " | ".join(f"{found[key]:,}" for key in ("pairs", "members", "samples"))
        lines.append(f"| {value:,} | {counts} | {found['forward_s']:.3f} | {found['forward_backward_s']:.3f} | "
                     f"{mib(found['forward_peak_memory_bytes'])} | {mib(found['peak_memory_bytes'])} |")
    return "\n".join(lines)


def short(number):
    """In at most two digits: 12 k."""
    for unit, name in ((1_000_000, " M"), (1_000, " k")):
        if number >= unit:
            return f"{number / unit:.2g}{name}" if number < 100 * unit else f"{number / unit:.0f}{name}"
    return str(number)


def plot(found, path):
    """Seconds against each series' number, both axes logarithmic; a dotted line is linear."""
    import matplotlib

    matplotlib.use("svg")
    # the same data, the same file
    matplotlib.rcParams.update({"svg.hashsalt": "organza", "svg.fonttype": "none", "font.size": 9})
    from matplotlib import pyplot, ticker

    figure, axes = pyplot.subplots(1, len(found), figsize=(3.1 * len(found), 3.0), squeeze=False, layout="constrained")
    for axis, (series, rows) in zip(axes[0], found.items()):
        # samples are what a step's length stands for
        by_samples = series == "step"
        x = [row["samples"] if by_samples else value for value, row in rows]
        for key, label, marker in (("forward_s", "forward", "o"), ("forward_backward_s", "forward and backward", "s")):
            y = [row[key] for _, row in rows]
            line, = axis.plot(x, y, marker=marker, label=label)
            axis.plot(x, [y[-1] * at / x[-1] for at in x], ":", color=line.get_color(), linewidth=0.8)
        axis.set(xscale="log", yscale="log", xlabel="samples" if by_samples else SERIES[series][0], ylabel="seconds")
        axis.set_xticks(x, [short(value) for value in x])
        axis.xaxis.set_minor_locator(ticker.NullLocator())
        axis.yaxis.set_minor_formatter(ticker.NullFormatter())
        axis.grid(alpha=0.3)
        axis.set_ylim(bottom=0.3 * min(row["forward_s"] for _, row in rows))
    axes[0][0].legend()
    figure.savefig(path, metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--organza", default="target/release/organza", help="the program")
    parser.add_argument("--options", default="--backend cpu", help="more options of `organza bench`")
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--series", nargs="+", choices=SERIES, default=list(SERIES))
    parser.add_argument("--leave-out", nargs="+", default=[], metavar="SERIES=VALUE", help="such as gaussians=1000000")
    parser.add_argument("--plot", help="where to write the plot, SVG")
    parser.add_argument("--record", help="where to write what was measured, JSON")
    parser.add_argument("--from", dest="source", help="plot and print a record instead of measuring")
    args = parser.parse_args()
    if args.source:
        with open(args.source) as file:
            record = json.load(file)
    else:
        record = {"machine": machine(), "series": {series: measure(series, args) for series in args.series}}
    if args.record:
        with open(args.record, "w") as file:
            json.dump(record, file)
    print(record["machine"])
    for series, rows in record["series"].items():
        print(f"\n{table(series, rows)}")
    if args.plot:
        plot(record["series"], args.plot)


if __name__ == "__main__":
    main()
