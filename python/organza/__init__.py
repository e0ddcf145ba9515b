"""organza: sort-free Gaussian rendering and training.

    import organza

    renderer = organza.Renderer()
    scene = organza.Scene.built_in()
    images = renderer.render(scene, organza.Cameras.turntable(4, side=128))  # [C, H, W, 3]

`organza.torch` and `organza.jax` give gradients to those frameworks. Wrong arguments raise `ValueError`, files that are not
there `FileNotFoundError`, too little memory `MemoryError`, and all else that stops organza `organza.Error`.
"""

import os

# Without a desktop, Mesa's layer that chooses among its devices writes a complaint for each device that is opened. It stays if the user asks
# it for a device, as in the program.
_asks = os.environ.get("MESA_VK_DEVICE_SELECT") or os.environ.get("DRI_PRIME")
if not os.path.isabs(os.environ.get("XDG_RUNTIME_DIR", "")) and not _asks:
    os.environ["NODEVICE_SELECT"] = "1"

from ._organza import DeviceScene, Error, Scene, Tape, __version__
from ._cameras import Cameras, Tiles
from ._data import Dataset, load_dataset
from ._images import Images
from ._renderer import Renderer
from ._splats import Exported, Imported, export, import_splats
from ._training import Evaluation, Step, TrainConfig, Training, train

__all__ = [
    "Cameras",
    "Dataset",
    "DeviceScene",
    "Error",
    "Evaluation",
    "Exported",
    "Images",
    "Imported",
    "Renderer",
    "Scene",
    "Step",
    "Tape",
    "Tiles",
    "TrainConfig",
    "Training",
    "__version__",
    "export",
    "import_splats",
    "load_dataset",
    "train",
]
