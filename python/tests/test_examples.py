"""The notebook, and the code of the README."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def test_the_notebook_runs():
    nbformat = pytest.importorskip("nbformat", reason="nbclient is not installed")
    nbclient = pytest.importorskip("nbclient", reason="nbclient is not installed")
    pytest.importorskip("ipykernel", reason="ipykernel is not installed")
    notebook = nbformat.read(ROOT / "examples" / "tour.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    assert len(pictures) == 4
    text = "".join(output.get("text", "") for output in outputs)
    assert re.search(r"step 30: loss 0\.\d+, PSNR \d", text), text


def test_the_readme_works(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    assert len(blocks) >= 4
    names = {}
    for block in blocks:
        if "torch" in block:
            pytest.importorskip("torch", reason="torch is not installed")
        if "jax" in block:
            pytest.importorskip("jax", reason="JAX is not installed")
        exec(compile(block, "README.md", "exec"), names)  # noqa: S102
