"""Scenes, cameras, pictures and gradients, with numpy alone."""

import json
import os
import struct
import subprocess
import sys
import threading
import zlib
from pathlib import Path

import numpy as np
import pytest

import organza

def test_a_scene_survives_its_file_and_its_arrays(scene, tmp_path):
    path = tmp_path / "scene.safetensors"
    scene.save(path)
    loaded = organza.Scene.load(str(path))
    again = organza.Scene.from_tensors(loaded.tensors(), json.dumps(loaded.config))
    assert loaded.config == scene.config and len(again) == len(scene) > 50
    for name, values in scene.tensors().items():
        assert values.dtype == np.float32 and np.array_equal(values, again.tensors()[name])
    # they are the scene's own memory, and outlive its name
    arrays = loaded.tensors()
    before = arrays["color.grid"].copy()
    del loaded
    assert np.array_equal(arrays["color.grid"], before)
    with pytest.raises(ValueError, match="read-only"):
        arrays["color.grid"][0] = 1.0


def test_whole_images_are_made_of_tiles(renderer, scene, cameras, tiles):
    images = renderer.render(scene, cameras)
    assert images.shape == (2, 40, 40, 3) and images.dtype == np.float32 and images.std() > 0.01
    batch = renderer.render(scene, cameras, tiles)
    assert batch.shape == (3, 3, 16, 16)
    assert np.array_equal(batch[0].transpose(1, 2, 0), images[0, 10:26, 12:28])
    assert np.array_equal(batch[1].transpose(1, 2, 0), images[1, 16:32, 8:24])
    # a part of an odd image hangs over the edge
    odd = cameras.Ks, cameras.viewmats
    odd = organza.Cameras.from_matrices(odd[1], odd[0], 37, 33)
    assert np.array_equal(renderer.render(scene, odd), images[:, :33, :37])
    found, beside = renderer.render_channels(scene, cameras, channels=["alpha", "normal"])
    assert np.array_equal(found, images)
    assert beside["alpha"].shape == (2, 40, 40, 1) and beside["normal"].shape == (2, 40, 40, 3)
    # the background shows where no Gaussian has a weight
    empty = beside["alpha"][..., 0] == 0.0
    assert empty.any() and np.allclose(images[empty], scene.config["background"])


def test_cameras_of_matrices_match_the_file(renderer, scene, cameras, tmp_path):
    path = tmp_path / "cameras.json"
    cameras.save(path)
    loaded = organza.Cameras.load(path)
    assert np.array_equal(loaded.poses, cameras.poses) and loaded.sizes == [(40, 40)] * 2
    opencv = organza.Cameras.from_matrices(cameras.viewmats, cameras.Ks, 40, 40)
    opengl = np.linalg.inv(cameras.poses)
    opengl = organza.Cameras.from_matrices(opengl, cameras.Ks, 40, 40, convention="opengl")
    for found in (opencv, opengl):
        assert np.allclose(found.poses, cameras.poses, atol=1e-12)
        assert np.allclose(renderer.render(scene, found), renderer.render(scene, cameras), atol=1e-4)
    # a point in front of an OpenCV camera has a positive z, and lands at K [x/z, y/z, 1]
    center = np.append(np.mean(scene.tensors()["gaussians.position"], axis=0), 1.0)
    x, y, z, _ = cameras.viewmats[1] @ center
    u, v, _ = cameras.Ks[1] @ [x / z, y / z, 1.0]
    assert z > 0 and 0 < u < 40 and 0 < v < 40
    assert len(cameras[1]) == 1 and np.array_equal(cameras[1:].poses, cameras[1].poses)


def test_cameras_of_a_data_set_are_of_the_world(renderer, scene, cameras, tmp_path):
    renderer.render(scene, cameras[0]).save(tmp_path / "0.png")
    renderer.render(scene, cameras[1]).save(tmp_path / "1.png")
    path = tmp_path / "transforms.json"
    cameras.save(path)
    file = json.loads(path.read_text())
    for index, frame in enumerate(file["frames"]):
        frame["file_path"] = f"{index}.png"
        # far from the origin, and in a large unit: a scene would have coordinates of its own
        frame["transform_matrix"] = [[100 * x for x in row[:3]] + [1e4 * row[3]] for row in frame["transform_matrix"][:3]]
    path.write_text(json.dumps(file))
    loaded, expected = organza.Cameras.load(tmp_path), organza.Cameras.load(path)
    assert loaded.names == ["0.png", "1.png"] and loaded.sizes == [(40, 40)] * 2
    assert np.allclose(loaded.poses, expected.poses, rtol=1e-12)


