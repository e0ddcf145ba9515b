"""Gradients through torch."""

import json
from pathlib import Path

import numpy as np
import pytest

import organza

torch = pytest.importorskip("torch", reason="torch is not installed: pip install torch")

import organza.torch  # noqa: E402

# a logit whose logistic function is 1 in float32
OPEN = 40.0
CASES = Path(__file__).parents[2] / "tests" / "cases"
REFERENCE = sorted(path.parent.name for path in CASES.glob("*/expected.safetensors"))


def read_safetensors(path):
    """A file's tensors: a header of JSON, and the values."""
    data = path.read_bytes()
    length = int.from_bytes(data[:8], "little")
    header = json.loads(data[8 : 8 + length])
    kinds = {"F32": np.float32, "F64": np.float64, "U32": np.uint32, "I32": np.int32}
    tensors = {}
    for name, entry in header.items():
        if name != "__metadata__" and entry["dtype"] in kinds:
            begin, end = (8 + length + offset for offset in entry["data_offsets"])
            values = np.frombuffer(data[begin:end], kinds[entry["dtype"]])
            tensors[name] = values.reshape(entry["shape"])
    return tensors


@pytest.mark.parametrize("name", REFERENCE)
def test_autograd_gives_the_gradients_of_the_float64_reference(renderer, name):
    case = CASES / name
    expected = read_safetensors(case / "expected.safetensors")
    scene = organza.torch.Scene(organza.Scene.load(case / "scene.safetensors"), renderer)
    cameras, tiles = organza.Cameras.load(case / "cameras.json"), organza.Tiles.load(case / "tiles.json")
    slopes = torch.from_numpy(expected["grad_tiles"].astype(np.float32))
    (scene(cameras, tiles) * slopes).sum().backward()
    compared = 0
    for tensor, parameter in scene.tensors().items():
        if parameter.numel() == 0:
            continue
        truth = expected[f"grad.{tensor}"].astype(np.float64)
        error = np.linalg.norm(parameter.grad.numpy() - truth)
        assert error <= 1e-3 * np.linalg.norm(truth) + 1e-12, tensor
        compared += 1
    assert compared > 10


def test_gradients_are_the_bits_of_the_native_call(renderer, scene, cameras, tiles, slopes):
    module = organza.torch.Scene(scene, renderer)
    rendered = module(cameras, tiles)
    assert np.array_equal(rendered.detach().numpy(), renderer.render(scene, cameras, tiles))
    rendered.backward(torch.from_numpy(slopes), retain_graph=True)
    expected = renderer.gradient(scene, cameras, tiles, slopes)
    for name, parameter in module.tensors().items():
        assert np.array_equal(parameter.grad.numpy(), expected[name]), name
    # of a graph that was retained
    rendered.backward(torch.from_numpy(slopes))
    opacity = module.tensors()["gaussians.opacity"].grad.numpy()
    assert np.array_equal(opacity, 2 * expected["gaussians.opacity"])


def activated(scene):
    tensors = {name: torch.from_numpy(np.array(v)) for name, v in scene.tensors().items()}
    short = {name.removeprefix("gaussians."): values for name, values in tensors.items()}
    arguments = {
        "means": short["position"],
        "quats": short["rotation"],
        "scales": short["log_scale"].exp(),
        "opacities": short["opacity"].sigmoid(),
        "materials": short["material"],
        "extras": short["extra"],
    }
    return {name: values.requires_grad_() for name, values in arguments.items()}


