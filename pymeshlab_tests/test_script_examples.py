# SPDX-License-Identifier: GPL-3.0-or-later
"""scripts/examples: each runs as it stands, and makes what it says."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pymeshlab
import pytest
from PIL import Image

from neuralmesh_tools.project import SCRIPTS

EXAMPLES = SCRIPTS / "examples"

pytestmark = pytest.mark.usefixtures("plugin")

# Polyscope without a screen, closed by itself in the third frame.
MOCK_POLYSCOPE = """
import functools, runpy, sys
import polyscope
polyscope.init = functools.partial(polyscope.init, "openGL_mock")
polyscope.init()
frames = iter(range(3))
polyscope.set_user_callback(lambda: next(frames, None) is None and polyscope.unshow())
runpy.run_path(sys.argv[1])
cloud, mesh = polyscope.get_point_cloud("bunny"), polyscope.get_surface_mesh("bunny neural mesh")
print("structures:", cloud.n_points(), mesh.n_vertices())
"""


def run(*arguments: object, folder: Path) -> str:
    """Run Python in a folder and return what it printed; a failure fails the test."""
    done = subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def vertices_of(path: Path) -> int:
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(path))
    return document.current_mesh().vertex_number()


def test_every_example_is_tested_here():
    tested = Path(__file__).read_text(encoding="utf-8")
    names = [path.name for path in EXAMPLES.iterdir() if path.suffix in (".py", ".mlx")]
    assert len(names) >= 7
    assert [name for name in names if f'"{name}"' not in tested] == []


def test_compare_with_poisson(tmp_path: Path):
    output = run(EXAMPLES / "compare_with_poisson.py", folder=tmp_path)
    line = r"(.+?) +5000 vertices, [\d.]+ s, RMS distance ([\d.]+)"
    found = dict(re.findall(line, output))
    assert list(found) == ["neural mesh", "screened Poisson"]
    # The bunny's diagonal is 1: both stay within 0.1 % of its points.
    assert all(0 < float(distance) < 0.001 for distance in found.values())


def test_levels_of_detail(tmp_path: Path):
    run(EXAMPLES / "levels_of_detail.py", folder=tmp_path)
    for count in (100, 400, 1600):
        assert vertices_of(tmp_path / "out" / "lod" / f"bunny_{count}.ply") == count


def test_progress_display(tmp_path: Path):
    output = run(EXAMPLES / "progress_display.py", folder=tmp_path)
    assert "100%" in output
    assert vertices_of(tmp_path / "bunny_5000.ply") == 5000


def test_picture(tmp_path: Path):
    run(EXAMPLES / "picture.py", folder=tmp_path)
    pixels = np.asarray(Image.open(tmp_path / "bunny_1000.png").convert("RGB"), dtype=int)
    assert pixels.shape == (800, 800, 3)
    # Cream faces: red is 20 or more above blue, lit or not. The bunny fills a quarter or so.
    assert np.mean(pixels[..., 0] - pixels[..., 2] >= 20) > 0.1


def test_viewer(tmp_path: Path):
    output = run("-c", MOCK_POLYSCOPE, EXAMPLES / "viewer.py", folder=tmp_path)
    assert "shown: bunny, bunny neural mesh" in output
    assert "structures: 28088 2000" in output


def apply_script(name: str, source: Path) -> pymeshlab.MeshSet:
    """Load a file and apply a filter script of the examples to it."""
    document = pymeshlab.MeshSet(verbose=False)
    document.load_new_mesh(str(source))
    document.load_filter_script(str(EXAMPLES / name))
    document.apply_filter_script()
    return document


def test_script_makes_a_neural_mesh(sample_meshes: Path):
    document = apply_script("neural_mesh.mlx", sample_meshes / "bunny.obj")
    assert document.mesh_number() == 2
    assert document.current_mesh().vertex_number() == 3000


def test_script_cleans_reconstructs_and_transfers_colour(sample_meshes: Path):
    source = sample_meshes / "chameleon.pts"
    document = apply_script("clean_reconstruct_colour.mlx", source)
    cloud, mesh = document.mesh(0), document.current_mesh()
    assert cloud.vertex_number() < 4594  # all that the file holds: outliers are gone
    assert mesh.vertex_number() == 2000
    points, colours = cloud.vertex_matrix(), cloud.vertex_color_matrix()[:, :3]
    for vertex in range(0, 2000, 100):
        distances = np.linalg.norm(points - mesh.vertex_matrix()[vertex], axis=1)
        # A mean of the points that are nearest to this vertex, two on average, or of those of its
        # neighbours: a mixture of colours around, to half a step of 1/255.
        near = colours[np.argsort(distances)[:40]]
        found = mesh.vertex_color_matrix()[vertex, :3]
        assert (found >= near.min(axis=0) - 1 / 255).all(), vertex
        assert (found <= near.max(axis=0) + 1 / 255).all(), vertex
    # They are the scan's colours, not one for all.
    assert mesh.vertex_color_matrix()[:, :3].std(axis=0).min() > 0.05


def parameter_types(script: Path) -> dict[tuple[str, str], str]:
    """The type of each parameter of a filter script, by filter and name."""
    return {
        (node.attrib["name"], parameter.attrib["name"]): parameter.attrib["type"]
        for node in ElementTree.parse(script).getroot().iter("filter")
        for parameter in node.iter("Param")
    }


@pytest.mark.parametrize(
    ("name", "source"),
    [("neural_mesh.mlx", "bunny.obj"), ("clean_reconstruct_colour.mlx", "chameleon.pts")],
)
def test_scripts_name_types_as_meshlab_saves_them(
    name: str, source: str, sample_meshes: Path, tmp_path: Path
):
    # The desktop goes by these types; PyMeshLab saves scripts with the same code.
    document = apply_script(name, sample_meshes / source)
    document.save_filter_script(str(tmp_path / "saved.mlx"))
    saved, ours = parameter_types(tmp_path / "saved.mlx"), parameter_types(EXAMPLES / name)
    assert ours
    assert {key: saved.get(key) for key in ours} == ours


@pytest.mark.parametrize(
    "name", ["Surface Reconstruction: Neural Mesh", "Neural Mesh Reconstruction"]
)
def test_a_script_may_call_the_reconstruction_by_both_names(
    name: str, mesh_set: pymeshlab.MeshSet, tmp_path: Path
) -> None:
    script = f"<!DOCTYPE FilterScript>\n<FilterScript>\n <filter name='{name}'/>\n</FilterScript>\n"
    (tmp_path / "script.mlx").write_text(script, encoding="utf-8")
    mesh_set.create_sphere()
    mesh_set.load_filter_script(str(tmp_path / "script.mlx"))
    mesh_set.apply_filter_script()
    assert mesh_set.current_mesh().label() == "Sphere neural mesh"
    assert [found for found in pymeshlab.filter_list() if "neural_mesh" in found] == [
        "create_neural_mesh_from_implicit_surface",
        "create_neural_mesh_from_parametric_surface",
        "generate_surface_reconstruction_neural_mesh",
    ]
