# SPDX-License-Identifier: GPL-3.0-or-later
"""Processes that the tests start: each in a group of its own, ended by its id, known to be gone."""

from __future__ import annotations

import os
import signal
import subprocess
from pathlib import Path

GRACE_SECONDS = 5.0


def start(command: list[str], log: Path, **more: object) -> subprocess.Popen[bytes]:
    """Start a command in a process group of its own, its output in the file `log`."""
    with log.open("ab") as output:
        return subprocess.Popen(
            command, stdout=output, stderr=subprocess.STDOUT, start_new_session=True, **more
        )


def stop(process: subprocess.Popen[bytes]) -> None:
    """End a process and its group: asked first, then killed. Returns when it is gone."""
    for request in (signal.SIGTERM, signal.SIGKILL):
        try:
            os.killpg(process.pid, request)
        except ProcessLookupError:
            break
        try:
            process.wait(GRACE_SECONDS)
        except subprocess.TimeoutExpired:
            continue
    process.wait()
