"""Training, step by step."""

from __future__ import annotations

import os
import tempfile
import tomllib
import warnings
import weakref
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _organza
from ._data import Dataset
from ._renderer import Renderer


class TrainConfig:
    """Every setting of a run.

    `preset` is "default", "fast", "best" or "built-in"; `file` is a settings file in TOML that overrides the preset; `settings` maps
    names such as "run.steps" to values, which override both. `organza help train` lists all settings.

        organza.TrainConfig("fast", settings={"run.steps": 300, "densification.max_gaussians": 20_000})

    Raises `ValueError` where there is no such setting, or a value is out of range.
    """

    def __init__(
        self,
        preset: str | None = None,
        file: str | os.PathLike[str] | None = None,
        settings: Mapping[str, Any] | None = None,
    ) -> None:
        assignments = [f"{key}={_written(value)}" for key, value in (settings or {}).items()]
        self._core = _organza.TrainConfig(preset, file, assignments)

    @classmethod
    def from_run(cls, folder: str | os.PathLike[str]) -> TrainConfig:
        """The settings of a run's folder."""
        config = cls.__new__(cls)
        config._core = _organza.TrainConfig.from_run(folder)
        return config

    def to_toml(self) -> str:
        """The text of a settings file with every setting."""
        return self._core.to_toml()

    def __getitem__(self, name: str) -> Any:
        """The value of a setting, such as "run.steps"."""
        value: Any = tomllib.loads(self.to_toml())
        for key in name.split("."):
            if not isinstance(value, dict) or key not in value:
                raise KeyError(f"there is no setting {name!r}")
            value = value[key]
        return value

    def __repr__(self) -> str:
        return f"<organza.TrainConfig: {self['run.steps']} steps>"


def _written(value: Any) -> str:
    """The value in the form that the program's `--set` takes."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return ",".join(_written(part) for part in value)
    return str(value)


@dataclass(frozen=True)
class Evaluation:
    """Scores of the held-out photographs after a step."""

    step: int
    """Steps so far."""
    psnr: float | None
    """The mean PSNR in decibels; none where no pixel is valid."""
    ssim: float | None
    """The mean SSIM, at most 1; none where no window is valid."""


@dataclass(frozen=True)
class Step:
    """A step that is done."""

    step: int
    """Steps so far."""
    seconds: float
    """Seconds of training so far."""
    loss: float
    """The loss of the step's tiles, before the step moved anything."""
    psnr: float
    """The PSNR of the step's tiles, in decibels."""
    gaussians: int
    """The Gaussians of the scene."""
    densified: bool
    """Whether Gaussians were added or taken away."""
    # not the run itself: who leaves the loop ends the run, and may keep the step
    _training: weakref.ref[Training] = field(repr=False)

    @property
    def scene(self) -> _organza.Scene:
        """The scene as it is now. Ask inside the loop, before the next step: `ValueError` after it."""
        training = self._training()
        if training is None or training._step is not self:
            reason = f"training has gone on or ended since step {self.step}"
            raise ValueError(f"{reason}: ask for a step's scene inside the loop")
        return training._core.scene()


Loss = Callable[[Any, Any, Any], Any]


