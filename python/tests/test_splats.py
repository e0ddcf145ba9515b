"""Files for viewers that sort: what another project's reader finds in them, rendered by a few lines of numpy."""

import gzip
import json
import subprocess
import sys

import numpy as np
import pytest

import organza

SIDE = 48


def harmonics(direction):
    """Up to degree 3, as the code of 3D Gaussian splatting has them."""
    x, y, z = direction.T
    c2 = [1.0925484305920792, -1.0925484305920792, 0.31539156525252005, -1.0925484305920792, 0.5462742152960396]
    c3 = [
        -0.5900435899266435, 2.890611442640554, -0.4570457994644658, 0.3731763325901154,
        -0.4570457994644658, 1.445305721320277, -0.5900435899266435,
    ]  # fmt: skip
    c1 = 0.4886025119029199
    return np.stack([
        np.full_like(x, 0.28209479177387814), -c1 * y, c1 * z, -c1 * x,
        c2[0] * x * y, c2[1] * y * z, c2[2] * (2 * z * z - x * x - y * y), c2[3] * x * z, c2[4] * (x * x - y * y),
        c3[0] * y * (3 * x * x - y * y), c3[1] * x * y * z, c3[2] * y * (4 * z * z - x * x - y * y),
        c3[3] * z * (2 * z * z - 3 * x * x - 3 * y * y), c3[4] * x * (4 * z * z - x * x - y * y),
        c3[5] * z * (x * x - y * y), c3[6] * x * (x * x - 3 * y * y),
    ], axis=1)  # fmt: skip


def rotations(quaternion):
    w, x, y, z = (quaternion / np.linalg.norm(quaternion, axis=1, keepdims=True)).T
    return np.stack([
        1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
        2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
        2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y),
    ], axis=1).reshape(-1, 3, 3)  # fmt: skip


def sorted_image(vertex, pose, k, background):
    """An image of `SIDE` x `SIDE` pixels as 3D Gaussian splatting renders it."""
    position = columns(vertex, "x", "y", "z").astype(np.float64)
    scale = np.exp(columns(vertex, "scale_0", "scale_1", "scale_2"))
    first = columns(vertex, "f_dc_0", "f_dc_1", "f_dc_2")[:, None]
    rest = columns(vertex, *(f"f_rest_{i}" for i in range(45))).reshape(-1, 3, 15).transpose(0, 2, 1)
    opacity = 1 / (1 + np.exp(-vertex["opacity"].astype(np.float64)))
    to_camera = np.diag([1.0, -1.0, -1.0]) @ pose[:3, :3].T
    offset = position - pose[:3, 3]
    local = offset @ to_camera.T
    direction = offset / np.linalg.norm(offset, axis=1, keepdims=True)
    color = 0.5 + np.einsum("nh,nhc->nc", harmonics(direction), np.concatenate([first, rest], axis=1))
    axes = rotations(columns(vertex, "rot_0", "rot_1", "rot_2", "rot_3")) * scale[:, None]
    image, light = np.zeros((SIDE, SIDE, 3)), np.ones((SIDE, SIDE))
    x, y = np.meshgrid(np.arange(SIDE) + 0.5, np.arange(SIDE) + 0.5)
    for i in np.argsort(local[:, 2], kind="stable"):
        px, py, depth = local[i]
        if depth < 0.2:
            continue
        jacobian = np.array([
            [k[0, 0] / depth, 0, -k[0, 0] * px / depth**2], [0, k[1, 1] / depth, -k[1, 1] * py / depth**2],
        ])  # fmt: skip
        half = jacobian @ to_camera @ axes[i]
        conic = np.linalg.inv(half @ half.T + 0.3 * np.eye(2))
        dx, dy = x - (k[0, 0] * px / depth + k[0, 2]), y - (k[1, 1] * py / depth + k[1, 2])
        power = -0.5 * (conic[0, 0] * dx * dx + 2 * conic[0, 1] * dx * dy + conic[1, 1] * dy * dy)
        alpha = np.minimum(0.99, opacity[i] * np.exp(power))
        alpha[alpha < 1 / 255] = 0
        image += (light * alpha)[..., None] * np.maximum(color[i], 0)
        light *= 1 - alpha
    return image + light[..., None] * background


