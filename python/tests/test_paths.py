"""Cameras on the ways of films."""

import numpy as np
import pytest

import organza


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
