# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes have the handles, parts and borders of their data: small runs of the topology table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from neuralmesh_tools import datasets
from neuralmesh_tools.benchmarks.topology.data import made
from neuralmesh_tools.benchmarks.topology.judge import Run, faults
from neuralmesh_tools.benchmarks.topology.rows import ROWS
from neuralmesh_tools.benchmarks.topology.run import Job, measure_run
from neuralmesh_tools.geometry import diagonal, sample_surface
from neuralmesh_tools.layers import document_of
from neuralmesh_tools.methods import METHODS, Task, reconstruct
from neuralmesh_tools.quality.inputs import make_case
from neuralmesh_tools.quality.shapes import thin_blade

VERTICES = 1_500
# So many that an edge is shorter than its wall is thick.
OF_THIN_CUP = 2_500

CASES = [
    ("torus", "clean"),
    ("torus", "sparse"),
    ("knot1", "half"),
    ("bunny", "half"),
    ("two-spheres", "clean"),
    ("frame-0.3", "clean"),
    ("knot1", "clean"),
    # Two grids have its shape; a few levels of a finer one, across its base, have another.
    ("mannequin", "sparse"),
    ("hemisphere", "clean"),
    ("bent-sheet", "clean"),
    ("tube", "clean"),
    ("hemisphere-closed", "clean"),
    ("tube-closed", "clean"),
    ("cup-3%-20000", "clean"),
]


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(("name", "condition"), CASES)
def test_a_mesh_has_the_shape_of_its_data(plugin: Path, name: str, condition: str, seed: int):
    row = ROWS[name]
    try:
        cloud = made(row.maker, row.points, condition, seed)
    except datasets.Unavailable as problem:
        pytest.skip(str(problem))
    vertices = OF_THIN_CUP if name.startswith("cup") else VERTICES
    task = Task(vertices, parameters={**row.parameters, "randomseed": seed})
    values = measure_run(Job(plugin, cloud, task, row.expected.window, distances=False))
    assert faults(Run(name, condition, seed, vertices, values), row.expected) == []


def test_points_of_uneven_density_have_their_handles(plugin: Path):
    # Ten times as dense at one end as at the other: without thinning, no shape is found.
    try:
        case = make_case("anchor", "uneven", 1)
    except datasets.Unavailable as problem:
        pytest.skip(str(problem))
    result = reconstruct(METHODS["neural-mesh"], document_of(case.points), Task(2_500))
    assert (result.returned["genus"], result.returned["components"]) == (4, 1)


def test_a_thin_plate_has_its_two_sides(plugin: Path):
    # 0.6 to 2.9 % of the diagonal thick: less than a cell of the grid that looks for its shape.
    drawn, _ = sample_surface(*thin_blade(), 40_000, np.random.default_rng(1))
    result = reconstruct(METHODS["neural-mesh"], document_of(drawn), Task(2_500))
    assert (result.returned["genus"], result.returned["self_intersections"]) == (0, 0)
    # 0.0017. With a sheet in its middle, 0.0077.
    assert result.returned["rms_error"] < 0.0025 * diagonal(drawn)