@pytest.fixture(scope="module")
def files(tmp_path_factory, renderer):
    """500 Gaussians of the built-in scene, large enough to cover it, as every kind of file."""
    folder = tmp_path_factory.mktemp("splats")
    whole = organza.Scene.built_in()
    some = {
        name: values[::64] if name.startswith("gaussians.") else values
        for name, values in whole.tensors().items()
    }
    some["gaussians.log_scale"] = some["gaussians.log_scale"] + 1.3
    scene = organza.Scene.from_tensors(some, whole.config)
    cameras = organza.Cameras.turntable(16, SIDE)
    found = {}
    steps = {"fitted.ply": 100, "first.ply": 0, "first.spz": 0, "first.splat": 0, "first.glb": 0}
    for name, count in steps.items():
        found[name] = organza.export(scene, folder / name, cameras, steps=count, renderer=renderer)
    organza.export(scene, folder / "old.spz", cameras, steps=0, spz_version=2, renderer=renderer)
    return folder, scene, cameras, found


def read_ply(path):
    plyfile = pytest.importorskip("plyfile", reason="plyfile is not installed")
    return plyfile.PlyData.read(path)


def columns(vertex, *names):
    return np.stack([vertex[name] for name in names], axis=1)


def positions(scene):
    """Where the Gaussians lie in the world: `offset + scale R own`, as `config["placement"]` says."""
    placement = scene.config.get("placement")
    own = scene.tensors()["gaussians.position"].astype(np.float64)
    if placement is None:
        return own
    up, right = np.array(placement["up"]), np.array(placement["right"])
    rotation = np.stack([right, np.cross(up, right), up], axis=1)
    return placement["offset"] + placement["scale"] * own @ rotation.T


def decibels(images, truth):
    """The mean PSNR of images of 8 bits, as they are shown."""
    images, truth = (np.round(255 * np.clip(np.asarray(values, np.float64), 0, 1)) / 255 for values in (images, truth))
    return np.mean(-10 * np.log10(np.mean((images - truth) ** 2, axis=(1, 2, 3))))


# of 16 views, those that a fit has not seen
HELD_OUT = [4, 12]


def sorted_images(vertex, cameras, background):
    return [sorted_image(vertex, pose, k, np.array(background)) for pose, k in zip(cameras.poses, cameras.Ks, strict=True)]


def test_other_programs_read_the_ply(files, renderer):
    folder, scene, cameras, found = files
    ply = read_ply(folder / "fitted.ply")
    assert [element.name for element in ply.elements] == ["vertex"]
    vertex = ply["vertex"]
    names = ["x", "y", "z", "nx", "ny", "nz", *(f"f_dc_{i}" for i in range(3)), *(f"f_rest_{i}" for i in range(45)),
             "opacity", *(f"scale_{i}" for i in range(3)), *(f"rot_{i}" for i in range(4))]  # fmt: skip
    assert [p.name for p in vertex.properties] == names

    # what numpy renders is as close to the scene as the result says
    fitted = found["fitted.ply"]
    assert fitted.gaussians == len(vertex) and fitted.psnr > fitted.first_psnr + 2
    assert fitted.first_psnr == found["first.ply"].first_psnr and fitted.scene_psnr is None
    images = sorted_images(vertex, cameras[HELD_OUT], scene.config["background"])
    close = decibels(images, renderer.render(scene, cameras[HELD_OUT]))
    assert abs(close - fitted.psnr) < 0.2, (close, fitted)


def test_a_file_has_the_bits_of_the_program(files, program):
    folder, scene, cameras, _ = files
    scene.save(folder / "scene.safetensors")
    cameras.save(folder / "cameras.json")
    words = ["export", "scene.safetensors", "cameras.json", "-o", "program.ply", "--steps", "0", "--backend", "cpu"]
    subprocess.run([program, *words], cwd=folder, capture_output=True, check=True)
    assert (folder / "program.ply").read_bytes() == (folder / "first.ply").read_bytes()


def test_a_file_is_compared_with_photographs(files, renderer, tmp_path):
    scene = files[1]
    dataset = organza.Dataset.built_in(renderer, views=4, side=SIDE, hold_out_every=4)
    path, held_out = tmp_path / "scene.ply", dataset.held_out
    found = organza.export(scene, path, dataset, steps=0, renderer=renderer)
    truth, cameras = [dataset.image(view) for view in held_out], dataset.cameras[held_out]
    assert abs(decibels(renderer.render(scene, cameras), truth) - found.scene_psnr) < 0.05
    images = sorted_images(read_ply(path)["vertex"], cameras, scene.config["background"])
    assert abs(decibels(images, truth) - found.file_psnr) < 0.05


