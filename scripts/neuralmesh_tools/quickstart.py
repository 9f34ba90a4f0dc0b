# SPDX-License-Identifier: GPL-3.0-or-later
"""Reconstructs the Stanford bunny from its points alone and draws cloud and mesh side by side.

Run by scripts/quickstart, after the plugin has been built. Writes bunny.ply and bunny.png.
Exit codes: 0 done, 1 the plugin is missing or the filter failed, 2 usage.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

import numpy as np
import pymeshlab
import pyvista

from neuralmesh_tools.command_line import add_plugin, parser_of
from neuralmesh_tools.drawing import Picture
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.layers import arrays_of, details, document_of, load_plugin, read_document
from neuralmesh_tools.project import (
    RECONSTRUCT,
    ROOT,
    PluginMissing,
    require_plugin,
    sample_meshes,
)

VIEW_SIZE = (900, 900)
VIEW = (-0.35, 0.25, 1.0)  # from the bunny, which sits with y up, to the viewer
UP = (0.0, 1.0, 0.0)
ZOOM = 1.25
POINT_COLOURS = ("#c9dcec", "#5f94c0", "#0f3d66")  # far to near
SURFACE_COLOUR = "#fbf0dc"
EDGE_COLOUR = "#4a4438"


def parse_arguments() -> argparse.Namespace:
    """Read the command line; exits with 2 on a count below 4."""
    parser = parser_of(__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "out", help="folder (default: out)")
    parser.add_argument("--vertices", type=int, default=5000, help="of the mesh (default 5000)")
    add_plugin(parser)
    options = parser.parse_args()
    if options.vertices < 4:
        parser.error("--vertices must be at least 4")
    return options


def draw(
    points: Points, vertices: Points, faces: Faces, view_size: tuple[int, int] = VIEW_SIZE
) -> bytes:
    """Return a picture of the points (n, 3) and the mesh, (v, 3) and (f, 3), side by side."""
    picture = Picture(2, view_size)
    picture.view().add_points(
        pyvista.PolyData(points),
        scalars=points @ np.array(VIEW),  # the points' far side shows through: paler
        cmap=list(POINT_COLOURS),
        show_scalar_bar=False,
        point_size=view_size[0] / 200,
        render_points_as_spheres=True,
        lighting=False,
    )
    picture.look_at(points, VIEW, UP, f"{len(points):,} points", ZOOM)
    picture.view()
    style = {"color": SURFACE_COLOUR, "edge_color": EDGE_COLOUR, "line_width": view_size[0] / 1125}
    picture.add_mesh(vertices, faces, show_edges=True, **style)
    picture.look_at(points, VIEW, UP, f"{len(vertices):,} vertices", ZOOM)
    return picture.png()


def main() -> int:
    """Reconstruct, save, draw, and print what came out."""
    options = parse_arguments()
    points, _ = arrays_of(read_document(sample_meshes() / "bunny.obj"))
    document = document_of(points, label="bunny")
    start = time.perf_counter()
    try:
        load_plugin(require_plugin(options.plugin))
        result = document.apply_filter(RECONSTRUCT, targetvertnum=options.vertices)
    except PluginMissing as problem:
        print(problem, file=sys.stderr)
        return 1
    except pymeshlab.PyMeshLabException as problem:
        print(f"the filter failed: {details(problem)}", file=sys.stderr)
        return 1
    seconds = time.perf_counter() - start

    surface, picture = options.out / "bunny.ply", options.out / "bunny.png"
    options.out.mkdir(parents=True, exist_ok=True)
    document.save_current_mesh(str(surface))
    write_in_one_step(picture, draw(points, *arrays_of(document)))

    print(f"input     {len(points)} points, no normals")
    print(
        f"result    {result['vertices']} vertices, {result['faces']} faces, "
        f"genus {result['genus']}, {result['components']} component(s)"
    )
    print(f"time      {seconds:.2f} s")
    print(f"files     {surface}  {picture}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
