# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a figure: meshes side by side, each with its number of vertices below."""

from __future__ import annotations

from neuralmesh_tools.drawing import Picture
from neuralmesh_tools.paper.reported import MODELS
from neuralmesh_tools.paper.runs import Mesh

PANEL = (400, 440)  # pixels
WIREFRAME_PANEL = (900, 900)
SURFACE_COLOUR = "#f3ead8"
EDGE_COLOUR = "#26221c"


def draw_figure(panels: list[tuple[str, Mesh]], wireframe: bool) -> bytes:
    """Return a PNG of the meshes, each given with its model's name, from left to right.

    Flat facets, as the paper's; a wireframe hides what lies behind the surface.
    """
    picture = Picture(len(panels), WIREFRAME_PANEL if wireframe else PANEL)
    for name, mesh in panels:
        model = MODELS[name]
        picture.view()
        picture.add_mesh(
            mesh.vertices,
            mesh.faces,
            color="white" if wireframe else SURFACE_COLOUR,
            show_edges=wireframe,
            edge_color=EDGE_COLOUR,
            line_width=2.0,
            lighting=not wireframe,
        )
        picture.look_at(mesh.vertices, model.view, model.up, f"{len(mesh.vertices):,}")
    return picture.png()
