#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reconstructs the Stanford bunny from its points alone and draws cloud and mesh side by side.

Run by scripts/quickstart, after the plugin has been built. Writes bunny.ply and bunny.png.
Exit codes: 0 done, 1 the plugin is missing or the filter failed, 2 usage.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from pathlib import Path

import numpy as np
import pymeshlab

# Before VTK is loaded: draw through EGL, without a look for an X server.
os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
import pyvista

ROOT = Path(__file__).resolve().parent.parent
DEFAULT_PLUGIN = ROOT / "build" / "pymeshlab" / "libfilter_neuralmesh.so"
BUNNY = Path(pymeshlab.__file__).resolve().parent / "tests" / "sample_meshes" / "bunny.obj"
FILTER = "generate_surface_reconstruction_neural_mesh"

PICTURE_SIZE = (1800, 900)
VIEW = np.array([-0.35, 0.25, 1.0])  # from the bunny, which sits with y up, to the viewer
POINT_COLOURS = ("#c9dcec", "#5f94c0", "#0f3d66")  # far to near
SURFACE_COLOUR = "#fbf0dc"
EDGE_COLOUR = "#4a4438"


def parse_arguments() -> argparse.Namespace:
    """Read the command line; exits with 2 on a count below 4."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--out", type=Path, default=ROOT / "out", help="folder (default: out)")
    parser.add_argument("--vertices", type=int, default=5000, help="of the mesh (default 5000)")
    parser.add_argument("--plugin", type=Path, default=DEFAULT_PLUGIN, help="the built plugin")
    options = parser.parse_args()
    if options.vertices < 4:
        parser.error("--vertices must be at least 4")
    return options


def bunny_points() -> np.ndarray:
    """Return the vertices of bunny.obj, shape (28088, 3); its faces are left behind."""
    source = pymeshlab.MeshSet(verbose=False)
    source.load_new_mesh(str(BUNNY))
    return source.current_mesh().vertex_matrix()


def draw(points: np.ndarray, vertices: np.ndarray, faces: np.ndarray, path: Path) -> None:
    """Write a picture of the points (n, 3) and the mesh, (v, 3) and (f, 3), side by side."""
    plotter = pyvista.Plotter(
        off_screen=True, shape=(1, 2), window_size=list(PICTURE_SIZE), border=False
    )
    plotter.set_background("white", all_renderers=True)
    plotter.subplot(0, 0)
    depth = points @ VIEW / np.linalg.norm(VIEW)
    plotter.add_points(
        pyvista.PolyData(points),
        scalars=depth,  # the points' far side shows through: paler
        cmap=list(POINT_COLOURS),
        show_scalar_bar=False,
        point_size=4.5,
        render_points_as_spheres=True,
        lighting=False,
    )
    caption(plotter, f"{len(points):,} points")
    plotter.subplot(0, 1)
    plotter.add_mesh(
        pyvista.PolyData.from_regular_faces(vertices, faces),
        color=SURFACE_COLOUR,
        show_edges=True,
        edge_color=EDGE_COLOUR,
        line_width=0.8,
        ambient=0.25,
        diffuse=0.8,
        specular=0.1,
    )
    caption(plotter, f"{len(vertices):,} vertices")
    plotter.link_views()
    centre = points.mean(axis=0)
    plotter.camera_position = [centre + VIEW, centre, (0.0, 1.0, 0.0)]
    plotter.reset_camera()
    plotter.camera.zoom(1.25)
    plotter.camera.SetWindowCenter(0.0, -0.07)  # up, out of the captions' way
    plotter.enable_anti_aliasing("ssaa")
    plotter.screenshot(str(path))
    plotter.close()


def caption(plotter: pyvista.Plotter, text: str) -> None:
    """Write a line under the current half of the picture."""
    plotter.add_text(text, position="lower_edge", font_size=14, color="black")


def main() -> int:
    """Reconstruct, save, draw, and print what came out."""
    options = parse_arguments()
    if not options.plugin.is_file():
        print(f"{options.plugin} is missing: run scripts/build", file=sys.stderr)
        return 1
    pymeshlab.load_plugin(str(options.plugin))
    points = bunny_points()
    document = pymeshlab.MeshSet(verbose=False)
    document.add_mesh(pymeshlab.Mesh(points), "bunny")
    start = time.perf_counter()
    try:
        result = document.apply_filter(FILTER, targetvertnum=options.vertices)
    except pymeshlab.PyMeshLabException as problem:
        print(f"the filter failed: {problem}", file=sys.stderr)
        return 1
    seconds = time.perf_counter() - start

    options.out.mkdir(parents=True, exist_ok=True)
    surface, picture = options.out / "bunny.ply", options.out / "bunny.png"
    document.save_current_mesh(str(surface))
    mesh = document.current_mesh()
    draw(points, mesh.vertex_matrix(), mesh.face_matrix(), picture)

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
