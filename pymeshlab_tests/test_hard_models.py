# SPDX-License-Identifier: GPL-3.0-or-later
"""Small versions of the models for which webs are taken out, limbs mended and folds laid flat.

Bounds are about 1.4 times what is measured: RMS distances are means over the seeds, worst
distances those of the worst seed, in per cent of the diagonal, to the mesh and to the surface.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest
from documents import document_of, reconstruct

from neuralmesh_tools import datasets, metrics
from neuralmesh_tools.quality.inputs import make_case

pytestmark = pytest.mark.usefixtures("plugin")

SEEDS = (1, 2, 3)


class Both(NamedTuple):
    """A distance of the surface to the mesh, and of the mesh to the surface."""

    to_mesh: float
    to_surface: float


@pytest.mark.parametrize(
    ("model", "vertices", "rms", "worst"),
    [
        # Measured: 0.049 / 0.077, at worst 1.7 / 2.8 (a strand); with webs between the legs, 3.7 /
        # 9.7. Of six seeds, from a start of 500 vertices: 0.051 / 0.071; from this one, 0.050 /
        # 0.068.
        ("dino", 2000, Both(0.075, 0.090), Both(2.1, 3.3)),
        # Measured: 0.057 / 0.060, at worst 1.5 / 1.6.
        ("homer", 2000, Both(0.080, 0.085), Both(2.1, 2.3)),
        # Measured: 0.128 / 0.106, at worst 2.6 / 2.4.
        ("cortex", 5000, Both(0.175, 0.145), Both(3.6, 3.4)),
    ],
)
def test_limbs_and_folds_come_out(model: str, vertices: int, rms: Both, worst: Both) -> None:
    try:
        case = make_case(model, "clean", seed=1)
    except datasets.Unavailable as reason:
        pytest.skip(str(reason))
    rows: list[dict[str, float]] = []
    for seed in SEEDS:
        document = document_of(case.points)
        result = reconstruct(document, targetvertnum=vertices, randomseed=seed)
        assert (result["vertices"], result["genus"], result["components"]) == (vertices, 0, 1)
        mesh = document.current_mesh()
        row = metrics.distances(
            np.array(mesh.vertex_matrix()),
            np.array(mesh.face_matrix()),
            case.reference_points,
            case.reference_faces,
        )
        assert row["max_to_mesh"] < worst.to_mesh, seed
        assert row["max_to_surface"] < worst.to_surface, seed
        rows.append(row)
    assert np.mean([row["rms_to_mesh"] for row in rows]) < rms.to_mesh
    assert np.mean([row["rms_to_surface"] for row in rows]) < rms.to_surface


def test_a_start_that_misses_a_fold_is_not_trusted() -> None:
    # Grids up to 128 disagree on these folds. One has four parts with five handles, misses 390 of
    # 119,000 points, nearly all of them in one fold, and was believed: 0.06 / 0.07 % at 20,000
    # vertices, where growth from the tetrahedron has 0.02 / 0.02 %.
    try:
        case = make_case("cortex", "clean", seed=2)
    except datasets.Unavailable as reason:
        pytest.skip(str(reason))
    result = reconstruct(document_of(case.points), targetvertnum=3000)
    assert (result["genus"], result["components"]) == (0, 1)
