"""Gradients through JAX."""

import numpy as np
import pytest

jax = pytest.importorskip("jax", reason="JAX is not installed: pip install jax")

import jax.numpy as jnp  # noqa: E402

import organza.jax  # noqa: E402


def test_a_gradient_is_the_native_one(renderer, scene, cameras, tiles, slopes):
    tensors = {name: jnp.array(values) for name, values in scene.tensors().items()}
    render = organza.jax.render(scene.config, cameras, tiles, renderer)
    assert np.array_equal(render(tensors), renderer.render(scene, cameras, tiles))
    found = jax.jit(jax.grad(lambda tensors: (render(tensors) * slopes).sum()))(tensors)
    expected = renderer.gradient(scene, cameras, tiles, slopes)
    for name, values in expected.items():
        assert np.array_equal(found[name], values), name
