#!/usr/bin/env python3
"""Measures `organza view` as its page meets it: images a second while the camera orbits and while it turns, and the time until the
image at rest is exact.

usage: python bench/viewer.py --organza target/release/organza SCENE [DATA] [--size 640x480] [--seconds 8] [--options '--backend cpu']

One client asks for one image at a time, as the page does. An orbit turns by 1.5 degrees from image to image, around the middle of
the scene's box; turning is by 1 degree around the eye. The first second is left out: the viewer still finds out how coarse it has to be.
"""

import argparse
import http.client
import json
import math
import re
import shlex
import statistics
import subprocess
import time


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("scene")
    parser.add_argument("data", nargs="?")
    parser.add_argument("--organza", default="target/release/organza")
    parser.add_argument("--size", default="640x480")
    parser.add_argument("--seconds", type=float, default=8)
    parser.add_argument("--options", default="")
    arguments = parser.parse_args()
    words = [arguments.organza, "view", arguments.scene, *([arguments.data] if arguments.data else [])]
    words += ["--port", "0", *shlex.split(arguments.options)]
    viewer = subprocess.Popen(words, stderr=subprocess.PIPE, text=True)
    try:
        measure(viewer, [int(side) for side in arguments.size.split("x")], arguments.seconds)
    finally:
        viewer.terminate()
        viewer.wait()


class Client:
    """Asks for images as the page does."""

    def __init__(self, host, token):
        self.connection = http.client.HTTPConnection(host)
        self.token = token
        self.sequence = 0

    def get(self, path):
        self.connection.request("GET", f"{path}?{self.token}")
        return json.loads(self.connection.getresponse().read())

    def frame(self, camera, quality):
        self.sequence += 1
        request = {"client": 1, "sequence": self.sequence, "camera": camera, "mode": "color", "quality": quality}
        begin = time.perf_counter()
        self.connection.request("POST", f"/frame?{self.token}", json.dumps(request), {"Content-Type": "application/json"})
        reply = self.connection.getresponse()
        body = reply.read()
        if reply.status != 200:
            raise SystemExit(f"{reply.status}: {body.decode()}")
        return json.loads(reply.headers["x-organza"]), time.perf_counter() - begin, len(body)


def rotated(camera, axis, angle, place):
    """The camera turned around an axis through a place."""
    x, y, z = axis
    cos, sin = math.cos(angle), math.sin(angle)
    turn = [
        [cos + x * x * (1 - cos), x * y * (1 - cos) - z * sin, x * z * (1 - cos) + y * sin],
        [y * x * (1 - cos) + z * sin, cos + y * y * (1 - cos), y * z * (1 - cos) - x * sin],
        [z * x * (1 - cos) - y * sin, z * y * (1 - cos) + x * sin, cos + z * z * (1 - cos)],
    ]
    pose = camera["camera_to_world"]
    apply = lambda vector: [sum(turn[i][j] * vector[j] for j in range(3)) for i in range(3)]
    columns = [apply([pose[row][column] for row in range(3)]) for column in range(3)]
    eye = apply([pose[row][3] - place[row] for row in range(3)])
    rows = [[*(columns[column][row] for column in range(3)), eye[row] + place[row]] for row in range(3)]
    return {**camera, "camera_to_world": [*rows, [0.0, 0.0, 0.0, 1.0]]}


def resized(camera, width, height):
    """The same view in an image of another size."""
    factor = min(width / camera["w"], height / camera["h"])
    return {
        **camera, "w": width, "h": height, "cx": width / 2, "cy": height / 2,
        "fl_x": factor * camera["fl_x"], "fl_y": factor * camera["fl_y"],
    }


def measure(viewer, size, seconds):
    """Prints what was measured."""
    for line in viewer.stderr:
        print(line, end="")
        if found := re.search(r"http://([^/]+)/\?(\S+)", line):
            break
    client = Client(found[1], found[2])
    scene = client.get("/scene.json")
    home = resized(scene["home"], *size)
    up, center = scene["up"], scene["center"]
    eye = [row[3] for row in home["camera_to_world"][:3]]
    print(f"{scene['gaussians']} Gaussians, {size[0]} x {size[1]}")
    exact = [client.frame(rotated(home, up, 0.01 * turn, center), "exact")[1] for turn in range(3)]
    print(f"an exact image: {statistics.median(exact):.3f} s")
    kept = [client.frame(rotated(home, up, 0.02 + 1e-3 * turn, eye), "exact")[1] for turn in range(3)]
    print(f"an exact image after a turn around the eye: {min(kept):.3f} s")
    for name, place, degrees in [("orbit", center, 1.5), ("turn", eye, 1.0)]:
        camera, count, bytes_, begin, about = home, 0, 0, time.perf_counter(), None
        while (now := time.perf_counter() - begin) < 1 + seconds:
            camera = rotated(camera, up, math.radians(degrees), place)
            about, _, length = client.frame(camera, "moving")
            if now > 1:
                count, bytes_ = count + 1, bytes_ + length
        print(
            f"{name}: {count / seconds:.1f} images/s of {about['size'][0]} x {about['size'][1]}, steps x {about['steps']}, "
            f"{bytes_ / max(count, 1) / 1024:.0f} KiB each"
        )


if __name__ == "__main__":
    main()
