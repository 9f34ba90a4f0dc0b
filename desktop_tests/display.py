# SPDX-License-Identifier: GPL-3.0-or-later
"""A screen that nobody sees: an X server, a window manager, and the bus on which programs tell
assistive technology, and these tests, what they show (AT-SPI)."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import processes
from polling import wait_for

SCREEN = "1440x900x24"


class Display:
    """Xvfb, openbox and a session bus, from construction to `close`; sets the environment."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._running: list[subprocess.Popen[bytes]] = []
        os.environ["DISPLAY"] = self._start_server()
        self._start_bus()
        self._start("openbox", ["openbox"])
        # The manager has taken over when it has put its own window's id on the root window.
        wait_for("the window manager", self._has_manager)

    def close(self) -> None:
        """End all of it, the newest first."""
        while self._running:
            processes.stop(self._running.pop())

    def screenshot(self, path: Path) -> None:
        """Write what the screen shows to a PNG file."""
        subprocess.run(["import", "-window", "root", str(path)], check=True, timeout=60)

    @staticmethod
    def pixel(x: int, y: int) -> bytes:
        """Return the colour of one pixel of the screen."""
        crop = ["-crop", f"1x1+{x}+{y}", "-depth", "8", "rgb:-"]
        command = ["import", "-silent", "-window", "root", *crop]
        return subprocess.run(command, capture_output=True, check=True, timeout=60).stdout

    def _start(self, name: str, command: list[str], **more: object) -> None:
        self._running.append(processes.start(command, self.folder / f"{name}.log", **more))

    def _start_server(self) -> str:
        # The server itself looks for a free number, and writes it once it takes connections.
        read_end, write_end = os.pipe()
        command = ["Xvfb", "-displayfd", str(write_end), "-screen", "0", SCREEN]
        self._start("xvfb", [*command, "-nolisten", "tcp"], pass_fds=[write_end])
        os.close(write_end)
        with os.fdopen(read_end) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError(f"Xvfb did not start: {(self.folder / 'xvfb.log').read_text()}")
        return f":{number}"

    def _start_bus(self) -> None:
        socket = self.folder / "bus"
        os.environ["DBUS_SESSION_BUS_ADDRESS"] = f"unix:path={socket}"
        self._start(
            "bus", ["dbus-daemon", "--session", "--nofork", f"--address=unix:path={socket}"]
        )
        wait_for("the session bus", socket.exists)

    @staticmethod
    def _has_manager() -> bool:
        query = ["xprop", "-root", "_NET_SUPPORTING_WM_CHECK"]
        run = subprocess.run(query, capture_output=True, text=True, check=False, timeout=60)
        return "window id" in run.stdout
