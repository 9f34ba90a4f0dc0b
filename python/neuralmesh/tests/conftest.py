# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures for the package `neuralmesh`, which scripts/build python installs into .venv."""

from __future__ import annotations

from pathlib import Path

import neuralmesh
import numpy as np
import pytest
from numpy.typing import NDArray

from neuralmesh_tools.project import sample_meshes


@pytest.fixture(scope="session")
def bunny_file() -> Path:
    """bunny.obj of the pymeshlab wheel."""
    return sample_meshes() / "bunny.obj"


@pytest.fixture(scope="session")
def bunny(bunny_file: Path) -> NDArray[np.float64]:
    """Its 28,088 points, not to be written to."""
    points = neuralmesh.read(bunny_file).points
    points.flags.writeable = False
    return points


@pytest.fixture(scope="session")
def ball() -> NDArray[np.float64]:
    """5,000 points of the unit sphere, not to be written to."""
    points = np.random.default_rng(0).normal(size=(5000, 3))
    points /= np.linalg.norm(points, axis=1)[:, None]
    points.flags.writeable = False
    return points
