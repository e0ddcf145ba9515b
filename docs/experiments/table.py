#!/usr/bin/env python3
"""The table of run.sh: `table.py RUNS`. PSNR and SSIM of the first row, and what the others have more or less."""

import csv
import sys
from pathlib import Path


def results(folder):
    with (folder / "results.csv").open() as file:
        return {row["capture"]: row for row in csv.DictReader(file)}


def main():
    runs = Path(sys.argv[1])
    lines = (Path(__file__).parent / "parts.txt").read_text().splitlines()
    parts = [line.split("|") for line in lines if not line.startswith("#")]
    found = [(part.strip(), results(runs / name)) for name, part, _ in parts if (runs / name / "results.csv").exists()]
    base = found[0][1]
    # without runs that are not over yet
    found = [(part, captures) for part, captures in found if captures.keys() == base.keys()]
    print(f"| what differs | {' | '.join(base)} |\n| --- |{' ---: |' * len(base)}")
    for part, captures in found:
        cells = []
        for name, first in base.items():
            psnr, ssim = (float(captures[name][key]) for key in ("PSNR", "SSIM"))
            if captures is base:
                cells.append(f"{psnr:.2f}, {ssim:.3f}")
            else:
                cells.append(f"{psnr - float(first['PSNR']):+.2f}, {ssim - float(first['SSIM']):+.3f}".replace("-", "−"))
        print(f"| {part} | {' | '.join(cells)} |")


if __name__ == "__main__":
    main()
