# SPDX-License-Identifier: GPL-3.0-or-later
"""The output folder: a lock, a record for each finished item, outputs moved into place.

DIR/NAME.SUFFIX            the outputs                 DIR/logs/NAME.log   what filters printed
DIR/.batch/records/        a record an item, JSON      DIR/.batch/partial/ what is being written
DIR/.batch/lock            held while a batch runs     DIR/.batch/run      which one

A record is written, in one step, after its output is in place: whatever has a record is done, at
whatever moment the batch is killed.

The folder may be somebody else's, and nothing in it is trusted: what a record says is looked at
before it is used, no link is followed out of the folder, and only what an item can have written is
removed.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from neuralmesh_tools import operating_system
from neuralmesh_tools.files import fitting, write_in_one_step

Record = dict[str, Any]
STATE = ".batch"
REPORTS = ("report.json", "report.csv")
# What is asked of a record that is read: another one is as good as none.
FIELDS: dict[str, type | tuple[type, ...]] = {
    **dict.fromkeys(("name", "input", "fingerprint", "output", "outcome", "error", "run"), str),
    **dict.fromkeys(("results", "parameters", "versions"), dict),
    "output_bytes": int,
    "warning": str,
    "seconds": (int, float),
}


class Locked(RuntimeError):
    """Another batch works in the folder; the message is a sentence for the user."""


@dataclass(frozen=True)
class OutFolder:
    """Paths in the output folder. It may be on a file system that cluster nodes share."""

    root: Path

    def output(self, name: str, suffix: str) -> Path:
        """Where an item's output is put."""
        return self.root / _place(name, suffix)

    def log(self, name: str) -> Path:
        """Where an item's log is put."""
        return self.root / "logs" / _place(name, ".log")

    def partial(self, run: str, name: str) -> Path:
        """A folder in which an item's output is written before it is moved."""
        return self.root / STATE / "partial" / run / _place(name, ".partial")

    def _record_path(self, name: str) -> Path:
        return self.root / STATE / "records" / _place(name, ".json")

    def make_room_for(self, path: Path) -> None:
        """Make the folders above a path; raises OSError if that leads out of this folder.

        A link in a folder that somebody else made may lead anywhere.
        """
        above = path.parent
        if not above.resolve().is_relative_to(self.root.resolve()):
            raise OSError(f"{above} leads out of {self.root}: a part of it is a link.")
        above.mkdir(parents=True, exist_ok=True)

    def new_log(self, name: str) -> Path:
        """Make an item's log anew, a file of its own whatever was there; return its path."""
        log = self.log(name)
        self.make_room_for(log)
        log.unlink(missing_ok=True)
        log.touch(exist_ok=False)
        return log

    @contextmanager
    def locked(self, run: str) -> Iterator[None]:
        """Hold the folder for a run; raises Locked if another one does, dead ones excepted.

        Raises OSError if the folder cannot be written to.
        """
        state = self.root / STATE
        self.make_room_for(state / "lock")
        flags = os.O_WRONLY | os.O_CREAT | operating_system.NO_LINK
        with open(os.open(state / "lock", flags, 0o644), "a") as lock:
            if not operating_system.lock(lock):
                raise Locked(f"Another batch is at work in {self.root}.")
            write_in_one_step(state / "run", run)
            self.clear_partial()
            try:
                yield
            finally:
                self.clear_partial()

    def clear_partial(self) -> None:
        """Remove what was being written."""
        shutil.rmtree(self.root / STATE / "partial", ignore_errors=True)

    def is_current(self, run: str) -> bool:
        """Whether a run still holds the folder: a cluster's worker may outlive its batch."""
        try:
            return (self.root / STATE / "run").read_text(encoding="utf-8") == run
        except (OSError, ValueError):
            return False

    def record(self, name: str) -> Record | None:
        """The record of an item, None if there is none that can be read."""
        return _record_in(self._record_path(name))

    def written(self) -> set[Path]:
        """What batches have written here and may be taken for scans, by the records that there are.

        An output counts as written although it was changed since: the batch writes there again.
        """
        found = {self.root / name for name in REPORTS}
        for path in (self.root / STATE / "records").rglob("*.json"):
            record = _record_in(path)
            if record and self._is_output_of(record["name"], record):
                found |= {self.root / record["output"], self.log(record["name"])}
        return found

    def write_record(self, name: str, record: Record) -> None:
        """Keep an item's record, on the disk before this returns. Raises OSError."""
        path = self._record_path(name)
        self.make_room_for(path)
        write_in_one_step(path, json.dumps(record, indent=1))

    def is_done(self, name: str, fingerprint: str) -> bool:
        """Whether an item succeeded with this fingerprint and its output is there, whole."""
        record = self.record(name)
        if not record or record["fingerprint"] != fingerprint or record["error"]:
            return False
        return self._has_output_of(name, record)

    def _has_output_of(self, name: str, record: Record) -> bool:
        """Whether the output that a record names can be the item's, and is there as it was."""
        output = self.root / record["output"]
        return (
            self._is_output_of(name, record)
            and output.is_file()
            and output.stat().st_size == record["output_bytes"]
        )

    def _is_output_of(self, name: str, record: Record) -> bool:
        """Whether a record names an output that can be the item's."""
        suffix = PurePosixPath(record["output"]).suffix
        return bool(suffix) and self.output(name, suffix) == self.root / record["output"]

    def move_into_place(self, partial: Path, name: str, suffix: str) -> Path:
        """Move all files of partial beside the output, the output last; return its path.

        Some formats come in several files, such as OBJ with its materials.
        """
        output = self.output(name, suffix)
        self.make_room_for(output)
        if output in [self.root / name for name in REPORTS]:
            raise OSError(f"Its output would lie where the batch writes {output.name}.")
        files = sorted(partial.iterdir(), key=lambda file: file.name == output.name)
        for file in files:
            with file.open("rb") as stream:
                os.fsync(stream.fileno())
            file.replace(output.parent / file.name)
        return output

    def remove_other_output(self, name: str, current: str) -> None:
        """Remove the output of an item's record if it is not the current one: it is out of date."""
        record = self.record(name)
        if record and record["output"] != current and self._has_output_of(name, record):
            output = self.root / record["output"]
            self.make_room_for(output)
            output.unlink(missing_ok=True)


def _record_in(path: Path) -> Record | None:
    """The record that a file holds, None if it holds none that is whole."""
    try:
        record = json.loads(path.read_text(encoding="utf-8")) if path.is_file() else None
    except (OSError, ValueError, RecursionError):
        return None
    if not isinstance(record, dict):
        return None
    is_whole = all(isinstance(record.get(key), kind) for key, kind in FIELDS.items())
    return record if is_whole else None


def _place(name: str, ending: str) -> PurePosixPath:
    """A file for an item: its name with an ending, no longer than file systems allow."""
    *folders, last = name.split("/")
    return PurePosixPath(*folders, fitting(last, ending))
