# SPDX-License-Identifier: GPL-3.0-or-later
"""What Linux, macOS and Windows differ in. No other module that is packaged asks for the system.

What is here for Windows has been run by no one yet: .github/workflows/wheels.yml will be the first.
"""

from __future__ import annotations

import ctypes
import locale
import os
import signal
import subprocess
import sys
from collections.abc import Mapping, Sequence
from multiprocessing.connection import Connection
from pathlib import Path
from typing import IO, Any

WINDOWS = sys.platform == "win32"
PR_SET_PDEATHSIG = 1

# What CMake calls the plugin. On macOS it ends as on Linux.
PLUGIN_NAME = "filter_neuralmesh.dll" if WINDOWS else "libfilter_neuralmesh.so"

# Opening a file with this fails where it is a link. Windows needs a privilege to make one.
NO_LINK: int = getattr(os, "O_NOFOLLOW", 0)


def lock(file: IO[Any]) -> bool:
    """Keep an open file for this process until it is closed; return whether nobody else has it."""
    try:
        if sys.platform == "win32":
            import msvcrt

            msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    return True


def start_with(
    theirs: Connection, command: Sequence[str], environment: Mapping[str, str]
) -> subprocess.Popen[bytes]:
    """Start a process that gets an end of a pipe, as its last argument, and no Ctrl-C.

    That end is theirs alone afterwards. The process finds it by connection().
    """
    handle = theirs.fileno()
    options: dict[str, Any]
    if sys.platform == "win32":
        os.set_handle_inheritable(handle, True)
        start = subprocess.STARTUPINFO(lpAttributeList={"handle_list": [handle]})
        options = {"startupinfo": start, "creationflags": subprocess.CREATE_NEW_PROCESS_GROUP}
    else:
        options = {"pass_fds": [handle], "start_new_session": True}
    process = subprocess.Popen(
        [*command, str(handle)], env=dict(environment), stdin=subprocess.DEVNULL, **options
    )
    theirs.close()
    return process


def connection(argument: str) -> Connection:
    """The end of the pipe that start_with() gave to this process."""
    if sys.platform == "win32":
        from multiprocessing.connection import PipeConnection

        return PipeConnection(int(argument))
    return Connection(int(argument))


def readable_names() -> dict[str, str]:
    """What the environment lacks for PyMeshLab to read names of files as UTF-8.

    Under LC_ALL=C it takes each letter that is not ASCII for a question mark.
    """
    if WINDOWS:
        return {}
    encoding = locale.nl_langinfo(locale.CODESET).lower().replace("-", "")
    return {} if encoding == "utf8" else {"LC_ALL": "C.UTF-8"}


def how_it_ended(code: int) -> str:
    """A sentence about a process that ended with an exit code by itself."""
    if code >= 0:
        return f"The process ended by itself with exit code {code}."
    return f"The process crashed with {signal.Signals(-code).name}."


def forget_peak() -> None:
    """Start the kernel's high-water mark of resident memory anew, where there is one."""
    try:
        Path("/proc/self/clear_refs").write_text("5")
    except OSError:
        return


def peak() -> int:
    """The largest resident size in bytes since forget_peak; the present one if unknown."""
    try:
        status = Path("/proc/self/status").read_text()
        line = next(line for line in status.splitlines() if line.startswith("VmHWM"))
        return int(line.split()[1]) * 1024
    except (OSError, StopIteration):
        import psutil  # which the build's own Python need not have

        return int(psutil.Process().memory_info().rss)


def die_with_parent() -> None:
    """Have the kernel kill this process when the thread that started it ends (Linux only).

    A filter that runs cannot notice that the other end of the pipe is gone.
    """
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def processor() -> str:
    """The name of this machine's processor, empty where the system does not tell."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(
            line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")
        )
    except (OSError, StopIteration):
        return ""