def test_rasterization_has_the_pictures_and_slopes_of_the_scene(renderer, scene, cameras):
    fields = organza.torch.Fields(scene, renderer)
    arguments = activated(scene)
    viewmats, Ks = torch.from_numpy(cameras.viewmats), torch.from_numpy(cameras.Ks)
    image, weight, meta = organza.torch.rasterization(
        **arguments, fields=fields, viewmats=viewmats, Ks=Ks, width=40, height=40, channels=["depth"]
    )
    assert image.shape == (2, 40, 40, 3) and weight.shape == (2, 40, 40, 1)
    assert meta["depth"].shape == (2, 40, 40, 1) and not weight.requires_grad
    expected, beside = renderer.render_channels(scene, cameras)
    assert np.abs(image.detach().numpy() - expected).max() < 1e-3
    assert np.abs(weight.numpy() - beside["alpha"]).max() < 1e-3

    target = torch.from_numpy(np.asarray(expected)) + 0.1
    (image - target).square().mean().backward()
    module = organza.torch.Scene(scene, renderer)
    (module(cameras) - target).square().mean().backward()
    raw = {name: tensor.grad for name, tensor in module.tensors().items()}
    means, scales, opacities = (arguments[name] for name in ("means", "scales", "opacities"))
    # the chain rule of exp and of the logistic function
    pairs = [
        (means.grad, raw["gaussians.position"]),
        (scales.grad * scales, raw["gaussians.log_scale"]),
        (opacities.grad * opacities * (1 - opacities), raw["gaussians.opacity"]),
        (fields.tensors()["color.grid"].grad, raw["color.grid"]),
    ]
    for found, truth in pairs:
        assert torch.linalg.norm(truth) > 0
        assert torch.linalg.norm(found - truth) <= 5e-3 * torch.linalg.norm(truth)


def without_directions(scene):
    """The scene with one color and full transmittance for each Gaussian, from wherever it is seen: what a camera's center changes is then
    the projection alone."""
    tensors = {name: np.array(values) for name, values in scene.tensors().items()}
    last = max(name for name in tensors if name.startswith("transmittance.mlp") and name.endswith("bias"))
    for name, values in tensors.items():
        if not name.startswith("gaussians."):
            values[...] = 0
    tensors[last][...] = OPEN
    return organza.Scene.from_tensors(tensors, scene.config)


def test_rasterization_has_the_slopes_of_poses(renderer, scene, cameras):
    plain = without_directions(scene)
    fields = organza.torch.Fields(plain, renderer)
    # a few that reach beyond the image, for a derivative does not see the ends of a Gaussian's support; their weights add up to less than 1
    arguments = {name: tensor.detach()[::170] for name, tensor in activated(plain).items()}
    arguments["means"] = 0.5 * arguments["means"]
    arguments["scales"] = 1.8 + 0.4 * torch.sin(torch.arange(36.0).reshape(12, 3))
    arguments["opacities"] = torch.full((12,), 0.05)
    Ks = torch.from_numpy(cameras.Ks)
    # a smooth loss, whose slopes differ from pixel to pixel
    y, x = np.mgrid[:40, :40] / 40
    slopes = np.stack([np.sin(3 * x + channel) * np.cos(4 * y + channel) for channel in range(3)], axis=2)
    slopes = torch.from_numpy(np.stack([slopes, slopes[::-1]]).astype(np.float32))

    def loss(motions):
        """`motions [C, 6]` are rotation vectors and shifts in the cameras' spaces."""
        w, v = motions[:, :3], motions[:, 3:]
        zero = torch.zeros_like(w[:, 0])
        rows = [[zero, -w[:, 2], w[:, 1]], [w[:, 2], zero, -w[:, 0]], [-w[:, 1], w[:, 0], zero]]
        turn = torch.matrix_exp(torch.stack([torch.stack(row, 1) for row in rows], 1))
        bottom = torch.tensor([[[0.0, 0.0, 0.0, 1.0]]], dtype=torch.float64).expand(len(w), 1, 4)
        motion = torch.cat([torch.cat([turn, v[:, :, None]], 2), bottom], 1)
        viewmats = motion @ torch.from_numpy(cameras.viewmats)
        image, _, _ = organza.torch.rasterization(
            **arguments, fields=fields, viewmats=viewmats, Ks=Ks, width=40, height=40
        )
        return (image * slopes).double().sum()

    # where the motion is not 0, the chain rule goes through the matrices' rotations, too
    motions = torch.tensor([[0.0] * 6, [0.02, -0.01, 0.03, 0.05, -0.02, 0.04]], dtype=torch.float64, requires_grad=True)
    loss(motions).backward()
    step = 2e-3
    with torch.no_grad():
        for place in range(12):
            change = torch.zeros(12, dtype=torch.float64)
            change[place] = step
            change = change.reshape(2, 6)
            expected = float(loss(motions + change) - loss(motions - change)) / (2 * step)
            found = float(motions.grad.reshape(-1)[place])
            assert abs(found - expected) <= 1e-3 * float(motions.grad.abs().max()), (place, found, expected)