def test_a_file_becomes_a_scene(files, renderer):
    folder, _, cameras, _ = files
    vertex = read_ply(folder / "first.ply")["vertex"]
    imported = organza.import_splats(folder / "first.ply", cameras, steps=3, background="white", renderer=renderer)
    scene = imported.scene
    assert len(scene) == len(vertex) and scene.config["background"] == [1, 1, 1]
    # so few steps hardly move them
    assert np.abs(positions(scene) - columns(vertex, "x", "y", "z")).max() < 0.01
    truth = sorted_images(vertex, cameras[HELD_OUT], [1, 1, 1])
    close = decibels(renderer.render(scene, cameras[HELD_OUT]), truth)
    assert abs(close - imported.psnr) < 0.2, (close, imported)
    viewmats = cameras[:2].viewmats
    viewmats[:, :3, 3] *= 20
    far = organza.Cameras.from_matrices(viewmats, cameras[:2].Ks, *cameras.sizes[0])
    with pytest.warns(UserWarning, match="of the pixels"):
        organza.import_splats(folder / "first.ply", far, steps=1, renderer=renderer)
    for name in ["first.spz", "old.spz", "first.splat", "first.glb"]:
        scene = organza.import_splats(folder / name, cameras, steps=1, renderer=renderer).scene
        x = np.sort(positions(scene)[:, 0])
        assert np.abs(x - np.sort(vertex["x"])).max() < 0.01, name


def test_bad_files_and_options_are_refused(files, renderer, tmp_path):
    folder, scene, cameras, _ = files
    refused = {
        "ending of the file": lambda: organza.export(scene, tmp_path / "scene.obj", renderer=renderer),
        "needs a camera": lambda: organza.export(scene, tmp_path / "scene.ply", cameras[[]], renderer=renderer),
        "`side` is 8, expected 16": lambda: organza.export(scene, tmp_path / "scene.ply", cameras, side=8, renderer=renderer),
        "`steps` is 0, expected 1": lambda: organza.import_splats(folder / "first.ply", steps=0, renderer=renderer),
        "`background`": lambda: organza.import_splats(folder / "first.ply", background=[0, 0, 2], renderer=renderer),
        "`spz_version` is 3": lambda: organza.export(scene, tmp_path / "scene.spz", cameras, spz_version=3, renderer=renderer),
        "no file of Gaussians": lambda: organza.import_splats(__file__, renderer=renderer),
    }
    for message, call in refused.items():
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(FileNotFoundError, match="nowhere"):
        organza.export(scene, tmp_path / "nowhere" / "scene.ply", renderer=renderer)
    assert not list(tmp_path.iterdir())


