# SPDX-License-Identifier: GPL-3.0-or-later
"""The documents say what is so: snippets run, tables list what there is, links lead on."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from documents import FILTER, IMPLICIT, PARAMETRIC, document_of, reconstruct, sphere_points

from neuralmesh_tools.project import ROOT

DOCUMENTS = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
TEXTS = {path.relative_to(ROOT).as_posix(): path.read_text("utf-8") for path in DOCUMENTS}
README, PARAMETERS = TEXTS["README.md"], TEXTS["docs/parameters.md"]


def blocks(language: str) -> list[str]:
    """Return the code blocks of a language in all documents."""
    fence = re.compile(rf"^```{language}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    return [block for text in TEXTS.values() for block in fence.findall(text)]


SNIPPETS = blocks("python")
COMMANDS = [
    re.split(r"\s+#\s", line.rstrip(" &"))[0]
    for block in blocks("sh")
    for line in block.replace("\\\n", " ").splitlines()
]
SCRIPT_CALL = re.compile(r"(?:\.venv/bin/python )?(scripts/[\w./]+)(.*)")
# Of commands that a test cannot check by --help: who runs what they name.
ELSEWHERE = {
    "git clone URL-OF-THIS-REPOSITORY": "by hand, at each release",
    "neural-mesh-reconstruction/scripts/quickstart": "by hand, at each release",
    "pip install out/release/": "scripts/release, as its check of the wheel",
    "cmake --install": "test_packaging.py",
    "cmake --build": "scripts/build",
    "cmake -G Ninja": "by hand, at each release: it needs another PyMeshLab",
    "NEURALMESH_PLUGIN=": "by hand, at each release: it needs another PyMeshLab",
    "WINEPREFIX=": "by hand: scripts/test_windows does the same by CTest",
    ".venv/bin/dask": "test_batch_cluster.py",
    ".venv/bin/python -m pytest": "scripts/test",
    "pip install build/python/wheel/": "python/neuralmesh/tests/test_package_installed.py",
    "neuralmesh ": "python/neuralmesh/tests/test_package_command.py",
}
BATCHES = [
    command for command in COMMANDS if "scripts/batch.py" in command and "--sch" not in command
]


def section(text: str, title: str) -> str:
    """Return the text between a heading and the next one."""
    found = re.search(rf"^#+ {re.escape(title)}\n(.*?)(?=^#|\Z)", text, re.MULTILINE | re.DOTALL)
    assert found, f"there is no section '{title}'"
    return found.group(1)


def table_rows(text: str) -> list[list[str]]:
    """Return the cells of a table's rows, without its head."""
    lines = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


# ------------------------------------------------------------------------ snippets and commands


def test_there_are_snippets_and_commands() -> None:
    assert len(SNIPPETS) >= 3
    assert len(COMMANDS) >= 20
    assert len(BATCHES) == 1


@pytest.mark.parametrize("code", SNIPPETS)
def test_python_snippet_runs_as_printed(code: str, plugin: Path, tmp_path: Path) -> None:
    # In a folder of its own that shows the build, as the project's root does.
    (tmp_path / "build").symlink_to(plugin.parent.parent, target_is_directory=True)
    # And with the Python package, put together as the wheel has it.
    shutil.copytree(ROOT / "python", tmp_path / "python")
    (tmp_path / "python/pymeshlab_neuralmesh/libfilter_neuralmesh.so").symlink_to(plugin)
    run = subprocess.run(
        [sys.executable, "-c", code],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(tmp_path / "python")},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    if code in README:
        promised = re.search(r"It prints `(.*?)`", README)
        assert promised
        assert promised.group(1) in run.stdout.splitlines()
    saved = re.findall(r'(?:save_current_mesh|neuralmesh\.write)\("(.*?)"', code)
    assert saved
    for name in saved:
        assert (tmp_path / name).stat().st_size > 0


@pytest.mark.parametrize("command", BATCHES)
def test_batch_runs_as_printed(command: str, plugin: Path, tmp_path: Path) -> None:
    for name in (".venv", "build", "scripts"):
        (tmp_path / name).symlink_to(ROOT / name, target_is_directory=True)
    run = subprocess.run(
        ["bash", "-c", command],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=200,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert len(list((tmp_path / "out" / "batch").glob("*.ply"))) == 4


@cache
def help_of(program: str) -> str:
    """What a program in scripts/ says of itself."""
    command = [str(ROOT / program), "--help"]
    if program.endswith(".py"):
        command.insert(0, sys.executable)
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=True).stdout