class Training:
    """A run that goes on: iterate over it. `train` makes one."""

    def __init__(
        self,
        core: _organza.Training,
        loss: Loss | None,
        on_evaluation: Callable[[Evaluation], object] | None,
        folder: tempfile.TemporaryDirectory[str] | None,
    ) -> None:
        self._core = core
        self._loss = loss
        self._on_evaluation = on_evaluation
        self._step: Step | None = None
        # also where the script ends first
        weakref.finalize(self, _end, core, folder)
        self.evaluations: list[Evaluation] = []
        """The scores of the held-out photographs so far."""
        self.outcome: str | None = None
        """How the run ended: "finished", "stopped" or "time limit"; none while it goes on."""

    def __iter__(self) -> Training:
        return self

    def __next__(self) -> Step:
        if self._step is not None:
            self._step = None
            self._core.proceed()
        while True:
            kind, values = self._core.wait()
            if kind == "step":
                self._step = Step(**values, _training=weakref.ref(self))
                return self._step
            if kind == "loss":
                self._answer(values)
            elif kind == "evaluated":
                evaluation = Evaluation(**values)
                self.evaluations.append(evaluation)
                if self._on_evaluation is not None:
                    self._on_evaluation(evaluation)
            elif kind == "warning":
                warnings.warn(values["text"], stacklevel=2)
            elif kind == "end":
                self.outcome = values.get("outcome", self.outcome)
                # the folder is free for another run as soon as the loop is over
                self._core.close()
                raise StopIteration

    def _answer(self, values: dict[str, np.ndarray]) -> None:
        try:
            loss, grad_tiles = _torch_loss(self._loss, **values)
            self._core.answer(loss, grad_tiles)
        except BaseException:
            self._core.fail()
            self._core.close()
            raise

    def run(self) -> Training:
        """Trains to the end."""
        for _ in self:
            pass
        return self

    def stop(self) -> None:
        """Ends the run after the step that goes on, with a checkpoint: the loop ends then."""
        self._core.stop()

    def close(self) -> None:
        """Stops, saves, and waits for that. Leaving the loop and dropping the run does it, too."""
        self._step = None
        self._core.close()

    def __enter__(self) -> Training:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _end(core: _organza.Training, folder: tempfile.TemporaryDirectory[str] | None) -> None:
    core.close()
    if folder is not None:
        folder.cleanup()


def _torch_loss(
    loss: Loss | None, rendered: np.ndarray, target: np.ndarray, valid: np.ndarray
) -> tuple[float, np.ndarray]:
    """Calls a loss of torch, and differentiates it."""
    import torch

    tiles = torch.from_numpy(rendered).requires_grad_()
    with torch.enable_grad():
        value = loss(tiles, torch.from_numpy(target), torch.from_numpy(valid))
    if not isinstance(value, torch.Tensor) or value.numel() != 1:
        raise ValueError("`loss` must return a tensor of one value")
    (grad_tiles,) = torch.autograd.grad(value, tiles, allow_unused=True)
    if grad_tiles is None:
        raise ValueError("`loss` does not depend on the rendered tiles")
    return float(value.detach()), np.ascontiguousarray(grad_tiles.numpy(), np.float32)


def train(
    dataset: Dataset | str | os.PathLike[str] | None = None,
    config: TrainConfig | None = None,
    *,
    output: str | os.PathLike[str] | None = None,
    resume: str | os.PathLike[str] | None = None,
    loss: Loss | None = None,
    on_evaluation: Callable[[Evaluation], object] | None = None,
    time_limit: float | None = None,
    renderer: Renderer | None = None,
) -> Training:
    """Trains a scene; iterate over what it returns.

        for step in organza.train("data/fox", output="run"):
            print(step.step, step.loss, step.psnr, step.gaussians)

    `dataset` is a data set, its path, or none for the built-in scene. With `output`, the run has a folder as the program's `train -o`
    makes it, with the same bits: checkpoints, evaluations, a report. Without, it has a temporary one, which goes with the run. `resume`
    goes on with the run in a folder, with that run's settings and data.

    `loss` is a function of torch's tensors: the rendered tiles `[K, 3, S, S]`, the photographs `[K, 3, S, S]`, and `valid [K, 1, S, S]`,
    1 where a photograph has a pixel. It returns the loss, a tensor of one value. Without it, the settings say the loss.

    `on_evaluation` is called with each `Evaluation`; `time_limit` is in seconds of training. To stop early, leave the loop: the run
    saves a checkpoint and ends. Ctrl-C does the same.

    Raises `ValueError`, `FileNotFoundError`, `MemoryError`, and `organza.Error` where training has overflowed.
    """
    if resume is not None:
        if output is not None or config is not None or dataset is not None:
            raise ValueError("`resume` takes the data set, the settings and the folder of the run: leave out the others")
        config, output = TrainConfig.from_run(resume), resume
    elif config is None:
        config = TrainConfig("built-in" if dataset is None else "default")
    folder = None
    if output is None:
        folder = tempfile.TemporaryDirectory(prefix="organza-", ignore_cleanup_errors=True)
        output = folder.name
    loaded, path = (dataset._core, None) if isinstance(dataset, Dataset) else (None, dataset)
    core = _organza.Training(
        renderer or Renderer(),
        config._core,
        loaded,
        path,
        output,
        resume is not None,
        time_limit,
        loss is not None,
    )
    return Training(core, loss, on_evaluation, folder)
