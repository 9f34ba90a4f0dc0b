# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of the topology table: data, vertices, and what a right mesh of them is."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

from neuralmesh_tools import generated_clouds as clouds
from neuralmesh_tools.benchmarks.topology import data
from neuralmesh_tools.benchmarks.topology.data import SURFACE_SAMPLES
from neuralmesh_tools.quality import shapes

# Of the largest piece of the scan's own mesh: its border and 21 holes; and what these add to its
# area when they are filled.
FACE_LOOPS = 22
FACE_GAPS = 0.067


# Points of which one half is thinned, at the least.
LEAST_HALVED = 20_000


@dataclass(frozen=True)
class Expected:
    """What makes a mesh right. Each mesh also has to be two-manifold, oriented and of exact count.

    components, genus: the sum over components. loops: boundary loops, from the fewest to the most.
    genus None: not judged. whole: nearly all of the data is covered (see judge.LEAST_COVERED).
    no_surplus: hardly any surface where there are no data (see judge.SIZE_TOLERANCE), but for gaps,
    the share of the area in holes of the data that maxholesize closes.
    no_crossing: no self-intersection, whatever the condition; on clean points that holds for all.
    volume, diagonal: of the enclosed body and of its bounding box. window: half the width of a
    square about the z axis where no face may be.
    """

    components: int = 1
    genus: int | None = 0
    loops: tuple[int, int] = (0, 0)
    whole: bool = False
    no_surplus: bool = False
    gaps: float = 0.0
    no_crossing: bool = False
    volume: float | None = None
    diagonal: float | None = None
    window: float | None = None


@dataclass(frozen=True)
class RowOf:
    """Data and what is expected of their mesh, with open or closed boundaries.

    at_least: of 5 runs on clean points that have to be right; in other conditions, one less.
    points: drawn, where the condition is not sparse. sparse: whether that condition applies. Half
    of fewer points than LEAST_HALVED would be too sparse for their shape.
    """

    maker: data.Maker
    expected: Expected
    at_least: int = 5
    vertices: int = 5_000
    points: int = SURFACE_SAMPLES
    open: bool = False
    sparse: bool = True

    @property
    def conditions(self) -> list[str]:
        """The conditions that apply."""
        applies = {"sparse": self.sparse, "half": self.points >= LEAST_HALVED}
        return [name for name in data.CONDITIONS if applies.get(name, True)]

    @property
    def parameters(self) -> dict[str, int]:
        """Parameters of the filter that differ from its defaults."""
        return {"topology": 1, "boundaries": 1} if self.open else {"topology": 1}


def _body(maker: data.Maker, genus: int = 0, components: int = 1, **settings: int) -> RowOf:
    return RowOf(maker, Expected(components, genus), **settings)


def _sheets() -> dict[str, RowOf]:
    """Open surfaces, each to be kept open, and each to be closed."""
    # The last three are sparse as they are: half as many vertices as points, the filter's default.
    surfaces = {
        "hemisphere": (partial(clouds.cap, half_angle=90), 1, {}),
        "flat-square": (clouds.flat_square, 1, {}),
        "cap": (partial(clouds.cap, half_angle=60), 1, {}),
        "tube": (clouds.tube, 2, {}),
        "bent-sheet": (clouds.bent_sheet, 1, {"points": 3_000, "vertices": 1_500}),
        "terrain": (lambda *_: clouds.terrain_grid(), 1, {"points": 2_400, "vertices": 1_200}),
        "small-cap": (partial(clouds.cap, half_angle=60), 1, {"points": 750, "vertices": 375}),
    }
    rows = {}
    for name, (generate, loops, settings) in surfaces.items():
        maker = data.generated(generate)
        settings = {"sparse": not settings, **settings}
        opened = Expected(loops=(loops, loops), whole=True, no_surplus=True)
        closed = Expected(whole=True, no_crossing=True)
        rows[name] = RowOf(maker, opened, open=True, **settings)
        rows[f"{name}-closed"] = RowOf(maker, closed, **settings)
    return rows


def _open_scan(maker: data.Maker, most_loops: int, gaps: float = 0.0) -> RowOf:
    expected = Expected(genus=None, loops=(1, most_loops), no_surplus=True, gaps=gaps)
    return RowOf(maker, expected, at_least=4, open=True)


def _frame(bar: float, points: int) -> RowOf:
    maker = data.sampled(partial(shapes.picture_frame, bar))
    # A tenth short of the bars: a face between points of a bar is not in the hole.
    expected = Expected(genus=1, window=0.9 * (1 - bar))
    return RowOf(maker, expected, at_least=4, points=points, vertices=points // 2)


def _cup(wall: float, points: int, vertices: int) -> RowOf:
    maker = data.generated(partial(clouds.cup, wall=wall))
    expected = Expected(volume=clouds.cup_volume(wall))
    # The larger cloud, thinned out, is the smaller one, thinned out.
    small = points < 10_000
    return RowOf(maker, expected, at_least=4, points=points, vertices=vertices, sparse=small)


def _ball_with_zeros(offset: tuple[float, float, float], zeros: int) -> RowOf:
    maker = data.ball_with_zeros(offset, zeros)
    expected = Expected(diagonal=12**0.5)
    return RowOf(maker, expected, points=5_000, vertices=2_500)


UTM = (512345.6, 5403707.6, 356.1)

ROWS: dict[str, RowOf] = {
    "torus": _body(data.generated(clouds.torus), 1, vertices=2_000),
    "two-spheres": _body(data.generated(clouds.two_spheres), components=2),
    "twenty-spheres": _body(data.generated(clouds.twenty_spheres), components=20),
    "sphere": _body(data.generated(clouds.sphere)),
    "bunny": _body(data.model("bunny")),
    "armadillo": _body(data.model("armadillo")),
    "dino": _body(data.model("dino")),
    "cortex": _body(data.model("cortex"), vertices=20_000, sparse=False),
    **_sheets(),
    "knot1": _body(data.model("knot1"), 1, at_least=4),
    "kitten": _body(data.scan("kitten"), 1, at_least=4, points=5_210, vertices=2_000),
    "elephant": _body(data.model("elephant"), 3, at_least=4),
    "anchor": _body(data.model("anchor"), 4, at_least=4),
    "knot2": _body(data.model("knot2"), 2, 2, at_least=4),
    "frame-0.3": _frame(0.3, 4_000),
    "frame-0.15": _frame(0.15, 4_000),
    "frame-0.1": _frame(0.1, 8_000),
    "mannequin": _open_scan(data.model("mannequin"), 1),
    "face": _open_scan(data.scan("face"), FACE_LOOPS, FACE_GAPS),
    "cup-9%-4000": _cup(0.3, 4_000, 2_000),
    "cup-9%-20000": _cup(0.3, 20_000, 5_000),
    "cup-3%-4000": _cup(0.1, 4_000, 2_000),
    "cup-3%-20000": _cup(0.1, 20_000, 5_000),
    "zeros-100m": _ball_with_zeros((100, 50, 10), 30),
    "zeros-10km": _ball_with_zeros((10_000, 5_000, 10), 30),
    "zeros-utm": _ball_with_zeros(UTM, 30),
    "zero-utm": _ball_with_zeros(UTM, 1),
    "turbine": _body(data.model("turbine"), 11, at_least=3, vertices=20_000, sparse=False),
}