def test_a_camera_finds_back(renderer, scene, cameras):
    fields = organza.torch.Fields(scene, renderer)
    arguments = {name: tensor.detach() for name, tensor in activated(scene).items()}
    viewmats, Ks = torch.from_numpy(cameras.viewmats), torch.from_numpy(cameras.Ks)

    def image(viewmats):
        return organza.torch.rasterization(**arguments, fields=fields, viewmats=viewmats, Ks=Ks, width=40, height=40)[0]

    with torch.no_grad():
        target = image(viewmats)
    shift = torch.full((2, 3), 0.03, dtype=torch.float64, requires_grad=True)
    optimizer = torch.optim.Adam([shift], lr=4e-3)
    losses = []
    for _ in range(16):
        optimizer.zero_grad()
        moved = torch.cat([viewmats[:, :, :3], viewmats[:, :, 3:] + torch.cat([shift, torch.zeros(2, 1)], 1)[:, :, None]], 2)
        loss = (image(moved) - target).square().mean()
        loss.backward()
        optimizer.step()
        losses.append(float(loss.detach()))
    # depth has little to do with an image, so only the shifts across it must have become small
    assert losses[-1] < 0.2 * losses[0], losses
    assert shift.detach()[:, :2].abs().max() < 0.015, shift


def test_several_pictures_may_wait_for_one_backward_pass(renderer, scene, cameras):
    module = organza.torch.Scene(scene, renderer)
    losses = [module(camera).square().mean() for camera in cameras]
    sum(losses).backward()
    together = {name: t.grad.clone() for name, t in module.tensors().items()}
    module.zero_grad()
    for camera in cameras:
        module(camera).square().mean().backward()
    for name, tensor in module.tensors().items():
        assert torch.allclose(tensor.grad, together[name], rtol=1e-4, atol=1e-9), name
    # of another scene in between, too
    arguments, fields = activated(scene), organza.torch.Fields(scene, renderer)
    cases = [1.0, 0.5]
    images = []
    for factor in cases:
        changed = arguments | {"opacities": arguments["opacities"] * factor}
        image, _, _ = organza.torch.rasterization(
            **changed, fields=fields, viewmats=torch.from_numpy(cameras.viewmats), Ks=torch.from_numpy(cameras.Ks), width=40, height=40
        )
        images.append(image)
    sum(image.square().mean() for image in images).backward()
    assert arguments["opacities"].grad.abs().sum() > 0


def test_a_parameter_that_was_changed_is_rendered_changed(renderer, scene, cameras, tiles):
    module = organza.torch.Scene(scene, renderer)
    with torch.no_grad():
        before = module(cameras, tiles)
        module.tensors()["gaussians.opacity"].data.sub_(1.0)
        after = module(cameras, tiles)
    assert not torch.equal(before, after)
    assert np.array_equal(after.numpy(), renderer.render(module.to_scene(), cameras, tiles))


def test_an_optimizer_lowers_a_loss(renderer, scene, cameras):
    target = torch.from_numpy(np.array(renderer.render(scene, cameras)))
    module = organza.torch.Scene(scene, renderer)
    with torch.no_grad():
        module.tensors()["gaussians.opacity"] -= 1.0
        module.tensors()["color.grid"].zero_()
    optimizer = torch.optim.Adam(module.parameters(), lr=1e-2)
    losses = []
    for _ in range(8):
        optimizer.zero_grad()
        loss = (module(cameras) - target).square().mean()
        loss.backward()
        optimizer.step()
        losses.append(float(loss.detach()))
    assert losses[-1] < 0.7 * losses[0], losses


def test_bad_gradients_and_tensors_are_refused(renderer, scene, cameras, tiles):
    module = organza.torch.Scene(scene, renderer)
    opacity = module.tensors()["gaussians.opacity"]
    (slopes,) = torch.autograd.grad(module(cameras, tiles).square().sum(), opacity, create_graph=True)
    with pytest.raises(RuntimeError, match="once_differentiable|differentiate twice"):
        slopes.sum().backward()
    rendered = module(cameras, tiles).sum()
    stale = module(cameras, tiles).sum()
    stale.backward(retain_graph=True)
    rendered.backward()
    with torch.no_grad():
        opacity.add_(1.0)
    module(cameras, tiles).sum().backward()
    with pytest.raises(ValueError, match="record it again"):
        stale.backward()
    with torch.no_grad():
        opacity[0] = float("nan")
    with pytest.raises(ValueError, match="`gaussians.opacity` holds NaN"):
        module(cameras, tiles)
