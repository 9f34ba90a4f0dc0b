# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper (Ivrissimtzis, Jeong, Seidel, SMI 2003) reports, and the models we set beside."""

from __future__ import annotations

from dataclasses import dataclass

VALENCES = ("4", "5", "6", "7", "8", "other")
Counts = tuple[int, int, int, int, int, int]


@dataclass(frozen=True)
class Model:
    """A target space: of the paper, or the public one that stands in for it."""

    title: str
    dataset: str  # of datasets.py; empty for the implicit sphere
    source: int  # parameter of the filter: 0 points, 1 surface
    view: tuple[float, float, float]  # from the model to the viewer
    up: tuple[float, float, float]
    remark: str


MODELS = {
    "sphere": Model(
        "Sphere",
        "",
        0,
        (0.3, 0.4, 1.0),
        (0.0, 1.0, 0.0),
        "the implicit surface x² + y² + z² = 0.5, as in the paper",
    ),
    "bunny": Model(
        "Bunny",
        "bunny",
        0,
        (-0.35, 0.25, 1.0),
        (0.0, 1.0, 0.0),
        "28,088 points, another resolution of the paper's model of 35K",
    ),
    "dino": Model(
        "Dino",
        "dino",
        1,
        (1.0, -0.45, 0.3),
        (0.0, 0.0, 1.0),
        "sampled from the surface of a mesh of 3,916 vertices; the paper has 42K points",
    ),
    "head": Model(
        "Head",
        "mannequin",
        1,
        (0.5, -1.0, 0.1),
        (0.0, 0.0, 1.0),
        "CGAL's mannequin-devil, sampled from the surface of a mesh of 12,977 vertices, which is "
        "open at the neck (the network closes it), in place of the paper's Max-Planck of 100K "
        "points, which no package holds",
    ),
    "armadillo": Model(
        "Armadillo",
        "armadillo",
        1,
        (-0.3, 0.15, -1.0),
        (0.0, 1.0, 0.0),
        "sampled from the surface of a mesh of 26,002 vertices, in place of the paper's Teeth, "
        "which no package holds",
    ),
}


@dataclass(frozen=True)
class Row:
    """A row of Table 1: vertices of each valence."""

    title: str  # as in the paper
    model: str
    vertices: int
    counts: Counts


TABLE_1 = (
    Row("Sphere 1K", "sphere", 1000, (2, 296, 470, 184, 44, 5)),
    Row("Bunny 1K", "bunny", 1000, (7, 274, 490, 186, 42, 2)),
    Row("Max 2K", "head", 2000, (11, 571, 941, 390, 73, 15)),
    Row("Teeth 2K", "armadillo", 2000, (5, 576, 932, 411, 69, 8)),
    Row("Sphere 5K", "sphere", 5000, (10, 1451, 2330, 999, 177, 34)),
    Row("Bunny 5K", "bunny", 5000, (22, 1416, 2364, 987, 177, 35)),
    Row("Dino 5K", "dino", 5000, (24, 1447, 2307, 1001, 190, 32)),
    Row("Teeth 5K", "armadillo", 5000, (17, 1481, 2244, 1043, 189, 27)),
    Row("Max 8K", "head", 8000, (36, 2337, 3652, 1608, 323, 45)),
)


@dataclass(frozen=True)
class Figure:
    """A figure of the paper: models at vertex counts, ascending."""

    number: int
    caption: str
    panels: tuple[tuple[str, int], ...]  # model, vertices
    wireframe: bool = False


def _growing(model: str, *counts: int) -> tuple[tuple[str, int], ...]:
    return tuple((model, count) for count in counts)


FIGURES = (
    Figure(1, "A head, growing", _growing("head", 20, 100, 1000, 2000, 8000)),
    Figure(
        6, "The wireframe of the bunny and of the head", (("bunny", 1000), ("head", 2000)), True
    ),
    Figure(9, "A sphere from an implicit surface", _growing("sphere", 10, 100, 1000, 5000)),
    Figure(10, "The bunny", _growing("bunny", 100, 300, 500, 1000, 5000)),
    Figure(11, "The dinosaur", _growing("dino", 100, 500, 1000, 1500, 2500)),
)
