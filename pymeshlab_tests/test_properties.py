# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever cloud and legal parameters: a mesh that keeps every promise, or a sentence that is true.

The same 500 cases each time; --property-seed takes others, --property-cases another number.
"""

from __future__ import annotations

from collections.abc import Iterator

import hypothesis
import numpy as np
import pytest
from documents import torus_mesh
from hypothesis import strategies as st

from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.properties import promises
from neuralmesh_tools.properties.claims import false_claim
from neuralmesh_tools.properties.inputs import Case, Recipe, pick_case
from neuralmesh_tools.properties.judging import judge, new_process

PARTS = 10
# Of these, run by the plugin in PyMeshLab; the others by the package, which is the same code.
PLUGIN_PARTS = 1


@pytest.fixture(scope="module")
def process() -> Iterator[IsolatedProcess]:
    with new_process() as process:
        yield process


@st.composite
def cases(draw: st.DrawFn) -> Case:
    return pick_case(lambda options: draw(st.sampled_from(options)))


@pytest.mark.parametrize("part", range(PARTS))
def test_a_case_ends_in_a_sound_mesh_or_in_a_true_sentence(
    part: int, process: IsolatedProcess, pytestconfig: pytest.Config
) -> None:
    runner = "by_plugin" if part < PLUGIN_PARTS else "by_package"

    @hypothesis.seed(PARTS * pytestconfig.getoption("--property-seed") + part)
    @hypothesis.settings(
        max_examples=pytestconfig.getoption("--property-cases") // PARTS,
        deadline=None,
        database=None,
        suppress_health_check=list(hypothesis.HealthCheck),
    )
    @hypothesis.given(cases())
    def check(case: Case) -> None:
        assert judge(process, runner, case) == ""

    check()


# What the checks themselves find.


def test_a_mesh_with_a_fault_is_found() -> None:
    torus = torus_mesh()
    vertices, faces = torus.vertex_matrix(), torus.face_matrix().astype(np.int32)
    assert promises.not_manifold(vertices, faces) == ""
    assert promises.inside_out(vertices, faces) == ""
    assert promises.inside_out(vertices, faces[:, ::-1]) == "component 0 is inside out"
    turned = np.vstack([faces[:-1], faces[-1:, ::-1]])
    assert "same direction" in promises.not_manifold(vertices, turned)
    assert "of no face" in promises.not_manifold(np.vstack([vertices, [[0, 0, 0]]]), faces)
    pinched = np.where(faces == 50, 0, faces)
    kept = np.vstack([vertices[:50], vertices[51:]])
    pinched = np.where(pinched > 50, pinched - 1, pinched)
    assert promises.not_manifold(kept, pinched) == "fans meet at a vertex"
    assert promises.far_outside(1.1 * vertices, vertices) == ""
    assert "outside the box" in promises.far_outside(1.2 * vertices, vertices)


def test_a_figure_that_is_not_true_is_found() -> None:
    torus = torus_mesh()
    vertices, faces = torus.vertex_matrix(), torus.face_matrix().astype(np.int32)
    info = {"vertices": 96, "faces": 192, "components": 1, "boundary_loops": 0, "genus": 1}
    info |= {"valence_histogram": [0] * 6 + [96], "rms_error": 0.1, "max_error": 0.2}
    info |= {"coverage": 1.0, "unsupported_area": 0.0}
    assert promises.false_figure(vertices, faces, info) == ""
    for name in ("vertices", "faces", "components", "boundary_loops", "genus"):
        wrong = promises.false_figure(vertices, faces, info | {name: 7})
        assert wrong == f"{name} is {info[name]}, but 7 is told"
    assert promises.false_figure(vertices, faces, info | {"rms_error": 0.3})
    # Two faces with one vertex in common are taken out: two boundaries.
    opened = np.delete(faces, [0, 100], axis=0)
    assert "boundary_loops is 2" in promises.false_figure(vertices, opened, info | {"faces": 190})


@pytest.mark.parametrize(
    ("sentence", "shape", "is_true"),
    [
        ("All points lie on a line: there is no surface to reconstruct.", "line", True),
        ("All points lie on a line: there is no surface to reconstruct.", "plane", False),
        (
            "All points but 1 isolated one lie on a plane: a closed surface cannot be fitted to "
            "them. Use topology=1, which makes a sheet of them.",
            "plane and one",
            True,
        ),
        (
            "All points lie on a plane: a closed surface cannot be fitted to them. Use topology=1, "
            "which makes a sheet of them.",
            "plane and one",
            False,
        ),
        ("All points lie in one place: there is no surface to reconstruct.", "line", False),
        ("Only 3 distinct points: a closed surface needs at least 4.", "line", False),
        (
            "1 of 50 points have coordinates that are NaN or infinite (the first is point 3). "
            "Remove them and try again.",
            "line",
            False,
        ),
        (
            "targetvertnum is 51, but there are only 50 distinct points to draw from: at most 50 "
            "vertices are possible.",
            "sphere",
            True,
        ),
        (
            "targetvertnum is 51, but there are only 49 distinct points to draw from: at most 49 "
            "vertices are possible.",
            "sphere",
            False,
        ),
        ("Something went wrong.", "sphere", False),
    ],
)
def test_a_sentence_is_told_from_one_that_is_not_true(
    sentence: str, shape: str, is_true: bool
) -> None:
    case = Case(Recipe(shape, 50, seed=1), {"targetvertnum": 51})
    assert (false_claim(sentence, case) == "") == is_true
