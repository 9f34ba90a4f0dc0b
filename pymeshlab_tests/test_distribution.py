# SPDX-License-Identifier: GPL-3.0-or-later
"""What brings the project to people: package pages, conda, a container, a citation, a notebook."""

from __future__ import annotations

import re
import subprocess
import sys
import tarfile
import tomllib
from importlib.metadata import files
from pathlib import Path
from typing import Any

import nbformat
import pytest
import rattler_build
from nbclient import NotebookClient

from neuralmesh_tools.project import ROOT, SCRIPTS
from neuralmesh_tools.release.check import NOTICES, check_notices

TOOLS = Path(sys.executable).parent
PROJECTS = [ROOT / "pyproject.toml", ROOT / "python/neuralmesh/pyproject.toml"]
RECIPE = ROOT / "packaging/conda/recipe.yaml"
DOCKERFILE = ROOT / "packaging/Dockerfile"
NOTEBOOKS = sorted((ROOT / "docs/notebooks").glob("*.ipynb"))


def metadata(project: Path) -> dict[str, Any]:
    """What a package says of itself."""
    return tomllib.loads(project.read_text("utf-8"))["project"]


PROJECT = metadata(PROJECTS[1])

# ------------------------------------------------------------------------------- package pages


@pytest.mark.parametrize("project", PROJECTS, ids=["pymeshlab_neuralmesh", "neuralmesh"])
def test_package_page_shows_all_that_it_names(project: Path) -> None:
    page = (project.parent / metadata(project)["readme"]).read_text("utf-8")
    assert len(page.splitlines()) > 10
    # A package page is on another host, where links and pictures of the checkout lead nowhere.
    targets = re.findall(r"\]\(([^)]*)\)|(?:src|href)=\"([^\"]*)\"", page)
    assert [a or b for a, b in targets if not (a or b).startswith(("https://", "#"))] == []


@pytest.mark.parametrize("project", PROJECTS, ids=["pymeshlab_neuralmesh", "neuralmesh"])
def test_package_says_by_whom_and_for_which_python_it_is(project: Path) -> None:
    said = metadata(project)
    assert said["authors"]
    assert said["license"] == "GPL-3.0-or-later"
    assert said["requires-python"] == ">=3.10"
    assert "Operating System :: POSIX :: Linux" in said["classifiers"]


# ------------------------------------------------------------------------------------- licences


@pytest.mark.parametrize("project", PROJECTS, ids=["pymeshlab_neuralmesh", "neuralmesh"])
def test_wheels_hold_the_licence_and_the_notices_of_others(project: Path) -> None:
    assert metadata(project)["license-files"] == list(NOTICES)
    for name in NOTICES:
        assert (project.parent / name).read_bytes() == (ROOT / name).read_bytes()


def test_archives_and_conda_packages_hold_them_too() -> None:
    (copied,) = re.findall(r"^ +cp (.*) ", (SCRIPTS / "release").read_text("utf-8"), re.MULTILINE)
    assert set(NOTICES) <= set(copied.split())
    (recipe, *_) = rendered("linux-64")
    assert recipe["about"]["license_file"] == [f"project/{name}" for name in NOTICES]


def test_notices_are_those_of_the_sources_that_are_compiled_in() -> None:
    command = [SCRIPTS / "setup", "--print-muparser-source"]
    muparser = subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    (nanobind,) = (f for f in files("nanobind") or [] if f.match("licenses/LICENSE"))
    notices = (ROOT / NOTICES[1]).read_text("utf-8")
    for licence in (Path(muparser) / "LICENSE", Path(str(nanobind.locate()))):
        assert licence.read_text("utf-8").strip() in notices


def test_an_archive_without_notices_is_no_release(tmp_path: Path) -> None:
    for held in (NOTICES, NOTICES[:1]):
        with tarfile.open(tmp_path / f"{len(held)}.tar.gz", "w:gz") as tar:
            for name in held:
                tar.add(ROOT / name, f"neural-mesh/{name}")
    check_notices(tmp_path / "2.tar.gz")
    with pytest.raises(RuntimeError, match=r"1\.tar\.gz lacks THIRD_PARTY_NOTICES\.txt"):
        check_notices(tmp_path / "1.tar.gz")


# --------------------------------------------------------------------------------------- conda


def rendered(platform: str) -> list[dict[str, Any]]:
    """The recipe for a platform, one for each Python."""
    target = rattler_build.PlatformConfig(target_platform=platform)
    variants = rattler_build.VariantConfig.from_file_with_context(
        RECIPE.parent / "variants.yaml", rattler_build.JinjaConfig(platform=target)
    )
    recipe = rattler_build.Stage0Recipe.from_file(RECIPE)
    config = rattler_build.RenderConfig(platform=target)
    return [variant.recipe.to_dict() for variant in recipe.render(variants, config)]


@pytest.mark.parametrize("platform", ["linux-64", "linux-aarch64", "osx-arm64", "win-64"])
def test_conda_recipe_renders_for_each_python(platform: str) -> None:
    recipes = rendered(platform)
    builds = [recipe["build"]["string"][:5] for recipe in recipes]
    assert builds == ["py310", "py311", "py312", "py313", "py314"]
    assert all(recipe["package"]["version"] == PROJECT["version"] for recipe in recipes)


def test_conda_recipe_needs_what_the_package_needs() -> None:
    (recipe, *_) = rendered("linux-64")
    # conda-forge's names differ in one.
    wanted = {need.replace("lazrs", "lazrs-python") for need in PROJECT["dependencies"]}
    needs = {need.replace(" ", "") for need in recipe["requirements"]["run"]} - {"python"}
    assert needs == wanted
    build = tomllib.loads(PROJECTS[1].read_text("utf-8"))["build-system"]["requires"]
    assert set(build) <= {need.replace(" ", "") for need in recipe["requirements"]["host"]}


# ----------------------------------------------------------------------------------- container


def test_hadolint_finds_nothing_in_the_dockerfile() -> None:
    run = subprocess.run(
        [TOOLS / "hadolint", DOCKERFILE], capture_output=True, text=True, check=False
    )
    assert run.stdout + run.stderr == ""
    assert run.returncode == 0


def test_dockerfile_copies_what_is_there() -> None:
    text = DOCKERFILE.read_text("utf-8")
    sources = re.findall(r"^COPY (?!--from)(\S+)", text, re.MULTILINE)
    assert sources == ["scripts/setup", "."]
    assert all((ROOT / source).exists() for source in sources)
    ignored = DOCKERFILE.with_name("Dockerfile.dockerignore").read_text("utf-8").split()
    assert {".venv", "build", "out"} <= set(ignored)


# ------------------------------------------------------------------------- citation, notebooks


def test_citation_is_valid() -> None:
    command = [TOOLS / "cffconvert", "--validate", "-i", ROOT / "CITATION.cff"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_holds_no_outputs(path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(cell.outputs == [] and cell.execution_count is None for cell in cells)


@pytest.mark.filterwarnings("default::DeprecationWarning")
@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_notebook_runs(path: Path, tmp_path: Path) -> None:
    notebook = nbformat.read(path, as_version=4)
    NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    shown = "\n".join(
        output.get("text") or output.get("data", {}).get("text/plain", "")
        for cell in notebook.cells
        for output in cell.get("outputs", [])
    )
    assert "'vertices': 2000, 'faces': 4000, 'genus': 1" in shown.replace("\n", "")
    assert "2000" in shown.splitlines()[-1]
    assert (tmp_path / "out/torus.ply").is_file()