def test_a_released_tape_has_the_same_gradients(renderer, scene, cameras, tiles, slopes):
    tape = renderer.record(scene, cameras, tiles)
    rendered, _ = tape.tiles()
    assert np.array_equal(rendered, renderer.render(scene, cameras, tiles))
    first = tape.backward(slopes)
    tape.release()
    again = tape.backward(slopes)
    assert list(first) == list(scene.tensors())
    for name, values in scene.tensors().items():
        assert first[name].shape == values.shape and np.array_equal(first[name], again[name])
        first[name] *= 2.0  # it is the caller's
    assert all(np.any(first[name] != 0.0) for name in ("gaussians.opacity", "color.grid"))


def test_a_gradient_is_a_finite_difference(renderer, scene, cameras, tiles, slopes):
    tensors = {name: values.astype(np.float64) for name, values in scene.tensors().items()}
    slope = renderer.gradient(scene, cameras, tiles, slopes)["gaussians.opacity"]
    device = renderer.upload(scene)

    def loss(opacity):
        device.write({"gaussians.opacity": opacity})
        return float((renderer.render(device, cameras, tiles).astype(np.float64) * slopes).sum())

    direction = np.sign(slope)
    opacity, step = tensors["gaussians.opacity"], 2e-2
    difference = (loss(opacity + step * direction) - loss(opacity - step * direction)) / (2 * step)
    assert difference == pytest.approx(float(np.abs(slope).sum()), rel=2e-3)


def test_a_scene_on_the_device_is_written_in_place(renderer, scene, cameras, tiles, slopes):
    device = renderer.upload(scene)
    tape = renderer.record(device, cameras, tiles)
    changed = {name: values * np.float32(0.9) for name, values in scene.tensors().items()}
    device.write(changed)
    for name, values in device.download().tensors().items():
        assert np.array_equal(values, changed[name]), name
    expected = organza.Scene.from_tensors(changed, scene.config)
    found = renderer.render(device, cameras, tiles)
    assert np.array_equal(found, renderer.render(expected, cameras, tiles))
    with pytest.raises(ValueError, match="record it again"):
        tape.backward(slopes)


def test_pictures_are_png(renderer, scene, cameras, tmp_path):
    images = renderer.render(scene, cameras)
    data = images._repr_png_()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    assert struct.unpack(">II", data[16:24]) == (80, 40)
    begin = data.index(b"IDAT") + 4
    length = struct.unpack(">I", data[begin - 8 : begin - 4])[0]
    rows = np.frombuffer(zlib.decompress(data[begin : begin + length]), np.uint8)
    rows = rows.reshape(40, 1 + 3 * 80)
    expected = np.concatenate([images[0], images[1]], axis=1)
    expected = np.round(np.clip(np.asarray(expected), 0, 1) * 255).reshape(40, -1)
    assert (rows[:, 0] == 0).all() and np.abs(rows[:, 1:] - expected).max() <= 1
    images[0].save(tmp_path / "one.png")
    assert (tmp_path / "one.png").read_bytes() == images[0]._repr_png_()
    assert images[0, 0]._repr_png_() is None


def test_a_scene_shows_itself(scene):
    png = scene._repr_png_()
    assert png.startswith(b"\x89PNG") and struct.unpack(">II", png[16:24]) == (360, 270)
    # not the background alone
    assert len(png) > 5000


@pytest.mark.parametrize(
    "call, error, text",
    [
        (lambda o: o.Scene.load("nowhere"), FileNotFoundError, "no such file"),
        (lambda o: o.Scene.load(__file__), ValueError, "safetensors"),
        (lambda o: o.Cameras.load("nowhere"), FileNotFoundError, "no such file"),
        (lambda o: o.load_dataset("nowhere"), FileNotFoundError, "nowhere"),
        (lambda o: o.Renderer("tpu"), ValueError, "expected `auto`, `gpu` or `cpu`"),
        (lambda o: o.Renderer("cpu", threads=0), ValueError, "at least 1"),
        (lambda o: o.Renderer("gpu", adapter="abacus"), organza.Error, "abacus"),
        (lambda o: o.Tiles(16, [[0.5, 0, 0]]), ValueError, "whole numbers"),
        (lambda o: o.Tiles(16, [[-1, 0, 0]]), ValueError, "out of range"),
        (lambda o: o.Cameras.from_matrices(np.zeros((1, 4, 4)), np.eye(3)[None], 8, 8), ValueError, "inverse"),
        (lambda o: o.Cameras.from_matrices(np.eye(4), np.eye(3), 8, 8), ValueError, r"expected \[C, 4, 4\]"),
        (lambda o: o.Cameras.from_matrices(2 * np.eye(4)[None], np.eye(3)[None], 8, 8), ValueError, "row|rotation"),
        (lambda o: o.Cameras.turntable(0, 8), ValueError, "1 to 100,000"),
        (lambda o: o.Cameras.turntable(4, 10**9), ValueError, "1 to 65536 pixels"),
        (lambda o: o.TrainConfig("slow"), ValueError, "no preset `slow`"),
        (lambda o: o.TrainConfig(settings={"run.stairs": 3}), ValueError, "stairs"),
        (lambda o: o.TrainConfig(settings={"run.steps": "many"}), ValueError, "steps"),
    ],
)
def test_mistakes_raise_the_errors_of_python(call, error, text):
    with pytest.raises(error, match=text):
        call(organza)


