# SPDX-License-Identifier: GPL-3.0-or-later
"""What each picture shows: a run of the filter, and how its meshes are drawn."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from neuralmesh_tools import datasets
from neuralmesh_tools import generated_clouds as clouds
from neuralmesh_tools.drawing import Picture
from neuralmesh_tools.geometry import Faces, Points, diagonal, sample_surface
from neuralmesh_tools.layers import arrays_of, document_of
from neuralmesh_tools.metrics import point_distances
from neuralmesh_tools.metrics import valences as count_valences
from neuralmesh_tools.paper.runs import DEFAULTS, PAPERS
from neuralmesh_tools.project import RECONSTRUCT
from neuralmesh_tools.quality.shapes import picture_frame
from neuralmesh_tools.quickstart import draw as draw_cloud_and_mesh

Y_UP = (0.0, 1.0, 0.0)
Z_UP = (0.0, 0.0, 1.0)
BUNNY_VIEW = (-0.35, 0.25, 1.0)  # from the model to the viewer
DINO_VIEW = (1.0, -0.45, 0.3)
FROM_ABOVE = (0.4, -0.8, 0.9)
SURFACE = "#fbf0dc"
EDGES = {"show_edges": True, "edge_color": "#4a4438", "line_width": 0.8}
FAR = "#d1495b"
# Of the diagonal: a face whose middle is further off spans a void. Limbs are 5 to 10 % thick.
FAR_SHARE = 0.02
# Of the diagonal: the end of the scale of errors, in per cent.
ERROR_SCALE = 0.3
# Of valences up to 4, 5, 7, and 8 and more.
VALENCE_COLOURS = ("#08306b", "#2f86d0", "#e8503a", "#7f0000")

Mesh = tuple[Points, Faces]


def grown(points: Points, faces: Faces | None, **parameters: object) -> list[Mesh]:
    """Run the filter on points, or on the surface of faces: the snapshots, then the result."""
    document = document_of(points, faces)
    source = 0 if faces is None else 1
    document.apply_filter(RECONSTRUCT, source=source, **parameters)
    layers = [layer.id() for layer in document][1:]
    return [arrays_of(document, layer) for layer in layers]


def bunny() -> bytes:
    """The bunny's points and its mesh of 5,000 vertices."""
    points, _ = datasets.load("bunny")
    (mesh,) = grown(points, None, targetvertnum=5000)
    return draw_cloud_and_mesh(points, *mesh, view_size=(500, 500))


def growth() -> bytes:
    """The network as it grows on the bunny, from a tetrahedron."""
    points, _ = datasets.load("bunny")
    parameters = {"targetvertnum": 2000, "snapshots": "20,100,500", "surfacefit": False}
    meshes = grown(points, None, topology=0, **parameters)
    picture = Picture(len(meshes), (330, 360))
    for vertices, faces in meshes:
        picture.view()
        picture.add_mesh(vertices, faces, color=SURFACE, **EDGES)
        picture.look_at(points, BUNNY_VIEW, Y_UP, f"{len(vertices):,}", 1.25)
    return picture.png()


def topology() -> bytes:
    """Meshes of clouds with a handle, of two parts, with a thin wall, and with a border."""
    frame, _ = sample_surface(*picture_frame(0.3), 8_000, np.random.default_rng(1))
    scenes = (
        ("a frame", frame, 0),
        ("two spheres", clouds.two_spheres(8_000, 1), 0),
        ("a cup", clouds.cup(12_000, 1, 0.3), 0),
        ("a terrain, open", clouds.terrain_grid(), 1),
    )
    picture = Picture(len(scenes), (330, 330))
    for caption, points, boundaries in scenes:
        target = min(1_500, len(points) // 2)
        ((vertices, faces),) = grown(points, None, targetvertnum=target, boundaries=boundaries)
        picture.view()
        picture.add_mesh(vertices, faces, color=SURFACE, **EDGES)
        picture.look_at(points, FROM_ABOVE, Z_UP, caption, 1.1)
    return picture.png()


def webs() -> bytes:
    """Faces far from the surface while the network is coarse, and what has become of them."""
    surface = datasets.load("dino")
    parameters = {"targetvertnum": 1500, "snapshots": "300", "surfacefit": False}
    meshes = grown(*surface, topology=0, **parameters)
    picture = Picture(len(meshes), (600, 520))
    for vertices, faces in meshes:
        distance = point_distances(vertices[faces].mean(axis=1), *surface)
        is_far = distance > FAR_SHARE * diagonal(surface[0])
        picture.view()
        picture.add_mesh(vertices, faces[~is_far], color=SURFACE, **EDGES)
        if is_far.any():
            picture.add_mesh(vertices, faces[is_far], color=FAR, **EDGES)
        picture.look_at(surface[0], DINO_VIEW, Z_UP, f"{len(vertices):,} vertices")
    return picture.png()


def fit() -> bytes:
    """Distances of 1,000 vertices' faces from the bunny, before the fit and after it."""
    surface = datasets.load("bunny")
    picture = Picture(2, (600, 520))
    for fitted, caption in ((False, "growth alone"), (True, "with the surface fit")):
        ((vertices, faces),) = grown(surface[0], None, targetvertnum=1000, surfacefit=fitted)
        percent = point_distances(vertices[faces].mean(axis=1), *surface)
        percent *= 100 / diagonal(surface[0])
        picture.view()
        style = {"scalars": percent, "cmap": "RdYlBu_r", "clim": (0, ERROR_SCALE)}
        bar = {"title": "% of the diagonal", "n_labels": 4, "position_x": 0.62, "position_y": 0.86}
        bar |= {"width": 0.34, "height": 0.08, "title_font_size": 15, "label_font_size": 14}
        picture.add_mesh(vertices, faces, scalar_bar_args=bar, **style, **EDGES)
        picture.look_at(surface[0], BUNNY_VIEW, Y_UP, caption, 1.25)
    return picture.png()


def valences() -> bytes:
    """Vertices with fewer and more than six neighbours: by the paper's rules and the defaults."""
    points, _ = datasets.load("bunny")
    picture = Picture(2, (600, 520))
    for setting, caption in ((PAPERS, "the paper's rules"), (DEFAULTS, "the defaults")):
        ((vertices, faces),) = grown(points, None, targetvertnum=1000, **setting.parameters)
        valence = count_valences(faces)
        share = 100 * np.mean(valence == 6)
        plotter = picture.view()
        picture.add_mesh(vertices, faces, color="white", **EDGES)
        groups = (valence < 5, valence == 5, valence == 7, valence > 7)
        style = {"point_size": 13, "render_points_as_spheres": True, "lighting": False}
        for members, colour in zip(groups, VALENCE_COLOURS, strict=True):
            if members.any():
                plotter.add_points(vertices[members], color=colour, **style)
        picture.look_at(points, BUNNY_VIEW, Y_UP, f"{caption}: {share:.0f} % have six", 1.25)
    return picture.png()


SCENES: dict[str, Callable[[], bytes]] = {
    "bunny": bunny,
    "growth": growth,
    "topology": topology,
    "webs": webs,
    "fit": fit,
    "valences": valences,
}
