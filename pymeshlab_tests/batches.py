# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of scripts/batch.py share: how it is run, what it left behind."""

from __future__ import annotations

import csv
import json
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from neuralmesh_tools.project import SCRIPTS

TIMEOUT = 240


def command(*arguments: object) -> list[str]:
    """The command line of a batch."""
    return [sys.executable, str(SCRIPTS / "batch.py"), *map(str, arguments)]


def run_batch(*arguments: object) -> subprocess.CompletedProcess[str]:
    """Run a batch to its end."""
    return subprocess.run(
        command(*arguments), capture_output=True, text=True, timeout=TIMEOUT, check=False
    )


def start_batch(*arguments: object) -> subprocess.Popen[str]:
    """Start a batch, as in a terminal, and return at once."""
    # What a shell starts in the background ignores SIGINT, and so does all that it starts.
    return subprocess.Popen(
        command(*arguments),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )


def wait_for(condition: Callable[[], bool], what: str) -> None:
    """Look every 10 ms until the condition holds; fail the test if it does not in a while."""
    deadline = time.monotonic() + TIMEOUT
    while not condition():
        assert time.monotonic() < deadline, f"waited in vain for {what}"
        time.sleep(0.01)


def record_files(out: Path) -> dict[str, bytes]:
    """The records of finished items, as they lie on the disk, by the item's name."""
    folder = out / ".batch" / "records"
    return {path.stem: path.read_bytes() for path in sorted(folder.glob("*.json"))}


def report(out: Path) -> dict[str, Any]:
    """What report.json says."""
    return json.loads((out / "report.json").read_text(encoding="utf-8"))


def csv_rows(out: Path) -> list[dict[str, str]]:
    """What report.csv says."""
    with (out / "report.csv").open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def errors(out: Path) -> dict[str, str]:
    """The errors in report.json by the item's name."""
    return {row["name"]: row["error"] for row in report(out)["records"] if row["error"]}