@pytest.mark.parametrize("command", list(dict.fromkeys(COMMANDS)))
def test_command_names_a_program_and_options_that_are_there(command: str) -> None:
    calls = re.sub(r"\$\(.*?\)", "FILE", command).split("&&")
    for call in map(str.strip, calls):
        if any(call.startswith(known) for known in ELSEWHERE):
            continue
        if preset := re.match(r"ctest --preset (\S+)$", call):
            assert f'"{preset[1]}"' in (ROOT / "CMakePresets.json").read_text("utf-8")
            continue
        found = SCRIPT_CALL.fullmatch(call)
        assert found, f"{call}: neither a program of ours nor in ELSEWHERE"
        program, options = found[1], [word for word in shlex.split(found[2]) if word[:2] == "--"]
        assert (ROOT / program).is_file()
        if options:
            assert [o for o in options if o not in help_of(program)] == []


@pytest.mark.parametrize("name", ["batch", "compare"])
def test_options_that_a_document_explains_are_there(name: str) -> None:
    explained = re.findall(r"^\| `(--[\w-]+)", TEXTS[f"docs/{name}.md"], re.MULTILINE)
    assert len(explained) >= 6
    assert [option for option in explained if option not in help_of(f"scripts/{name}.py")] == []


# ------------------------------------------------------------------------- tables and references


def defaults_of(filter_name: str) -> dict[str, str]:
    """Return a filter's parameters and their defaults as the documents print them."""
    # As many points as it takes for the general default of the target.
    document = document_of(sphere_points(10_000))
    actual = document.filter_parameter_values(filter_name)
    printed = {
        name: f"{value:.6g}" if isinstance(value, float) else str(value)
        for name, value in actual.items()
    }
    if "maxholesize" in actual:  # a percentage, which PyMeshLab gives as a length
        diagonal = document.current_mesh().bounding_box().diagonal()
        printed["maxholesize"] = f"{100 * actual['maxholesize'] / diagonal:.3g} %"
    return printed


def test_parameter_table_lists_all_parameters_with_their_defaults(plugin: Path) -> None:
    rows = table_rows(section(PARAMETERS, "Parameters"))
    assert {row[0].strip("`"): row[1] for row in rows} == defaults_of(FILTER)


def test_main_parameters_are_the_first_of_all_with_the_same_defaults() -> None:
    every = [row[:2] for row in table_rows(section(PARAMETERS, "Parameters"))]
    assert [row[:2] for row in table_rows(section(README, "The six main parameters"))] == every[:6]


OF_LAYERS_ONLY = {"source", "pointfile", "densityfromquality", "transferattributes"}


@pytest.mark.parametrize(
    ("filter_name", "words"),
    [(IMPLICIT, "Of an implicit surface"), (PARAMETRIC, "Of a parametric surface")],
)
def test_tables_of_the_other_filters_list_what_they_have_of_their_own(
    filter_name: str, words: str, plugin: Path
) -> None:
    text = section(PARAMETERS, "Parameters of the other two filters")
    text = text.split(words)[1].split("\nOf a")[0]
    printed = {row[0].strip("`"): row[1] for row in table_rows(text)}
    shown = defaults_of(filter_name)
    for common in set(defaults_of(FILTER)) - OF_LAYERS_ONLY:
        del shown[common]
    assert printed == shown


def test_table_of_results_lists_all_keys(plugin: Path) -> None:
    printed = [
        key
        for row in table_rows(section(PARAMETERS, "What it returns"))
        for key in re.findall(r"`(.*?)`", row[0])
    ]
    result = reconstruct(document_of(sphere_points(50)), targetvertnum=10)
    assert sorted(printed) == sorted(result)


def test_example_tables_list_all_examples() -> None:
    text = TEXTS["docs/examples.md"]
    for folder, kinds in (
        ("scripts/examples", ("py", "mlx")),
        ("pymeshlab_tests/examples", ("py",)),
    ):
        there = {path.name for kind in kinds for path in (ROOT / folder).glob(f"*.{kind}")}
        assert there
        listed = text.split(f"| in `{folder}/` |")[1].split("\n\n")[0]
        assert set(re.findall(r"`(\S+\.(?:py|mlx))`", listed)) == there


def place_and_names() -> list[tuple[str, list[str]]]:
    """Of docs/algorithm.md: each file, and what is said to be in it, as `a` and `b` in `file`."""
    text = TEXTS["docs/algorithm.md"]
    found = re.findall(r"`(\w+)`(?: and `(\w+)`)? in `([\w/]+\.(?:h|cpp))`", text)
    return [(file, [name for name in (first, second) if name]) for first, second, file in found]


