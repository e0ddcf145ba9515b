"""Training that processes share."""

import functools
import json
import subprocess
import sys
import threading

import numpy as np
import pytest

import organza

SETTINGS = {
    "run.steps": 5,
    "run.tiles_per_step": 6,
    "run.tile_size": 16,
    "run.tiles_per_view": 1,
    "run.evaluate_every": 3,
    "data.built_in_views": 6,
    "data.built_in_side": 32,
    "data.hold_out_every": 3,
    "start.gaussians": 100,
    "densification.max_gaussians": 200,
    "densification.every": 2,
    "densification.begin": 0,
    "densification.end": 1,
}


def checkpoint_of(folder):
    """Every tensor's type, shape and bytes, the moments and statistics included."""
    data = (folder / "checkpoint.safetensors").read_bytes()
    length = int.from_bytes(data[:8], "little")
    header = json.loads(data[8 : 8 + length])
    header.pop("__metadata__")
    tensors = {}
    for name, entry in header.items():
        begin, end = (8 + length + offset for offset in entry["data_offsets"])
        tensors[name] = (entry["dtype"], entry["shape"], data[begin:end])
    return tensors


@pytest.fixture(scope="module")
def expected(tmp_path_factory, program):
    """The files that the program leaves with one rank."""
    folder = tmp_path_factory.mktemp("ranks") / "native"
    settings = [f"--set={key}={value}" for key, value in SETTINGS.items()]
    command = [program, "train", "-o", folder, "--ranks", "1", "--backend", "cpu", *settings]
    subprocess.run(command, check=True, capture_output=True)
    tensors = checkpoint_of(folder)
    assert len(tensors) > 30 and tensors["gaussians.position"][1][0] > 100
    return tensors


class Threads:
    """Carries the messages of ranks that are threads, without torch."""

    mixed, local_rank, failed = False, 0, None

    def __init__(self, rank, messages, barrier):
        self.rank, self.size, self.messages, self.barrier = rank, len(messages), messages, barrier

    def _all(self, mine):
        self.messages[self.rank] = mine
        self.barrier.wait()
        found = list(self.messages)
        self.barrier.wait()
        return found

    def reduce(self, values, operation):
        combine = {"max": np.maximum, "or": np.bitwise_or, "sum": np.add}[operation]
        values[:] = functools.reduce(combine, self._all(values.copy()))

    def gather(self, mine):
        return self._all(mine)

    def exchange(self, for_each):
        return [sent[self.rank] for sent in self._all(for_each)]

    def broadcast(self, mine):
        return self._all(mine)[0]

    def fail(self, message):
        self.barrier.abort()


def test_threads_that_pass_messages_get_the_bits_of_the_program(expected, tmp_path):
    messages, barrier, steps = [None] * 2, threading.Barrier(2), [[], []]

    def train(rank):
        # rank 0 has the settings
        config = organza.TrainConfig("built-in", settings=SETTINGS if rank == 0 else None)
        ranks, renderer = Threads(rank, messages, barrier), organza.Renderer("cpu", threads=1)
        run = organza.train(config=config, output=tmp_path / "run", ranks=ranks, renderer=renderer)
        steps[rank] = [*(step.step for step in run), run.outcome]

    threads = [threading.Thread(target=train, args=[rank]) for rank in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert steps == [[1, 2, 3, 4, 5, "finished"], ["followed"]]
    assert checkpoint_of(tmp_path / "run") == expected
    with pytest.raises(ValueError, match="give `output`"):
        organza.train(ranks=Threads(0, [None], threading.Barrier(1)), renderer=organza.Renderer("cpu"))


def torchrun(size, code, *words):
    pytest.importorskip("torch", reason="torch is not installed: pip install torch")
    begin = "import json, os, sys\nimport torch, organza, organza.torch\ntorch.distributed.init_process_group('gloo')\n"
    begin += "renderer = organza.Renderer('cpu', threads=1)\n"
    path = words[0].parent / "script.py"
    path.write_text(begin + code)
    command = [sys.executable, "-m", "torch.distributed.run", "--standalone", "--nproc-per-node", str(size), path, *words]
    found = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    assert found.returncode == 0, found.stderr
    return sorted(found.stdout.splitlines())


def test_processes_of_torchrun_get_the_bits_of_the_program(expected, tmp_path):
    code = """
settings, last = json.loads(sys.argv[2]), int(sys.argv[3])
begin = {"config": organza.TrainConfig("built-in", settings=settings), "output": sys.argv[1]}
ranks = organza.torch.Ranks()
run = organza.train(**begin if settings else {"resume": sys.argv[1]}, ranks=ranks, renderer=renderer)
steps = []
for step in run:
    steps.append(step.step)
    if step.step == last:
        run.stop()
print(ranks.rank, steps, run.outcome)
"""
    settings = json.dumps(SETTINGS)
    assert torchrun(1, code, tmp_path / "one", settings, "9") == ["0 [1, 2, 3, 4, 5] finished"]
    assert checkpoint_of(tmp_path / "one") == expected
    # and three begin what two finish
    found = torchrun(3, code, tmp_path / "run", settings, "3")
    assert found == ["0 [1, 2, 3] stopped", "1 [] followed", "2 [] followed"]
    found = torchrun(2, code, tmp_path / "run", "{}", "9")
    assert found == ["0 [4, 5] finished", "1 [] followed"]
    assert checkpoint_of(tmp_path / "run") == expected


def test_a_rank_that_fails_or_is_gone_ends_the_others(tmp_path):
    code = """
def train(output):
    ranks = organza.torch.Ranks()
    if output == "gone" and ranks.rank == 1:
        os._exit(0)
    try:
        organza.train(output=output, ranks=ranks, renderer=renderer).run()
    except (ValueError, organza.Error) as error:
        print(ranks.rank, type(error).__name__, error, flush=True)
train(sys.argv[1])
train("gone")
"""
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / "config.toml").write_text("")
    gone, mine, other = torchrun(2, code, tmp_path / "run")
    assert gone.startswith("0 Error rank 0: another rank is gone: "), gone
    assert mine.startswith("0 ValueError ") and "already holds a run" in mine
    assert other == mine.replace("0 ValueError ", "1 Error rank 0: ")


def test_a_process_group_is_asked_for():
    pytest.importorskip("torch", reason="torch is not installed: pip install torch")
    import organza.torch

    with pytest.raises(ValueError, match="has no process group.*torchrun"):
        organza.torch.Ranks()
