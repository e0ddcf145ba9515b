"""Cameras on the ways of films, and films."""

import json
import struct
import subprocess

import numpy as np
import pytest

import organza


def poses(path):
    return np.array([frame["transform_matrix"] for frame in json.loads(path.read_text())["frames"]])


def test_an_orbit_looks_at_its_center(cameras):
    orbit = cameras.orbit(8, center=[0.1, 0.2, 0.3], up=[0, 0, 2], distance=4, elevation=30, field_of_view=60, size=(64, 48))
    assert orbit.sizes == [(64, 48)] * 8
    eyes = orbit.poses[:, :3, 3] - [0.1, 0.2, 0.3]
    assert np.allclose(np.linalg.norm(eyes, axis=1), 4) and np.allclose(eyes[:, 2], 4 * np.sin(np.radians(30)))
    # looking along -z, at the center
    assert np.allclose(orbit.poses[:, :3, 2] * 4, eyes)
    assert np.allclose(orbit.Ks[:, 0, 0], 32 / np.tan(np.radians(30)))
    turns = np.unwrap(np.arctan2(eyes[:, 1], eyes[:, 0]))
    assert np.allclose(np.diff(turns), 2 * np.pi / 8)


def test_a_scene_is_gone_around(scene):
    orbit = organza.Cameras.around(scene, 4)
    assert orbit.sizes == [(640, 480)] * 4
    low, high = np.array(scene.config["aabb"])
    assert np.allclose(orbit.poses[:, :3, 3].mean(axis=0)[:2], (low + high)[:2] / 2)


def test_ways_go_where_cameras_stand():
    given = organza.Cameras.turntable(12, 32)
    path = given.between(23, size=(40, 20))
    # from the first to the last, and every second frame is near a key: they are evenly spaced
    assert path.sizes == [(40, 20)] * 23 and np.allclose(path.poses[[0, -1]], given.poses[[0, -1]], atol=1e-9)
    assert np.abs(path.poses[::2] - given.poses).max() < 0.02
    loop = given.between(24, loop=True)
    assert np.allclose(loop.poses[0], given.poses[0], atol=1e-9) and len(loop) == 24
    ring = given.among(12)
    assert np.allclose(np.linalg.norm(ring.poses[:, :3, 3], axis=1), np.linalg.norm(given.poses[0, :3, 3]), rtol=0.05)
    with pytest.raises(ValueError, match="two cameras"):
        given[0].between(5)
    for call in (given.among, given.orbit, given.between):
        with pytest.raises(ValueError, match="`frames` is 0"):
            call(0)
    with pytest.raises(ValueError, match="`elevation` is 90"):
        given.orbit(4, elevation=90)


def test_a_film_has_the_frames_of_the_program(renderer, scene, program, tmp_path):
    given = organza.Cameras.turntable(3, 24)
    scene.save(tmp_path / "scene.safetensors")
    given.save(tmp_path / "cameras.json")
    for way, frames in [("--between", given.between(4)), ("--orbit", given.orbit(4))]:
        name = way.strip("-")
        words = ["film", "scene.safetensors", "cameras.json", "-o", name, way, "--frames", "4", "--backend", "cpu"]
        subprocess.run([program, *words], cwd=tmp_path, check=True, capture_output=True)
        organza.film(scene, tmp_path / f"{name}-python", frames, renderer=renderer)
        names = [f"{index:05}.png" for index in range(4)]
        assert sorted(path.name for path in (tmp_path / f"{name}-python").iterdir()) == names
        for frame in names:
            assert pixels(tmp_path / name / frame) == pixels(tmp_path / f"{name}-python" / frame)


def chunks(path):
    data, at = path.read_bytes(), 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at : at + 4])
        yield data[at + 4 : at + 8], data[at + 8 : at + 8 + length]
        at += 12 + length


def pixels(path):
    """The compressed pixels of a PNG: the text of its origin is left out."""
    return [data for kind, data in chunks(path) if kind in (b"IHDR", b"IDAT")]


def test_a_film_is_one_file(renderer, scene, tmp_path):
    frames = organza.Cameras.turntable(3, 16)
    path = tmp_path / "film.png"
    organza.film(scene, path, frames, fps=12, renderer=renderer)
    found = list(chunks(path))
    (control,) = (data for kind, data in found if kind == b"acTL")
    assert struct.unpack(">II", control) == (3, 0)
    delays = [struct.unpack(">HH", data[20:24]) for kind, data in found if kind == b"fcTL"]
    assert delays == [(1, 12)] * 3 and list(tmp_path.iterdir()) == [path]


def test_bad_films_are_refused(renderer, scene, tmp_path):
    frames = organza.Cameras.turntable(2, 16)
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "note").write_text("mine")
    refused = {
        "a film is written as": (tmp_path / "film.avi", frames, 30),
        "needs a camera": (tmp_path / "film.png", frames[[]], 30),
        "`fps` is 0": (tmp_path / "film.png", frames, 0),
        "not empty": (tmp_path / "full", frames, 30),
    }
    for message, (path, cameras, fps) in refused.items():
        with pytest.raises(ValueError, match=message):
            organza.film(scene, path, cameras, fps=fps, renderer=renderer)
    with pytest.raises(FileNotFoundError, match="nowhere"):
        organza.film(scene, tmp_path / "nowhere" / "film.png", frames, renderer=renderer)
    assert [path.name for path in tmp_path.iterdir()] == ["full"]
