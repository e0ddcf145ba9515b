"""Rendering as a differentiable function of torch's tensors.

    scene = organza.torch.Scene(organza.Scene.built_in())
    images = scene(cameras)  # [C, H, W, 3]
    (images - photographs).square().mean().backward()

Values and gradients pass through the CPU's memory: tensors of other devices are copied. The networks see positions and directions as
constants: position, rotation and scale have the gradient of the projection alone.
"""

from __future__ import annotations

import weakref
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import torch
from torch.autograd.function import once_differentiable

from . import _organza
from ._cameras import Cameras, Tiles
from ._images import whole
from ._renderer import Channel, Renderer, one_size

__all__ = ["Fields", "Scene", "rasterization"]

_GAUSSIANS = "gaussians."


class _Place:
    """A scene on the device that tensors are written to, again and again."""

    def __init__(self, renderer: Renderer, scene: _organza.Scene) -> None:
        self.renderer, self.scene = renderer, renderer.upload(scene)
        self._seen: dict[str, tuple[weakref.ref[torch.Tensor], int]] = {}
        # those that wait for their backward pass
        self._pending: weakref.WeakSet[_organza.Tape] = weakref.WeakSet()

    def holds(self, tensors: Mapping[str, torch.Tensor]) -> bool:
        """Whether these tensors were written last, and have not changed since."""

        def has(name: str, tensor: torch.Tensor) -> bool:
            reference, version = self._seen.get(name, (None, 0))
            return reference is not None and reference() is tensor and version == tensor._version

        return all(has(name, tensor) for name, tensor in tensors.items())

    def is_free(self) -> bool:
        """Whether no tape of it waits for its backward pass."""
        return not self._pending

    def write(self, tensors: Mapping[str, torch.Tensor]) -> None:
        self._seen = {}
        self.scene.write({name: _array(tensor) for name, tensor in tensors.items()})
        self.see(tensors)

    def see(self, tensors: Mapping[str, torch.Tensor]) -> None:
        self._seen = {name: (weakref.ref(t), t._version) for name, t in tensors.items()}

    def record(self, cameras: Cameras, tiles: Tiles, channels: Sequence[Channel]) -> _organza.Tape:
        tape = self.renderer.record(self.scene, cameras, tiles, channels)
        self._pending.add(tape)
        return tape

    def end(self, tape: _organza.Tape) -> None:
        """The tape's backward pass is over. Another one renders again."""
        tape.release()
        self._pending.discard(tape)


class _Places:
    """The scenes of one shape on a device: as many as there are tapes that wait."""

    def __init__(self, renderer: Renderer, config: Mapping[str, Any]) -> None:
        self.renderer, self.config = renderer, config
        self._places: list[_Place] = []

    def place(self, tensors: Mapping[str, torch.Tensor]) -> _Place:
        for place in self._places:
            if not place.is_free() and place.holds(tensors):
                return place
        gaussians = len(tensors[_GAUSSIANS + "position"])
        # scenes of another number of Gaussians are of no use anymore
        self._places = [place for place in self._places if len(place.scene) == gaussians]
        for place in self._places:
            if place.is_free():
                place.write(tensors)
                return place
        arrays = {name: _array(tensor) for name, tensor in tensors.items()}
        place = _Place(self.renderer, _organza.Scene.from_tensors(arrays, self.config))
        place.see(tensors)
        self._places.append(place)
        return place


def _array(tensor: torch.Tensor) -> np.ndarray:
    return tensor.detach().to("cpu", torch.float32).contiguous().numpy()


class _Render(torch.autograd.Function):
    """Y `[K, 3, S, S]`, then a tensor for each channel. `viewmats` are the cameras' own, or None."""

    @staticmethod
    def forward(ctx, places, cameras, tiles, channels, keep, names, viewmats, *tensors):
        place = places.place(dict(zip(names, tensors)))
        if keep:
            ctx.place, ctx.tape = place, place.record(cameras, tiles, channels)
            rendered, beside = ctx.tape.tiles()
        else:
            rendered, beside = place.renderer.render_tiles(
                place.scene, cameras._core, tiles._core, list(channels)
            )
        ctx.names, ctx.like = names, [(tensor.device, tensor.dtype) for tensor in tensors]
        # a copy: the caller may change theirs before the backward pass
        ctx.viewmats = None if viewmats is None else viewmats.detach().clone()
        device = tensors[0].device
        found = [torch.from_numpy(beside[name]).to(device) for name in channels]
        ctx.mark_non_differentiable(*found)
        return (torch.from_numpy(rendered).to(device), *found)

    @staticmethod
    @once_differentiable
    def backward(ctx, grad_tiles, *_):
        by_pose = None
        if ctx.needs_input_grad[6]:
            found, poses = ctx.tape.backward_with_poses(_array(grad_tiles))
            by_pose = _by_matrix(ctx.viewmats, poses)
        else:
            found = ctx.tape.backward(_array(grad_tiles))
        ctx.place.end(ctx.tape)
        gradients = [
            torch.from_numpy(found[name]).to(*like) if needed else None
            for name, like, needed in zip(ctx.names, ctx.like, ctx.needs_input_grad[7:])
        ]
        return None, None, None, None, None, None, by_pose, *gradients