@pytest.mark.parametrize(("file", "names"), place_and_names())
def test_what_is_said_to_be_in_a_file_is_in_it(file: str, names: list[str]) -> None:
    source = (ROOT / "filter_neuralmesh" / file).read_text("utf-8")
    assert [name for name in names if not re.search(rf"\b{name}\b", source)] == []


def test_every_source_that_asks_for_the_system_is_told_of() -> None:
    asks = re.compile(
        r"__linux__|_WIN32|_MSC_VER|__APPLE__|/proc/|#include <(sys/|windows\.h|unistd\.h|fcntl\.h)"
    )
    folder = ROOT / "filter_neuralmesh"
    sources = [path for ending in ("h", "cpp") for path in folder.rglob(f"*.{ending}")]
    asking = {
        path.name
        for path in sources
        if "tests" not in path.relative_to(folder).parts and asks.search(path.read_text("utf-8"))
    }
    assert "free_memory.cpp" in asking
    assert [name for name in sorted(asking) if name not in TEXTS["docs/hosts.md"]] == []


def test_every_example_says_what_the_plugin_is_called_elsewhere() -> None:
    folders = (ROOT / "scripts/examples", ROOT / "pymeshlab_tests/examples")
    texts = {path: path.read_text("utf-8") for f in folders for path in f.glob("*.py")}
    naming = {path for path, text in texts.items() if "libfilter_neuralmesh.so" in text}
    assert len(naming) >= 13
    assert [path.name for path in naming if "filter_neuralmesh.dll" not in texts[path]] == []


def test_every_equation_of_the_paper_has_a_place() -> None:
    rows = table_rows(
        section(TEXTS["docs/algorithm.md"], "The paper, step by step").split("Each eq")[1]
    )
    numbers = {int(row[0]) for row in rows if row[0].isdigit()}
    assert numbers == set(range(1, 11))


def anchors(text: str) -> set[str]:
    """The anchors of a document's headings, as they are made on GitHub."""
    headings = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda path: path.name)
def test_links_lead_to_files_and_headings(document: Path) -> None:
    for target in re.findall(r"\]\(([^)]+)\)", document.read_text("utf-8")):
        if target.startswith("https://"):
            continue
        name, _, anchor = target.partition("#")
        path = document.parent / name if name else document
        assert path.is_file(), target
        if anchor:
            assert anchor in anchors(path.read_text("utf-8")), target


# ----------------------------------------------------------------------------------- the project


def test_the_readme_is_an_entrance() -> None:
    assert len(README.splitlines()) <= 150


@pytest.mark.parametrize("name", [name for name in TEXTS if name.startswith("docs/")])
def test_each_document_is_linked_from_another(name: str) -> None:
    link = re.compile(rf"\]\((?:docs/)?{re.escape(Path(name).name)}[)#]")
    assert [other for other, text in TEXTS.items() if other != name and link.search(text)]


def test_pictures_are_small() -> None:
    pictures = list((ROOT / "docs" / "pictures").glob("*.png"))
    assert len(pictures) >= 5
    assert [path.name for path in pictures if path.stat().st_size > 150 * 1024] == []


def test_a_picture_can_be_drawn_again(plugin: Path, tmp_path: Path) -> None:
    command = [sys.executable, ROOT / "scripts/pictures.py", "growth", "--out", tmp_path]
    subprocess.run(command, check=True, capture_output=True, timeout=120)
    drawn, kept = tmp_path / "growth.png", ROOT / "docs/pictures/growth.png"
    # The size of a PNG stands in bytes 16 to 23.
    assert drawn.read_bytes()[16:24] == kept.read_bytes()[16:24]


def test_the_version_is_the_same_everywhere() -> None:
    places = {
        "pyproject.toml": r'^version = "(.+)"$',
        "python/neuralmesh/pyproject.toml": r'^version = "(.+)"$',
        "CMakeLists.txt": r"project\(NeuralMeshReconstruction VERSION (\S+) ",
        "CITATION.cff": r"^version: (.+)$",
        "CHANGELOG.md": r"^## \[(\d.*?)\]",
    }
    found = {
        name: re.search(pattern, (ROOT / name).read_text("utf-8"), re.MULTILINE)[1]
        for name, pattern in places.items()
    }
    assert len(set(found.values())) == 1, found
