"""Draws a figure: meshes side by side, each with its number of vertices below."""

from __future__ import annotations

import os
from io import BytesIO

import numpy as np

# Before VTK is loaded: draw through EGL, without a look for an X server.
os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
import pyvista

from paper.reported import MODELS, Model
from paper.runs import Mesh

PANEL = (400, 440)  # pixels
WIREFRAME_PANEL = (900, 900)
SURFACE_COLOUR = "#f3ead8"
EDGE_COLOUR = "#26221c"


def draw_figure(panels: list[tuple[str, Mesh]], wireframe: bool) -> bytes:
    """Return a PNG of the meshes, each given with its model's name, from left to right."""
    width, height = WIREFRAME_PANEL if wireframe else PANEL
    plotter = pyvista.Plotter(
        off_screen=True,
        shape=(1, len(panels)),
        window_size=[width * len(panels), height],
        border=False,
    )
    plotter.set_background("white", all_renderers=True)
    for column, (model, mesh) in enumerate(panels):
        plotter.subplot(0, column)
        _add(plotter, mesh, wireframe)
        _look_at(plotter, MODELS[model], mesh)
        plotter.add_text(
            f"{len(mesh.vertices):,}", position="lower_edge", font_size=12, color="black"
        )
    plotter.enable_anti_aliasing("ssaa")
    picture = BytesIO()
    plotter.screenshot(picture)
    plotter.close()
    return picture.getvalue()


def _add(plotter: pyvista.Plotter, mesh: Mesh, wireframe: bool) -> None:
    """Flat facets, as the paper's; a wireframe hides what lies behind the surface."""
    plotter.add_mesh(
        pyvista.PolyData.from_regular_faces(mesh.vertices, mesh.faces),
        color="white" if wireframe else SURFACE_COLOUR,
        show_edges=wireframe,
        edge_color=EDGE_COLOUR,
        line_width=2.0,
        lighting=not wireframe,
        ambient=0.2,
        diffuse=0.85,
        specular=0.1,
    )


def _look_at(plotter: pyvista.Plotter, model: Model, mesh: Mesh) -> None:
    centre = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    plotter.camera_position = [centre + np.array(model.view), centre, model.up]
    plotter.reset_camera()
    plotter.camera.zoom(1.2)
    plotter.camera.SetWindowCenter(0.0, -0.08)  # up, out of the caption's way
