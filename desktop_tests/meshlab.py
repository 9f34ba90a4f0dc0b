# SPDX-License-Identifier: GPL-3.0-or-later
"""A running MeshLab, worked as a person works it: by keys and clicks, reading what it shows."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import processes
from polling import wait_for
from scene import EXTRA_PLUGINS
from widgets import Atspi, Widget, windows

# Xvfb has no graphics hardware; MeshLab tells of its widgets only to those who ask for it.
ENVIRONMENT = {"LIBGL_ALWAYS_SOFTWARE": "1", "QT_LINUX_ACCESSIBILITY_ALWAYS_ON": "1"}


class MeshLab:
    """MeshLab with a home of its own, from construction (its window is there) to `close`."""

    def __init__(self, plugin: Path, *files: Path) -> None:
        self._home = Path(tempfile.mkdtemp(prefix="home-"))
        extra = self._home / EXTRA_PLUGINS
        extra.mkdir(parents=True)
        shutil.copy(plugin, extra / "libfilter_neuralmesh.so")
        self._output = self._home / "meshlab.log"
        environment = os.environ | ENVIRONMENT | {"HOME": str(self._home)}
        self._files = files
        command = ["meshlab", *map(str, files)]
        self.process = processes.start(command, self._output, env=environment)

    def wait_until_open(self) -> None:
        """Return when the main window is there and all files are read."""
        # Only then ask for widgets: a program that is asked while it starts never answers.
        wait_for("MeshLab's window", shows_main_window)
        Atspi.get_desktop(0).set_cache_mask(Atspi.Cache.NONE)
        wait_for("MeshLab's widgets", lambda: self._window("MeshLab"))
        if self._files:
            self.wait_for_log("All files opened")

    def close(self) -> None:
        """End MeshLab and forget its home."""
        processes.stop(self.process)
        shutil.rmtree(self._home)

    # ------------------------------------------------------------------------------- what it shows

    def _window(self, title: str) -> Widget | None:
        found = (window for window in windows() if window.showing)
        return next((window for window in found if window.name.startswith(title)), None)

    def window(self, title: str) -> Widget:
        """Wait for a window whose title begins so."""
        return wait_for(f"the window '{title}'", lambda: self._window(title))

    def wait_until_closed(self, title: str) -> None:
        """Return when no window's title begins so."""
        wait_for(f"the end of the window '{title}'", lambda: self._window(title) is None)

    @property
    def main(self) -> Widget:
        """The main window."""
        return self.window("MeshLab")

    def layers(self) -> list[str]:
        """Return the labels in the layer list, without the star of those that are not saved."""
        cells = [cell.name for cell in self.main.all("table cell")]
        return [
            cells[place + 1].removesuffix(" *")
            for place, cell in enumerate(cells[:-1])
            if cell.isdigit()
        ]

    def wait_for_layers(self, *labels: str) -> None:
        """Return when the layer list shows these labels, in this order."""
        wait_for(f"the layers {labels}", lambda: self.layers() == list(labels))

    def eye(self, label: str) -> Widget:
        """Return the eye that shows and hides a layer."""
        cells = self.main.all("table cell")
        return cells[next(i for i, cell in enumerate(cells) if cell.name.startswith(label)) - 2]

    def log(self) -> str:
        """Return the log, as the dock beside the layer list shows it."""
        docks = self.main.all("frame", name="Project_1")
        fields = [field for dock in docks for field in dock.all("text")]
        return fields[-1].text if fields else ""

    def wait_for_log(self, pattern: str) -> re.Match[str]:
        """Return the first match in the log."""
        return wait_for(f"'{pattern}' in the log", lambda: re.search(pattern, self.log()))

    def output(self) -> str:
        """Return what MeshLab wrote to its terminal."""
        return self._output.read_text(encoding="utf-8", errors="replace")

    # ----------------------------------------------------------------------------- what one does

    @staticmethod
    def press(*keys: str) -> None:
        """Press keys one after the other, such as `Down` or `ctrl+f`."""
        subprocess.run(["xdotool", "key", "--clearmodifiers", *keys], check=True, timeout=60)

    @staticmethod
    def write(text: str) -> None:
        """Type a text."""
        subprocess.run(["xdotool", "type", "--", text], check=True, timeout=60)

    @staticmethod
    def click(widget: Widget) -> None:
        """Click in the middle of a widget."""
        x, y = widget.centre
        move = ["xdotool", "mousemove", str(x), str(y), "click", "1"]
        subprocess.run(move, check=True, timeout=60)

    @staticmethod
    def hover(widget: Widget) -> None:
        """Move the pointer onto a widget, and a little there."""
        x, y = widget.centre
        move = ["xdotool", "mousemove", str(x), str(y), "mousemove_relative", "--", "-2", "0"]
        subprocess.run(move, check=True, timeout=60)

    def open_menu(self, *names: str) -> list[Widget]:
        """Open a menu and the menus inside it; return the entries of the last."""
        menu = self.main
        for name in names:
            entry = wait_for(f"the menu '{name}'", lambda m=menu, n=name: m.first("menu item", n))
            self.click(entry)
            menu = wait_for(f"the menu of '{name}'", lambda e=entry: e.first("popup menu"))
        return menu.all("menu item")

    def choose(self, *names: str) -> None:
        """Choose an entry from the menus."""
        entries = self.open_menu(*names[:-1])
        self.click(next(entry for entry in entries if entry.name == names[-1]))

    def start_filter(self, name: str) -> Widget:
        """Start a filter by the search (Ctrl+F), as its name is typed; return its dialog."""
        before = len(x_windows())
        self.press("ctrl+f")
        wait_for("the search", lambda: len(x_windows()) > before)
        self.write(name)
        self.press("Down", "Return")
        return self.window(name)

    def set_field(self, dialog: Widget, label: str, value: str) -> None:
        """Put a value into the text field that stands beside a label."""
        self.click(field_beside(dialog, label))
        self.press("ctrl+a")
        self.write(value)
        wait_for(f"{value} in '{label}'", lambda: field_beside(dialog, label).text == value)

    def save_layer(self, path: Path) -> None:
        """Save the current layer, with the options that MeshLab proposes."""
        self.press("ctrl+shift+e")
        self._give_path("Save ", path)
        options = "Choose Saving Options"
        self.push(self.window(options), "OK")
        self.wait_until_closed(options)
        self.wait_for_log(f"Saved Mesh {re.escape(str(path))}")

    def save_project(self, path: Path) -> None:
        """Save the list of layers."""
        self.press("ctrl+s")
        self._give_path("Save Project File", path)
        wait_for(f"the project {path}", path.exists)

    def run_script(self, path: Path) -> None:
        """Open a filter script and apply it."""
        self.choose("Filters", "Show current filter script")
        script = self.window("Dialog")
        self.push(script, "Open Script")
        self._give_path("Open", path)
        self.push(script, "Apply Script")

    def _give_path(self, title: str, path: Path) -> None:
        dialog = self.window(title)
        wait_for("the file's name", lambda: dialog.first("text", "File name:"))
        self.press("ctrl+a")
        self.write(str(path))
        self.press("Return")
        self.wait_until_closed(title)

    def push(self, window: Widget, name: str) -> None:
        """Push a button by its name."""
        self.click(wait_for(f"the button '{name}'", lambda: button(window, name)))


def x_windows() -> list[str]:
    """Return the names of the X windows that show, among them menus, which have the program's."""
    ids = subprocess.run(
        ["xdotool", "search", "--onlyvisible", "--class", "meshlab"],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    ).stdout.split()
    names = []
    for window in ids:
        query = ["xdotool", "getwindowname", window]
        run = subprocess.run(query, capture_output=True, text=True, check=False, timeout=60)
        names.append(run.stdout.strip())
    return names


def shows_main_window() -> bool:
    """Return whether the main window is there, which names the version and the project."""
    return any(name.startswith("MeshLab 20") for name in x_windows())


def button(window: Widget, name: str) -> Widget | None:
    """Return the button of this name; such as stay down are check boxes to AT-SPI."""
    return window.first("button", name) or window.first("check box", name)


def field_beside(dialog: Widget, label: str) -> Widget:
    """Return the text field, check box or list in the row of a label."""
    row = dialog.first("label", label)
    assert row, f"no label '{label}' in the dialog"
    _, middle = row.centre
    for field in dialog.all("text", "check box", "combo box"):
        _, top, _, height = field.box
        if top <= middle <= top + height:
            return field
    raise AssertionError(f"nothing beside the label '{label}'")
