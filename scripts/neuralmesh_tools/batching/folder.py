# SPDX-License-Identifier: GPL-3.0-or-later
"""The output folder: a lock, a record for each finished item, outputs moved into place.

DIR/NAME.SUFFIX            the outputs                 DIR/logs/NAME.log   what filters printed
DIR/.batch/records/        a record an item, JSON      DIR/.batch/partial/ what is being written
DIR/.batch/lock            held while a batch runs     DIR/.batch/run      which one

A record is written, in one step, after its output is in place: whatever has a record is done, at
whatever moment the batch is killed.
"""

from __future__ import annotations

import fcntl
import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from neuralmesh_tools.files import write_in_one_step

Record = dict[str, Any]


class Locked(RuntimeError):
    """Another batch works in the folder; the message is a sentence for the user."""


@dataclass(frozen=True)
class OutFolder:
    """Paths in the output folder. It may be on a file system that cluster nodes share."""

    root: Path

    def output(self, name: str, suffix: str) -> Path:
        """Where an item's output is put."""
        return self.root / f"{name}{suffix}"

    def log(self, name: str) -> Path:
        """Where an item's log is put."""
        return self.root / "logs" / f"{name}.log"

    def partial(self, run: str, name: str) -> Path:
        """A folder in which an item's output is written before it is moved."""
        return self.root / ".batch" / "partial" / run / name

    def _record_path(self, name: str) -> Path:
        return self.root / ".batch" / "records" / f"{name}.json"

    @contextmanager
    def locked(self, run: str) -> Iterator[None]:
        """Hold the folder for a run; raises Locked if another one does, dead ones excepted."""
        state = self.root / ".batch"
        state.mkdir(parents=True, exist_ok=True)
        with (state / "lock").open("a") as lock:
            try:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                raise Locked(f"Another batch is at work in {self.root}.") from None
            write_in_one_step(state / "run", run)
            shutil.rmtree(state / "partial", ignore_errors=True)
            try:
                yield
            finally:
                shutil.rmtree(state / "partial", ignore_errors=True)

    def is_current(self, run: str) -> bool:
        """Whether a run still holds the folder: a cluster's worker may outlive its batch."""
        try:
            return (self.root / ".batch" / "run").read_text(encoding="utf-8") == run
        except OSError:
            return False

    def record(self, name: str) -> Record | None:
        """The record of an item, None if there is none that can be read."""
        try:
            record = json.loads(self._record_path(name).read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return None
        return record if isinstance(record, dict) else None

    def write_record(self, name: str, record: Record) -> None:
        """Keep an item's record, on the disk before this returns."""
        write_in_one_step(self._record_path(name), json.dumps(record, indent=1))

    def is_done(self, name: str, fingerprint: str) -> bool:
        """Whether an item succeeded with this fingerprint and its output is there, whole."""
        record = self.record(name)
        if not record or record["fingerprint"] != fingerprint or record["error"]:
            return False
        output = self.root / record["output"]
        return output.is_file() and output.stat().st_size == record["output_bytes"]

    def move_into_place(self, partial: Path, name: str, suffix: str) -> Path:
        """Move all files of partial beside the output, the output last; return its path.

        Some formats come in several files, such as OBJ with its materials.
        """
        output = self.output(name, suffix)
        output.parent.mkdir(parents=True, exist_ok=True)
        files = sorted(partial.iterdir(), key=lambda file: file.name == output.name)
        for file in files:
            with file.open("rb") as stream:
                os.fsync(stream.fileno())
            file.replace(output.parent / file.name)
        return output

    def remove_other_output(self, name: str, current: str) -> None:
        """Remove the output of an item's record if it is not the current one: it is out of date."""
        record = self.record(name)
        if record and record["output"] and record["output"] != current:
            (self.root / record["output"]).unlink(missing_ok=True)