def test_control_c_keeps_the_old_file(tmp_path):
    path = tmp_path / "scene.ply"
    path.write_text("old")
    code = f"""
import os, signal, threading
import organza
# a shell that starts this in the background ignores Ctrl-C
signal.signal(signal.SIGINT, signal.default_int_handler)
renderer, scene = organza.Renderer("cpu", threads=1), organza.Scene.built_in()
try:
    threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
    organza.export(scene, {str(path)!r}, organza.Cameras.turntable(2, 16), steps=10000, side=16, renderer=renderer)
except KeyboardInterrupt:
    print("interrupted")
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300, check=False)
    assert found.stdout.strip() == "interrupted", found.stderr
    assert path.read_text() == "old" and len(list(tmp_path.iterdir())) == 1


def test_an_spz_is_the_ply_rounded(files):
    folder = files[0]
    vertex = read_ply(folder / "first.ply")["vertex"]
    count = len(vertex)
    header = (folder / "first.spz").read_bytes()[:32]
    assert header[:4] == b"NGSP" and list(np.frombuffer(header[4:12], "<u4")) == [4, count]
    packed = gzip.decompress((folder / "old.spz").read_bytes())
    assert packed[:4] == b"NGSP" and list(np.frombuffer(packed[4:12], "<u4")) == [2, count]
    degree, fraction = packed[12:14]
    assert degree == 3 and len(packed) == 16 + count * (9 + 1 + 3 + 3 + 3 + 45)
    data = np.frombuffer(packed, np.uint8)[16:].astype(np.int64)
    fixed, data = data[: 9 * count].reshape(-1, 3, 3), data[9 * count :]
    fixed = fixed @ [1, 1 << 8, 1 << 16]
    fixed = np.where(fixed >= 1 << 23, fixed - (1 << 24), fixed) / 2**fraction
    assert np.abs(fixed - columns(vertex, "x", "y", "z")).max() <= 1e-5
    opacity = 255 / (1 + np.exp(-vertex["opacity"].astype(np.float64)))
    assert np.abs(data[:count] - opacity).max() <= 0.51
    color = data[count : 4 * count].reshape(-1, 3)
    first = columns(vertex, "f_dc_0", "f_dc_1", "f_dc_2")
    assert np.abs(np.clip(first * 0.15 * 255 + 127.5, 0, 255) - color).max() <= 0.51
    scale = data[4 * count : 7 * count].reshape(-1, 3) / 16 - 10
    assert np.abs(scale - columns(vertex, "scale_0", "scale_1", "scale_2")).max() <= 0.5 / 16 + 1e-6
    rest = (data[10 * count :].reshape(-1, 15, 3) - 128) / 128
    exact = columns(vertex, *(f"f_rest_{i}" for i in range(45))).reshape(-1, 3, 15).transpose(0, 2, 1)
    inside = np.abs(exact) < 0.9
    assert np.abs(rest - exact)[inside].max() <= 8.6 / 128


def test_a_glb_has_the_values_of_the_ply(files):
    folder = files[0]
    vertex = read_ply(folder / "first.ply")["vertex"]
    whole = (folder / "first.glb").read_bytes()
    length = int.from_bytes(whole[12:16], "little")
    gltf, binary = json.loads(whole[20 : 20 + length]), whole[28 + length :]
    attributes = gltf["meshes"][0]["primitives"][0]["attributes"]

    def array(name, width):
        accessor = gltf["accessors"][attributes[name]]
        view = gltf["bufferViews"][accessor["bufferView"]]
        return np.frombuffer(binary, "<f4", accessor["count"] * width, view["byteOffset"]).reshape(-1, width)

    own = "KHR_gaussian_splatting:"
    assert np.array_equal(array("POSITION", 3), columns(vertex, "x", "y", "z"))
    assert np.array_equal(array(own + "ROTATION", 4), columns(vertex, "rot_1", "rot_2", "rot_3", "rot_0"))
    scale = np.exp(columns(vertex, "scale_0", "scale_1", "scale_2"))
    assert np.allclose(array(own + "SCALE", 3), scale, rtol=1e-5)
    opacity = 1 / (1 + np.exp(-vertex["opacity"]))
    assert np.allclose(array(own + "OPACITY", 1)[:, 0], opacity, rtol=1e-5)
    # order 2 of degree 3 is the last but one of 15
    last = columns(vertex, *(f"f_rest_{13 + 15 * channel}" for channel in range(3)))
    assert np.array_equal(array(own + "SH_DEGREE_3_COEF_5", 3), last)


def test_a_splat_file_has_one_color(files):
    folder = files[0]
    vertex = read_ply(folder / "first.ply")["vertex"]
    splat = np.frombuffer((folder / "first.splat").read_bytes(), np.uint8).reshape(-1, 32)
    place = splat[:, :12].copy().view("<f4")
    order = [np.lexsort(values.T) for values in (place, columns(vertex, "x", "y", "z"))]
    splat, vertex = splat[order[0]], vertex[order[1]]
    size = splat[:, 12:24].copy().view("<f4")
    assert np.allclose(size, np.exp(columns(vertex, "scale_0", "scale_1", "scale_2")), rtol=1e-5)
    color = 0.5 + 0.28209479 * columns(vertex, "f_dc_0", "f_dc_1", "f_dc_2")
    assert np.abs(np.clip(255 * color, 0, 255) - splat[:, 24:27]).max() <= 0.51
    opacity = 255 / (1 + np.exp(-vertex["opacity"].astype(np.float64)))
    assert np.abs(opacity - splat[:, 27]).max() <= 0.51
