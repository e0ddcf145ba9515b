"""A model of what a GPU takes for a batch: counts over published rates.

    python bench/gpu_model.py --organza target/release/organza [--gpu h200 --measured bench.json]

The numbers of operations and bytes come from `organza bench`, the instructions from host/render/kernels/navi21.snap. For each kernel the model takes
the longest of three times: to issue its instructions, to move its bytes from memory, and to fetch the cache lines that its random accesses
touch. So these are floors: a kernel that waits for memory, or that cannot fill the GPU, takes longer. With the output of
`organza bench --backend gpu --json` on that GPU, the table has the measured times, too.
"""

import argparse
import json
import subprocess
from pathlib import Path

# Lanes, their clock, bytes per second of memory and of the last cache, and bytes that a random access moves. AMD's numbers for the RX 6800:
# 60 compute units of 2 x 32 lanes at 2.105 GHz, 512 GB/s, and a cache of 128 MB at 2 TB/s. NVIDIA's for the H200: 132 multiprocessors of
# 128 lanes at 1.98 GHz, and 4.8 TB/s; reviewers measured about 5.5 TB/s for the cache of 50 MB, which moves sectors of 32 bytes.
GPUS = {
    "rx6800": (60 * 2 * 32, 2.105e9, 512e9, 2e12, 64),
    "h200": (132 * 128, 1.98e9, 4.8e12, 5.5e12, 32),
}
# 32-bit integer products take four times as long as other instructions.
PRODUCT = 3

# For each kernel: counted operations of one turn of its largest loop (its function `_work` in shader-crate/src), turns of that loop for one
# item with what is outside of it, or nothing if the loop is all, and random cache lines of an item.
FEATURES = 2
KERNELS = {
    "dense": (128, None, 0),
    "dense_backward": (256, None, 0),
    "dense_weight_backward": (132, None, 0),
    "composite": (20, None, 0),
    "composite_backward": (30, None, 0),
    "hash_grid": (42 + 15 * FEATURES, FEATURES, 8),
    "hash_grid_backward": (42 + 17 * FEATURES, FEATURES, 8),
}


def machine_code():
    """Instructions and integer products of each kernel and of its largest loop, from the accepted table."""
    lines = (Path(__file__).parent.parent / "host/render/kernels/navi21.snap").read_text().splitlines()
    table = {}
    for line in lines[5:]:
        whole, _, loop = line.partition("|")
        words, loop = whole.split(), [int(word) for word in loop.split()] or [0] * 6
        table[words[0]] = {"all": int(words[6]), "products": int(words[7]), "loop": loop[0], "loop_products": loop[3]}
    return table


def floors(kernel, code, gpu):
    """Seconds to issue a kernel's instructions, to move its bytes and to fetch its lines."""
    lanes, clock, memory, cache, line = gpu
    operations, moved = (1e9 * (kernel[rate] or 0) * kernel["seconds"] for rate in ("gflops", "gbs"))
    times = {"memory": moved / memory}
    if kernel["name"] in KERNELS:
        counted, turns, lines = KERNELS[kernel["name"]]
        items = operations / counted
        loop = code["loop"] + PRODUCT * code["loop_products"]
        outside = code["all"] + PRODUCT * code["products"] - loop
        times["instructions"] = items * (loop if turns is None else outside + turns * loop) / lanes / clock
        times["cache lines"] = items * lines * line / cache
    return times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--organza", default="organza", help="the program")
    parser.add_argument("--gpu", choices=GPUS, default="rx6800")
    parser.add_argument("--measured", type=Path, help="JSON of `organza bench` on that GPU")
    options = parser.parse_args()
    command = [options.organza, "bench", "--backend", "cpu", "--repeat", "1", "--json", "--quiet"]
    bench = json.loads(subprocess.run(command, stdout=subprocess.PIPE, check=True).stdout)
    found = json.loads(options.measured.read_text()) if options.measured else {"kernels": []}
    measured = {kernel["name"]: kernel["seconds"] for kernel in found["kernels"]}
    samples = bench["samples"]
    # the times of another batch of the same scene are as long as its samples are many
    scale = samples / found.get("samples", samples)
    code = machine_code()
    rows = []
    for kernel in bench["kernels"]:
        times = floors(kernel, code.get(kernel["name"]), GPUS[options.gpu])
        bound = max(times, key=times.get)
        rows.append((times[bound], bound, kernel["name"], times))
    rows.sort(reverse=True)
    total = sum(row[0] for row in rows)
    more = [" measured, ms | times the model |", " ---: | ---: |"] if measured else ["", ""]
    print("| kernel | instructions, ms | memory, ms | cache lines, ms | bound by | share |" + more[0])
    print("| --- | ---: | ---: | ---: | --- | ---: |" + more[1])
    for time, bound, name, times in rows:
        if time > 0.005 * total:
            cells = [f"{1e3 * times[key]:.3f}" if times.get(key) else "" for key in ("instructions", "memory", "cache lines")]
            cells += [bound, f"{time / total:.0%}"]
            if name in measured:
                cells += [f"{1e3 * scale * measured[name]:.3f}", f"{scale * measured[name] / time:.1f}"]
            print(f"| {name} | {' | '.join(cells)} |")
    print(f"\n{1e3 * total:.2f} ms for all")
    if measured:
        print(f"{1e3 * scale * sum(measured.values()):.2f} ms measured")


main()