def _by_matrix(viewmats: torch.Tensor, poses: np.ndarray) -> torch.Tensor:
    """The gradient by matrices `[C, 4, 4]` of one by poses `[C, 6]`, a rotation vector w and a shift v in a camera's space.

    A small motion changes a matrix (R, t) by dR = [w]x R and dt = w x t + v. With g = dL/dv and h = dL/dw - t x g, the gradient
    dL/dt = g and dL/dR = [h]x R / 2 gives dL/dw . w + dL/dv . v for all of these. It lies along the motions: changes that would shear or
    scale have none.
    """
    matrices = _matrices(viewmats)
    rotation, shift = matrices[:, :3, :3], matrices[:, :3, 3]
    turn, slope = np.split(poses.astype(np.float64), 2, axis=1)
    turn = turn - np.cross(shift, slope)
    gradient = np.zeros_like(matrices)
    # a column of [h]x R is the cross product of h and a column of R
    gradient[:, :3, :3] = 0.5 * np.cross(turn[:, :, None], rotation, axis=1)
    gradient[:, :3, 3] = slope
    return torch.from_numpy(gradient).to(viewmats.device, viewmats.dtype)


def _render(
    places: _Places,
    tensors: Mapping[str, torch.Tensor],
    cameras: Cameras,
    tiles: Tiles,
    channels: Sequence[Channel],
    viewmats: torch.Tensor | None = None,
) -> tuple[torch.Tensor, ...]:
    # in `forward` torch has switched gradients off
    wanted = [*tensors.values()] if viewmats is None else [viewmats, *tensors.values()]
    keep = torch.is_grad_enabled() and any(tensor.requires_grad for tensor in wanted)
    return _Render.apply(
        places, cameras, tiles, tuple(channels), keep, tuple(tensors), viewmats, *tensors.values()
    )


def _images(
    places: _Places,
    tensors: Mapping[str, torch.Tensor],
    cameras: Cameras,
    channels: Sequence[Channel],
    tile_size: int,
    viewmats: torch.Tensor | None = None,
) -> tuple[torch.Tensor, dict[str, torch.Tensor]]:
    width, height = one_size(cameras)
    tiles = Tiles.cover(cameras, tile_size)
    rendered, *beside = _render(places, tensors, cameras, tiles, channels, viewmats)
    images = whole(rendered, len(cameras), width, height)
    more = {name: whole(values, len(cameras), width, height) for name, values in zip(channels, beside)}
    return images, more


class Scene(torch.nn.Module):
    """A scene whose tensors are parameters. `Scene.load(path)` of organza, or any other, begins it."""

    def __init__(self, scene: _organza.Scene, renderer: Renderer | None = None) -> None:
        super().__init__()
        self.config = scene.config
        self._names = tuple(scene.tensors())
        self._places = _Places(renderer or Renderer(), self.config)
        for name, values in scene.tensors().items():
            parameter = torch.nn.Parameter(torch.from_numpy(np.array(values)))
            self.register_parameter(_attribute(name), parameter)

    def tensors(self) -> dict[str, torch.nn.Parameter]:
        """The parameters by the names of a scene's file, such as "gaussians.position"."""
        return {name: getattr(self, _attribute(name)) for name in self._names}

    def forward(self, cameras: Cameras, tiles: Tiles | None = None, tile_size: int = 64) -> torch.Tensor:
        """Whole images `[C, H, W, 3]`, or the tiles of a batch `[K, 3, S, S]`. Values are not clamped."""
        if tiles is None:
            return _images(self._places, self.tensors(), cameras, (), tile_size)[0]
        return _render(self._places, self.tensors(), cameras, tiles, ())[0]

    def to_scene(self) -> _organza.Scene:
        """A copy as organza's scene, to save and to render."""
        arrays = {name: _array(tensor) for name, tensor in self.tensors().items()}
        return _organza.Scene.from_tensors(arrays, self.config)


