# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures: the built plugin in the real PyMeshLab, and the wheel's own sample meshes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pymeshlab
import pytest
from numpy.typing import NDArray

from neuralmesh_tools.layers import load_plugin
from neuralmesh_tools.project import PLUGIN
from neuralmesh_tools.project import sample_meshes as sample_meshes_folder

# PyMeshLab 2022.2, which the plugin can be built for, has older names for these.
if not hasattr(pymeshlab.Mesh, "transform_matrix"):
    pymeshlab.Mesh.transform_matrix = pymeshlab.Mesh.trasform_matrix
    pymeshlab.MeshSet.mesh_number = pymeshlab.MeshSet.number_meshes


def pytest_addoption(parser: pytest.Parser) -> None:
    """Sizes of tests: --clouds 200 runs those of batches at their full size, in minutes."""
    parser.addoption("--clouds", type=int, default=24, help="in a batch (default 24)")
    parser.addoption(
        "--property-cases", type=int, default=500, help="of property tests (default 500)"
    )
    parser.addoption(
        "--property-seed", type=int, default=0, help="other cases of property tests (default 0)"
    )


@pytest.fixture
def cloud_count(request: pytest.FixtureRequest) -> int:
    """How many clouds a test of batches makes."""
    return int(request.config.getoption("--clouds"))


@pytest.fixture(scope="session")
def plugin() -> Path:
    """Load the plugin, once a process; a missing build fails the tests, it does not skip them."""
    if not PLUGIN.is_file():
        pytest.fail(f"{PLUGIN} is missing: run scripts/build", pytrace=False)
    load_plugin(PLUGIN)
    return PLUGIN


@pytest.fixture
def mesh_set(plugin: Path) -> pymeshlab.MeshSet:
    """An empty document with our filters at hand."""
    return pymeshlab.MeshSet(verbose=False)


@pytest.fixture(scope="session")
def sample_meshes() -> Path:
    """The folder of bunny.obj and the other meshes that the pymeshlab wheel brings."""
    return sample_meshes_folder()


@pytest.fixture(scope="session")
def bunny_array(sample_meshes: Path) -> NDArray[np.float64]:
    """The vertices of bunny.obj, shape (28088, 3). Not to be written to."""
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(sample_meshes / "bunny.obj"))
    points = np.array(document.current_mesh().vertex_matrix())
    points.flags.writeable = False
    return points


@pytest.fixture
def bunny_points(
    mesh_set: pymeshlab.MeshSet, bunny_array: NDArray[np.float64]
) -> pymeshlab.MeshSet:
    """A document whose only layer, `bunny`, is the 28,088 points of bunny.obj, without faces."""
    mesh_set.add_mesh(pymeshlab.Mesh(bunny_array), "bunny")
    return mesh_set
