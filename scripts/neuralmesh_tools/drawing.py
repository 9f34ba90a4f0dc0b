# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures without a screen, by PyVista: a row of views, each with a caption."""

from __future__ import annotations

import os
from io import BytesIO

import numpy as np

# Before VTK is loaded: draw through EGL, without a look for an X server.
os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
import pyvista

from neuralmesh_tools.geometry import Faces, Points

Direction = tuple[float, float, float]


class Picture:
    """A row of views on white, to be filled from left to right."""

    def __init__(self, views: int, view_size: tuple[int, int]) -> None:
        """views: how many; view_size: width and height of each, in pixels."""
        width, height = view_size
        self.plotter = pyvista.Plotter(
            off_screen=True, shape=(1, views), window_size=[width * views, height], border=False
        )
        self.plotter.set_background("white", all_renderers=True)
        self._next = 0

    def view(self) -> pyvista.Plotter:
        """Go on to the next view and return the plotter, whose calls then draw there."""
        self.plotter.subplot(0, self._next)
        self._next += 1
        return self.plotter

    def add_mesh(self, points: Points, faces: Faces, **style: object) -> None:
        """Draw a mesh, (n, 3) and (m, 3), in flat facets; style: as pyvista's add_mesh takes it."""
        light = {"ambient": 0.25, "diffuse": 0.8, "specular": 0.1}
        mesh = pyvista.PolyData.from_regular_faces(points, faces)
        self.plotter.add_mesh(mesh, **light | style)

    def look_at(
        self, points: Points, view: Direction, up: Direction, caption: str, zoom: float = 1.2
    ) -> None:
        """Turn the view to points (n, 3): view leads from them to the eye. The caption is below."""
        centre = (points.min(axis=0) + points.max(axis=0)) / 2
        self.plotter.camera_position = [centre + np.array(view), centre, up]
        self.plotter.reset_camera()
        self.plotter.camera.zoom(zoom)
        self.plotter.camera.SetWindowCenter(0.0, -0.08)  # up, out of the caption's way
        self.plotter.add_text(caption, position="lower_edge", font_size=12, color="black")

    def png(self) -> bytes:
        """Return the picture; nothing can be drawn after that."""
        self.plotter.enable_anti_aliasing("ssaa")
        picture = BytesIO()
        self.plotter.screenshot(picture)
        self.plotter.close()
        return picture.getvalue()
