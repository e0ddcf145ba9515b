"""Rendering as a differentiable function of JAX's arrays.

    tensors = {name: jnp.array(values) for name, values in scene.tensors().items()}
    render = organza.jax.render(scene.config, cameras, tiles)
    loss = lambda tensors: ((render(tensors) - photographs) ** 2).mean()
    slopes = jax.grad(loss)(tensors)

It works under `jax.jit`; values pass through the CPU's memory. The backward pass renders again.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from . import _organza
from ._cameras import Cameras, Tiles
from ._renderer import Renderer

__all__ = ["render"]

Tensors = dict[str, jax.Array]


def render(
    config: Mapping[str, Any], cameras: Cameras, tiles: Tiles, renderer: Renderer | None = None
) -> Callable[[Tensors], jax.Array]:
    """A function from a scene's tensors, by the names of its file, to the tiles `[K, 3, S, S]`, as `float32`.

    `config` is the scene's: `Scene.config`. The function has a gradient for every tensor, once: a second derivative fails.
    """
    device = renderer or Renderer()
    shape = (len(tiles), 3, tiles.side, tiles.side)

    def scene(tensors: Mapping[str, Any]) -> _organza.Scene:
        return _organza.Scene.from_tensors({name: np.asarray(t) for name, t in tensors.items()}, config)

    def forward_on_host(tensors: Mapping[str, Any]) -> np.ndarray:
        return device.render(scene(tensors), cameras, tiles)

    def backward_on_host(tensors: Mapping[str, Any], grad_tiles: Any) -> dict[str, np.ndarray]:
        found = device.gradient(scene(tensors), cameras, tiles, np.asarray(grad_tiles))
        # JAX would keep views of one block of memory
        return {name: np.array(found[name]) for name in tensors}

    @jax.custom_vjp
    def tiles_of(tensors: Tensors) -> jax.Array:
        return jax.pure_callback(forward_on_host, jax.ShapeDtypeStruct(shape, jnp.float32), tensors)

    def forward(tensors: Tensors) -> tuple[jax.Array, Tensors]:
        return tiles_of(tensors), tensors

    def backward(tensors: Tensors, grad_tiles: jax.Array) -> tuple[Tensors]:
        like = {name: jax.ShapeDtypeStruct(t.shape, jnp.float32) for name, t in tensors.items()}
        return (jax.pure_callback(backward_on_host, like, tensors, grad_tiles),)

    tiles_of.defvjp(forward, backward)
    return tiles_of
