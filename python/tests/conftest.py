"""Fixtures of several tests: a small scene, cameras and tiles, on the CPU."""

import os
import shutil

import numpy as np
import pytest

import organza


@pytest.fixture(scope="session")
def renderer():
    return organza.Renderer("cpu", threads=2)


@pytest.fixture(scope="session")
def program():
    """The program of the same sources, where it is built."""
    named = os.environ.get("ORGANZA_PROGRAM") or shutil.which("organza")
    if named is None:
        pytest.skip("there is no program `organza` to compare with: set ORGANZA_PROGRAM")
    return named


@pytest.fixture(scope="session")
def scene():
    """Every 16th Gaussian of the built-in scene."""
    whole = organza.Scene.built_in()
    tensors = whole.tensors()
    some = {
        name: values[::16] if name.startswith("gaussians.") else values
        for name, values in tensors.items()
    }
    return organza.Scene.from_tensors(some, whole.config)


@pytest.fixture(scope="session")
def cameras():
    return organza.Cameras.turntable(2, 40)


@pytest.fixture(scope="session")
def tiles():
    return organza.Tiles(16, [[0, 12, 10], [1, 8, 16], [0, -4, 20]])


@pytest.fixture
def slopes():
    return np.random.default_rng(1).normal(size=(3, 3, 16, 16)).astype(np.float32)