def test_wrong_arguments_of_a_call_are_named(renderer, scene, cameras, tiles):
    tensors = dict(scene.tensors())
    wrong = {"gaussians.opacity": np.zeros(3)}
    with pytest.raises(ValueError, match="`gaussians.opacity` has shape \\[3\\], expected"):
        organza.Scene.from_tensors(tensors | wrong, scene.config)
    with pytest.raises(ValueError, match="no tensor `gaussians.color`"):
        organza.Scene.from_tensors(tensors | {"gaussians.color": np.zeros(3)}, scene.config)
    with pytest.raises(ValueError, match="is missing"):
        organza.Scene.from_tensors({"gaussians.position": np.zeros((4, 3))}, scene.config)
    broken = np.full(len(scene), np.nan)
    with pytest.raises(ValueError, match="NaN at flat index 0"):
        renderer.upload(scene).write({"gaussians.opacity": broken})
    with pytest.raises(ValueError, match="cameras are 0 to 0"):
        renderer.render(scene, cameras[0], tiles)
    with pytest.raises(ValueError, match=r"expected \[3, 3, 16, 16\]"):
        renderer.gradient(scene, cameras, tiles, np.zeros((3, 3, 8, 8)))
    with pytest.raises(ValueError, match="another renderer"):
        renderer.render(organza.Renderer("cpu", threads=1).upload(scene), cameras)


def test_too_little_memory_is_an_exception():
    code = """
import resource
import organza
renderer = organza.Renderer("cpu", threads=1)
scene = renderer.upload(organza.Scene.built_in())
cameras, tiles = organza.Cameras.turntable(1, 64), organza.Tiles(2048, [[0, 0, 0]] * 80)
resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
try:
    renderer.render(scene, cameras, tiles)
except MemoryError as error:
    print("needs" in str(error))
"""
    # each thread reserves address space, and a machine may have many cores
    environment = os.environ | {"OPENBLAS_NUM_THREADS": "1", "RAYON_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    found = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=300)
    assert found.stdout.strip() == "True", found.stderr


def test_other_threads_run_while_a_batch_is_rendered(renderer, scene):
    cameras = organza.Cameras.turntable(24, 96)
    tiles = organza.Tiles.cover(cameras, 32)
    woken, done = [], threading.Event()
    thread = threading.Thread(target=lambda: [woken.append(1) for _ in iter(lambda: done.wait(0.002), True)])
    thread.start()
    renderer.render(scene, cameras, tiles)
    done.set()
    thread.join()
    assert len(woken) > 3


def test_control_c_interrupts_a_long_call():
    code = """
import os, signal, threading, time
import organza
# a shell that starts this in the background ignores Ctrl-C
signal.signal(signal.SIGINT, signal.default_int_handler)
renderer = organza.Renderer("cpu", threads=2)
scene = renderer.upload(organza.Scene.built_in())
cameras = organza.Cameras.turntable(64, 512)
tiles = organza.Tiles.cover(cameras, 64)
begin = time.monotonic()
try:
    threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    renderer.render(scene, cameras, tiles)
    print("it was rendered")
except KeyboardInterrupt:
    print("interrupted", time.monotonic() - begin < 30, flush=True)
# the thread of the call is still at work
os._exit(0)
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300)
    assert found.stdout.strip() == "interrupted True", found.stderr


def test_the_stubs_match_the_module():
    """Every name and every argument, as far as the compiled module says them."""
    import ast
    import inspect

    from organza import _organza

    stubs = ast.parse((Path(organza.__file__).parent / "_organza.pyi").read_text())

    def functions(body):
        return {node.name: node for node in body if isinstance(node, ast.FunctionDef)}

    def arguments(node):
        return [argument.arg for argument in node.args.args]

    classes = {node.name: functions(node.body) for node in stubs.body if isinstance(node, ast.ClassDef)}
    public = {name for name in vars(_organza) if not name.startswith("_")}
    assert public == set(classes) | set(functions(stubs.body))
    for name, methods in classes.items():
        kind = getattr(_organza, name)
        own = {method for method in vars(kind) if not method.startswith("_")}
        assert own == {method for method in methods if not method.startswith("_")}, name
        for method in own:
            found = getattr(kind, method)
            if callable(found):
                names = [argument for argument in inspect.signature(found).parameters]
                assert names == arguments(methods[method]), f"{name}.{method}"


def test_a_missing_desktop_prints_nothing():
    environment = {name: value for name, value in os.environ.items() if name not in ("XDG_RUNTIME_DIR", "NODEVICE_SELECT")}
    command = [sys.executable, "-c", "import organza; organza.Renderer()"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert done.stdout == done.stderr == ""
