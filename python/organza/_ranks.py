"""Ranks: processes that train one scene together, over `torch.distributed`."""

from __future__ import annotations

import datetime
import itertools
import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

import numpy as np
import torch
import torch.distributed as dist
from numpy.typing import NDArray

_Bytes = NDArray[np.uint8]

# After this time, a waiting rank checks whether another one has failed.
_PATIENCE = datetime.timedelta(seconds=0.5)
# Rank 0 may rest between steps, for as long as its script decides.
_LONGEST = datetime.timedelta(days=1)
# Distinguishes several trainings of one script.
_NUMBERS = itertools.count()


class Ranks:
    """This process's place among the processes of `torch.distributed` that train one scene together, for `organza.train`.

        torch.distributed.init_process_group("gloo")
        ranks = organza.torch.Ranks()

    All processes of the group make one, at the same place of the script. Messages have a gloo group of their own, beside
    any backend of the script. `mixed` allows ranks with different versions or devices; the scene's bits then depend on which of
    them computes what.

    Raises `ValueError` where the process group was not initialized.
    """

    rank: int
    """This process, from 0."""
    size: int
    """How many there are."""
    local_rank: int
    """This process among the processes of its machine, from 0."""
    mixed: bool
    failed: tuple[int, str] | None
    """The rank that has failed, and its message."""

    def __init__(self, mixed: bool = False) -> None:
        if not (dist.is_available() and dist.is_initialized()):
            reason = "`torch.distributed` has no process group"
            raise ValueError(f'{reason}: call `torch.distributed.init_process_group("gloo")` first, in a script that torchrun starts')
        self.rank, self.size, self.mixed = dist.get_rank(), dist.get_world_size(), mixed
        self.local_rank = int(os.environ.get("LOCAL_RANK", self.rank))
        self.failed = None
        self._group = dist.new_group(backend="gloo", timeout=_LONGEST)
        self._store = dist.distributed_c10d._get_default_store()
        self._key = f"organza/{next(_NUMBERS)}/failed"

    def __repr__(self) -> str:
        return f"<organza.torch.Ranks: rank {self.rank} of {self.size}>"

    # The compiled part of the package calls the following, in a separate thread. Every call waits for all ranks.

    def reduce(self, values: NDArray[Any], operation: str) -> None:
        """Combines all ranks' values in place, `int32` or `int64`: "max", "or" or "sum"."""
        kinds = {"max": dist.ReduceOp.MAX, "or": dist.ReduceOp.BOR, "sum": dist.ReduceOp.SUM}
        self._call(dist.all_reduce, torch.from_numpy(values), kinds[operation])

    def gather(self, mine: _Bytes) -> list[_Bytes]:
        """Every rank's bytes, in the order of the ranks."""
        lengths = torch.empty(self.size, dtype=torch.int64)
        self._call(dist.all_gather_into_tensor, lengths, torch.tensor([len(mine)]))
        longest = int(lengths.max())
        # gloo gathers messages of one length
        mine = np.concatenate([mine, np.zeros(longest - len(mine), np.uint8)])
        found = torch.empty(self.size * longest, dtype=torch.uint8)
        self._call(dist.all_gather_into_tensor, found, torch.from_numpy(mine))
        rows = found.numpy().reshape(self.size, longest)
        return [row[:length] for row, length in zip(rows, lengths.tolist(), strict=True)]

    def exchange(self, for_each: Sequence[_Bytes]) -> list[_Bytes]:
        """Sends each rank its own bytes; returns what each has sent to this one."""
        sent = torch.tensor([len(message) for message in for_each])
        received = torch.empty_like(sent)
        self._call(dist.all_to_all_single, received, sent)
        found = torch.empty(int(received.sum()), dtype=torch.uint8)
        message = torch.from_numpy(np.concatenate(for_each))
        self._call(dist.all_to_all_single, found, message, received.tolist(), sent.tolist())
        return np.split(found.numpy(), received.cumsum(0)[:-1].tolist())

    def broadcast(self, mine: _Bytes) -> _Bytes:
        """The bytes of rank 0."""
        length = torch.tensor([len(mine)])
        self._call(dist.broadcast, length, 0)
        found = torch.from_numpy(mine) if self.rank == 0 else torch.empty(int(length), dtype=torch.uint8)
        self._call(dist.broadcast, found, 0)
        return found.numpy()

    def fail(self, message: str) -> None:
        """This rank cannot go on. The other ranks end, with this message."""
        if self.failed is None:
            self.failed = (self.rank, message)
            # the first that fails is the one to blame
            self._store.compare_set(self._key, "", f"{self.rank}\n{message}")

    def _call(self, function: Callable[..., Any], *arguments: Any) -> None:
        """Makes a call of `torch.distributed`, and waits for its end or until a rank has failed."""
        try:
            work = function(*arguments, group=self._group, async_op=True)
            while not self._has_ended(work):
                self._look()
        except RuntimeError as error:
            with suppress(RuntimeError):
                self._look()
            # gloo's message: where in its source, what, and what that may mean
            what = str(error).rpartition("] ")[2].partition(". ")[0]
            self.failed = (self.rank, f"another rank is gone: {what}")
            raise

    @staticmethod
    def _has_ended(work: Any) -> bool:
        try:
            work.wait(_PATIENCE)
        except RuntimeError:
            # it has failed, or it goes on
            if work.is_completed():
                raise
            return False
        return True

    def _look(self) -> None:
        if self._store.check([self._key]):
            rank, _, message = self._store.get(self._key).decode().partition("\n")
            self.failed = (int(rank), message)
            raise ConnectionError(message)
