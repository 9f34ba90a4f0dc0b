# SPDX-License-Identifier: GPL-3.0-or-later
"""Fields of the dialog that change nothing under some condition: said there, and so."""

from __future__ import annotations

import ctypes
import json
from pathlib import Path

import numpy as np
import pytest
from documents import FILTER, Percentage, document_of, reconstruct, sphere_points

pytestmark = pytest.mark.usefixtures("plugin")

STARTING_MESH, LEARNED = 0, 1
OPEN = 1
# A ball whose top is missing: a hole that 10 % of the diagonal leaves, and 90 % closes.
HOLE = 0.5  # of the radius, along z


@pytest.fixture(scope="module")
def holed() -> np.ndarray:
    points = sphere_points(4000, seed=1)
    return points[points[:, 2] < HOLE]


def faces(points: np.ndarray, **parameters: object) -> list[list[int]]:
    """Faces of the result; a second layer is there to start from."""
    document = document_of(points)
    document.create_cube()
    document.set_current_mesh(0)
    reconstruct(document, targetvertnum=300, **parameters)
    return document.current_mesh().face_matrix().tolist()


def test_the_dialog_says_which_fields_may_be_without_effect(plugin: Path) -> None:
    library = ctypes.CDLL(str(plugin))
    library.neuralmesh_documentation.restype = ctypes.c_char_p
    (parameters,) = (
        filter_["parameters"]
        for filter_ in json.loads(library.neuralmesh_documentation())
        if filter_["name"] == FILTER
    )
    helps = {parameter["name"]: parameter["help"] for parameter in parameters}
    said = {name for name, text in helps.items() if "without effect" in text.lower()}
    assert said == {"boundaries", "maxholesize", "startmesh", "startlayer", "transferattributes"}
    assert "To be empty unless the Source is a point file." in helps["pointfile"]


@pytest.mark.parametrize(
    ("field", "condition", "otherwise"),
    [
        ({"boundaries": OPEN}, {"topology": STARTING_MESH}, {"topology": LEARNED}),
        (
            {"maxholesize": Percentage(90)},
            {"topology": STARTING_MESH},
            {"topology": LEARNED, "boundaries": OPEN},
        ),
        ({"startmesh": 4}, {"topology": LEARNED}, None),
        ({"startlayer": 1}, {"startmesh": 2}, None),
    ],
    ids=["boundaries", "maxholesize", "tetrahedron", "startlayer"],
)
def test_a_field_that_is_said_to_be_without_effect_is(
    field: dict[str, object],
    condition: dict[str, object],
    otherwise: dict[str, object] | None,
    holed: np.ndarray,
) -> None:
    assert faces(holed, **condition, **field) == faces(holed, **condition)
    if otherwise is not None:
        assert faces(holed, **otherwise, **field) != faces(holed, **otherwise)
