# SPDX-License-Identifier: GPL-3.0-or-later
"""MeshLab finds the plugin in the user's folder, and turns the one of PyMeshLab away."""

from __future__ import annotations

from collections.abc import Callable

from meshlab import MeshLab
from polling import wait_for
from scene import CLOUD, DOUBLE_PLUGIN, FILTER
from widgets import Widget


def cells(window: Widget) -> list[str]:
    return [cell.name for cell in window.all("table cell")]


def test_plugin_info_shows_the_plugin_and_its_filters(
    start_meshlab: Callable[..., MeshLab], screenshot: Callable[[str], None]
) -> None:
    meshlab = start_meshlab(CLOUD)
    meshlab.wait_until_open()
    meshlab.choose("Help", "Plugin Info")
    info = meshlab.window("Plugin Information")
    meshlab.click(next(iter(info.all("table cell"))))
    meshlab.write("FilterNeuralMesh")  # a list goes where one types
    wait_for("the plugin in the list", lambda: "FilterNeuralMesh" in cells(info))
    meshlab.press("Right")  # unfolds the row
    wait_for("the plugin's filters", lambda: FILTER in cells(info))
    screenshot("plugin-info")
    row = cells(info)[cells(info).index("FilterNeuralMesh") :]
    assert row[:5:1].count("Filter") == 1
    assert "libfilter_neuralmesh.so" in row[:6]


def test_plugin_of_the_other_precision_is_refused_without_a_crash(
    start_meshlab: Callable[..., MeshLab], screenshot: Callable[[str], None]
) -> None:
    meshlab = start_meshlab(CLOUD, plugin=DOUBLE_PLUGIN)
    box = meshlab.window("Error while loading plugins")
    screenshot("other-precision")
    assert (
        "libfilter_neuralmesh.so has different floating point precision from the running "
        "MeshLab version." in max((label.name for label in box.all("label")), key=len)
    )
    meshlab.push(box, "OK")
    meshlab.wait_until_open()
    assert meshlab.layers() == ["bunny"]
