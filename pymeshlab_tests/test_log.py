# SPDX-License-Identifier: GPL-3.0-or-later
"""What the log says of a result: its topology, what was opened and filled, what is not right."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from documents import FILTER, Points, sphere_points

PROGRAM = """
import sys
import numpy as np
import pymeshlab

pymeshlab.load_plugin(sys.argv[1])
document = pymeshlab.MeshSet(verbose=True)
document.add_mesh(pymeshlab.Mesh(np.load(sys.argv[2])), "cloud")
parameters = dict(word.split("=") for word in sys.argv[4:])
document.apply_filter(sys.argv[3], **{name: int(value) for name, value in parameters.items()})
"""


class Log:
    """Reads what the host writes, in a process of its own.

    Where a filter has failed before, PyMeshLab writes nothing more.
    """

    def __init__(self, plugin: Path, folder: Path) -> None:
        """Reconstruct by the plugin; points go through a file in the folder."""
        self._plugin = plugin
        self._points = folder / "points.npy"

    def of(self, points: Points, **parameters: int) -> str:
        """Reconstruct points to 800 vertices, and return the filter's line in the log."""
        np.save(self._points, points)
        words = [f"{name}={value}" for name, value in ({"targetvertnum": 800} | parameters).items()]
        command = [sys.executable, "-c", PROGRAM, self._plugin, self._points, FILTER, *words]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return next(line for line in done.stderr.splitlines() if "Neural mesh:" in line)


@pytest.fixture
def log(plugin: Path, tmp_path: Path) -> Log:
    """Return what gives the log of a reconstruction."""
    return Log(plugin, tmp_path)


def sheet_points(count: int) -> Points:
    """Return random points of a bent square sheet, shape (count, 3)."""
    x, y = np.random.default_rng(1).uniform(0, 1, (2, count))
    return np.column_stack([x, y, 0.2 * np.sin(3 * x)])


def test_a_learned_topology_is_told(log: Log) -> None:
    points = np.vstack([sphere_points(4000), sphere_points(4000) + np.array([3, 0, 0])])
    line = log.of(points)
    assert (
        "Topology: 2 components, genus 0, 0 boundary loops. It was learned from the data." in line
    )
    assert "Warning" not in line


def test_a_topology_that_the_points_leave_open_is_told(log: Log) -> None:
    points = np.vstack([sphere_points(3000), 0.88 * sphere_points(3000)])
    line = log.of(points)
    assert "Warning: the points leave the shape open: handles or parts may be missing" in line


def test_figures_are_written_as_people_write_them(log: Log) -> None:
    line = log.of(sphere_points(4000), targetvertnum=1200)
    assert "Neural mesh: 1,200 vertices, 2,396 faces, " in line
    assert re.search(r" RMS error 0\.00\d+ \(0\.0\d+ % of the diagonal\); ", line)
    assert re.search(r"; \d{2,3},\d{3} signals, \d{3} splits, \d+ collapses, seed 1, ", line)


def test_a_topology_that_is_that_of_the_start_is_told(log: Log) -> None:
    points = np.vstack([sphere_points(4000), sphere_points(4000) + np.array([3, 0, 0])])
    line = log.of(points, topology=0)
    assert "Topology: 1 component, genus 0, 0 boundary loops. It is that of the starting" in line


def test_a_gap_that_stays_open_is_told(log: Log) -> None:
    line = log.of(sheet_points(8000), boundaries=1)
    assert "Topology: 1 component, genus 0, 1 boundary loop." in line
    assert "1 gap in the data left open." in line


def test_a_sheet_that_is_doubled_is_told(log: Log) -> None:
    line = log.of(sheet_points(8000))
    assert "0 boundary loops" in line
    assert "1 open sheet closed by a second one behind." in line


def test_holes_that_are_filled_are_told(log: Log) -> None:
    angle, z = np.random.default_rng(1).uniform([0, 0], [2 * np.pi, 4], (8000, 2)).T
    line = log.of(np.column_stack([np.cos(angle), np.sin(angle), z]))
    assert "2 holes filled." in line


def test_points_without_a_shape_are_told(log: Log) -> None:
    # In a cube, not on a surface.
    points = np.random.default_rng(1).uniform(0, 1, (3000, 3))
    assert "Warning: it is that of the starting mesh" in log.of(points)