def _attribute(name: str) -> str:
    # a module's parameters have no dots
    return name.replace(".", "__")


class Fields(torch.nn.Module):
    """The two fields of a scene, color and transmittance, as parameters: what `rasterization` takes beside the Gaussians."""

    def __init__(self, scene: _organza.Scene, renderer: Renderer | None = None) -> None:
        super().__init__()
        self.config = scene.config
        self._places = _Places(renderer or Renderer(), self.config)
        self._names = tuple(name for name in scene.tensors() if not name.startswith(_GAUSSIANS))
        for name in self._names:
            parameter = torch.nn.Parameter(torch.from_numpy(np.array(scene.tensors()[name])))
            self.register_parameter(_attribute(name), parameter)

    def tensors(self) -> dict[str, torch.nn.Parameter]:
        """The parameters by the names of a scene's file, such as "color.grid"."""
        return {name: getattr(self, _attribute(name)) for name in self._names}


def rasterization(
    means: torch.Tensor,
    quats: torch.Tensor,
    scales: torch.Tensor,
    opacities: torch.Tensor,
    materials: torch.Tensor,
    extras: torch.Tensor,
    fields: Fields,
    viewmats: torch.Tensor,
    Ks: torch.Tensor,
    width: int,
    height: int,
    *,
    slopes: torch.Tensor | None = None,
    shapes: torch.Tensor | None = None,
    channels: Sequence[Channel] = (),
    tile_size: int = 64,
) -> tuple[torch.Tensor, torch.Tensor, dict[str, Any]]:
    """Renders Gaussians as `gsplat.rasterization` does: the arguments that mean the same have the same names and layouts.

    | argument | shape | |
    | --- | --- | --- |
    | `means` | `[N, 3]` | centers, world units |
    | `quats` | `[N, 4]` | rotations w x y z, not normalized |
    | `scales` | `[N, 3]` | along the rotated axes, world units, positive |
    | `opacities` | `[N]` | between 0 and 1 |
    | `materials` | `[N, material]` | in the place of gsplat's `colors`: what the color network takes |
    | `extras` | `[N, extra]` | what the transmittance network takes |
    | `slopes` | `[N, 9]` | how colors grow per standard deviation along each axis, where the scene has slopes |
    | `shapes` | `[N, 1]` | how flat falloffs are: 0 for a Gaussian's, where the scene has shapes |
    | `fields` | | both networks with their hash grids |
    | `viewmats` | `[C, 4, 4]` | world to camera, OpenCV's axes |
    | `Ks` | `[C, 3, 3]` | intrinsics in pixels |

    Returns the images `[C, height, width, 3]`, the sum of the weights `[C, height, width, 1]` (S of Eq. 12; it can exceed 1 and has no
    gradient), and a dictionary with the `channels` that were asked for, `[C, height, width, planes]`, which have none either. The scene's
    background shows through where the weight is below 1. All but `Ks` have gradients: of `viewmats` along the motions of rigid cameras,
    through the projection alone: the networks see a camera's center as a constant.

    Raises `ValueError` where a shape is wrong, or a value is not finite: an opacity of 0 or 1, or a scale of 0, has no logit or logarithm.
    """
    tensors = {
        _GAUSSIANS + "position": means,
        _GAUSSIANS + "rotation": quats,
        _GAUSSIANS + "log_scale": scales.log(),
        _GAUSSIANS + "opacity": opacities.logit(),
        _GAUSSIANS + "material": materials,
        _GAUSSIANS + "extra": extras,
        **({} if slopes is None else {_GAUSSIANS + "slope": slopes}),
        **({} if shapes is None else {_GAUSSIANS + "shape": shapes}),
        **fields.tensors(),
    }
    cameras = Cameras.from_matrices(_matrices(viewmats), _matrices(Ks), width, height)
    wanted = tuple(dict.fromkeys(("alpha", *channels)))
    images, beside = _images(fields._places, tensors, cameras, wanted, tile_size, viewmats)
    meta = {name: beside[name] for name in channels}
    return images, beside["alpha"], meta


def _matrices(tensor: torch.Tensor) -> np.ndarray:
    return np.asarray(tensor.detach().to("cpu", torch.float64))
