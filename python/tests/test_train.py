"""Training from Python."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import organza

SMALL = {
    "run.steps": 4,
    "run.tiles_per_step": 2,
    "run.tile_size": 16,
    "run.tiles_per_view": 1,
    "run.evaluate_every": 2,
    "run.checkpoint_every": 2,
    "data.built_in_views": 4,
    "data.built_in_side": 32,
    "data.hold_out_every": 2,
    "start.gaussians": 100,
    "densification.max_gaussians": 200,
}


def small(**more):
    return organza.TrainConfig("built-in", settings=SMALL | more)


@pytest.fixture(scope="module")
def dataset(renderer):
    """As the settings say: rendering it takes longer than the steps."""
    return organza.Dataset.built_in(renderer, views=4, side=32, hold_out_every=2)


def tensors_of(path):
    scene = organza.Scene.load(path)
    return {name: np.array(values) for name, values in scene.tensors().items()}


def assert_same(found, expected):
    assert found.keys() == expected.keys()
    assert all(np.array_equal(found[name], expected[name]) for name in found)


def test_a_run_is_iterated_over(renderer, dataset, tmp_path):
    seen = []
    run = organza.train(dataset, small(), output=tmp_path / "run", renderer=renderer, on_evaluation=seen.append)
    steps = []
    for step in run:
        steps.append(step)
        if step.step == 3:
            scene = step.scene
    assert [step.step for step in steps] == [1, 2, 3, 4] and run.outcome == "finished"
    assert all(step.loss > 0 and step.psnr > 3 and step.gaussians == 100 for step in steps)
    assert len(scene) == 100 and [e.step for e in seen] == [2, 4] == [e.step for e in run.evaluations]
    with pytest.raises(ValueError, match="inside the loop"):
        steps[0].scene
    for name in ("config.toml", "metrics.jsonl", "checkpoint.safetensors", "report.html", "evaluations.csv"):
        assert (tmp_path / "run" / name).exists(), name
    with pytest.raises(ValueError, match="already holds a run"):
        organza.train(dataset, small(), output=tmp_path / "run", renderer=renderer)


def test_a_run_has_the_bits_of_the_program(renderer, program, tmp_path):
    settings = [f"--set={key}={value}" for key, value in SMALL.items()]
    command = [program, "train", "-o", tmp_path / "native", "--backend", "cpu", *settings]
    subprocess.run(command, check=True, capture_output=True)
    organza.train(config=small(), output=tmp_path / "python", renderer=renderer).run()
    native, python = tmp_path / "native", tmp_path / "python"
    assert (native / "config.toml").read_text() == (python / "config.toml").read_text()
    assert_same(tensors_of(python / "checkpoint.safetensors"), tensors_of(native))
    assert sorted(p.name for p in native.iterdir()) == sorted(p.name for p in python.iterdir())
    # and one goes on with the other's
    command = [program, "train", "--resume", python, "--steps", "6", "--backend", "cpu"]
    subprocess.run(command, check=True, capture_output=True)


def test_a_run_that_is_left_is_saved_and_resumed_to_the_same_bits(renderer, dataset, tmp_path):
    whole = organza.train(dataset, small(), output=tmp_path / "whole", renderer=renderer).run()
    assert whole.outcome == "finished"
    for step in organza.train(dataset, small(), output=tmp_path / "left", renderer=renderer):
        if step.step == 3:
            break
    with pytest.raises(ValueError, match="inside the loop"):
        step.scene
    with organza.train(resume=tmp_path / "left", renderer=renderer) as rest:
        assert [step.step for step in rest] == [4]
    found, expected = (tensors_of(tmp_path / name / "checkpoint.safetensors") for name in ("left", "whole"))
    assert_same(found, expected)


def test_a_data_set_is_shared_by_runs_in_temporary_folders(renderer, dataset):
    assert len(dataset) == 4 and dataset.train == [1, 3] and dataset.held_out == [0, 2]
    assert dataset.image(0).shape == (32, 32, 3) and 0 < dataset.image(0).max() <= 1.0
    finals = []
    for _ in range(2):
        run = organza.train(dataset, small(), renderer=renderer)
        for step in run:
            if step.step == 4:
                finals.append({name: np.array(v) for name, v in step.scene.tensors().items()})
        assert run.outcome == "finished" and len(run.evaluations) == 2
    assert_same(*finals)


def test_a_data_set_is_read_with_its_warnings(renderer, dataset, tmp_path):
    for name, index in [("0.png", 0), ("1.png", 1), ("2.png", 1)]:
        dataset.image(index).save(tmp_path / name)
    dataset.cameras[[0, 1, 2]].save(tmp_path / "transforms.json")
    file = json.loads((tmp_path / "transforms.json").read_text())
    for index, frame in enumerate(file["frames"]):
        frame["file_path"] = f"{index}.png"
    (tmp_path / "transforms.json").write_text(json.dumps(file))
    with pytest.warns(UserWarning, match="the same photograph is there twice"):
        found = organza.load_dataset(tmp_path)
    assert found.names == ["0.png", "1.png", "2.png"] and (found.train, found.held_out) == ([1, 2], [0])
    assert np.array_equal(found.image(2), dataset.image(1))
    with pytest.warns(UserWarning, match="the same photograph is there twice"):
        organza.train(tmp_path, small(), renderer=renderer).run()


def test_a_loss_of_torch_trains(renderer, dataset, tmp_path):
    torch = pytest.importorskip("torch", reason="torch is not installed: pip install torch")

    def squares(rendered, target, valid):
        assert rendered.shape == target.shape == (2, 3, 16, 16) and valid.shape == (2, 1, 16, 16)
        return ((rendered - target) * valid).square().sum() / (3 * valid.sum())

    steps = list(organza.train(dataset, small(), loss=squares, renderer=renderer))
    # the loss is the mean of squares, of which the PSNR is the logarithm
    for step in steps:
        assert step.loss == pytest.approx(10 ** (-step.psnr / 10), rel=1e-3)

    def broken(rendered, target, valid):
        raise ZeroDivisionError("the loss's own")

    with pytest.raises(ZeroDivisionError, match="the loss's own"):
        organza.train(dataset, small(), output=tmp_path / "run", loss=broken, renderer=renderer).run()
    with pytest.raises(ValueError, match="one value"):
        organza.train(dataset, small(), loss=lambda y, t, v: y, renderer=renderer).run()
    assert torch.is_grad_enabled()


def test_settings_are_read_and_refused(renderer, tmp_path):
    config = organza.TrainConfig("fast", settings={"run.steps": 7, "scene.color_mlp.hidden": [16, 16], "exposure.learn": "off"})
    assert config["run.steps"] == 7 and config["scene.color_mlp.hidden"] == [16, 16]
    path = tmp_path / "mine.toml"
    path.write_text(config.to_toml())
    assert organza.TrainConfig(file=path).to_toml() == config.to_toml()
    with pytest.raises(KeyError, match="run.stairs"):
        config["run.stairs"]
    with pytest.raises(ValueError, match="leave out the others"):
        organza.train(resume=tmp_path, config=config, renderer=renderer)
    with pytest.raises(ValueError, match="no config.toml"):
        organza.train(resume=tmp_path, renderer=renderer)
    with pytest.raises(FileNotFoundError):
        organza.train(tmp_path / "nowhere", config, renderer=renderer)


def test_control_c_saves_a_run(tmp_path):
    code = f"""
import os, signal
import organza
# a shell that starts this in the background ignores Ctrl-C
signal.signal(signal.SIGINT, signal.default_int_handler)
settings = {json.dumps(SMALL | {"run.steps": 100000, "run.checkpoint_every": 100000, "run.evaluate_every": 0})}
config = organza.TrainConfig("built-in", settings=settings)
try:
    for step in organza.train(config=config, output={str(tmp_path / "run")!r}, renderer=organza.Renderer("cpu", threads=1)):
        if step.step == 3:
            os.kill(os.getpid(), signal.SIGINT)
except KeyboardInterrupt:
    print("interrupted")
"""
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=300)
    assert found.stdout.strip() == "interrupted", found.stderr
    assert (tmp_path / "run" / "checkpoint.safetensors").exists()
    assert not list((tmp_path / "run").glob(".organza*"))
