# SPDX-License-Identifier: GPL-3.0-or-later
"""Filters and parameters held against what PyMeshLab has, before anything runs.

A filter script names filters as the menu does, and PyMeshLab has no list of these names: an unknown
one only shows when the script is applied. So each filter is applied, alone and in an isolated
process, to a tetrahedron with one parameter too many: PyMeshLab warns of it if it knows the
filter, whatever the filter then makes of it.
"""

from __future__ import annotations

import copy
import re
import tempfile
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pymeshlab

from neuralmesh_tools.batching.recipe import RecipeError
from neuralmesh_tools.batching.reconstruct import load_plugins
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.layers import details

ONE_TOO_MANY = "no_filter_has_this_parameter"
START_SECONDS = 60.0
# PyMeshLab warns before the filter starts; a filter that is still busy afterwards is cut short.
PROBE_SECONDS = 2.0
WARNING = re.compile(r"Warning: parameter (\S+) not required by filter")


def filter_defaults(
    process: IsolatedProcess, plugins: tuple[Path, ...], name: str
) -> dict[str, Any]:
    """Return a filter's parameters with their defaults; raises RecipeError if there is no such.

    A parameter that is neither a number nor a text, such as a colour, has None.
    """
    outcome = process.call(_defaults, plugins, name, timeout=START_SECONDS)
    if not outcome.ok:
        raise RecipeError(f"The filter {name} is not to be had: {outcome.failure}")
    return dict(outcome.value)


def check_suffix(process: IsolatedProcess, suffix: str) -> None:
    """Raise RecipeError if PyMeshLab does not write files with this ending."""
    with tempfile.TemporaryDirectory() as folder:
        target = str(Path(folder) / f"probe{suffix}")
        outcome = process.call(_save_something, target, timeout=START_SECONDS)
    if not outcome.ok:
        raise RecipeError(f"PyMeshLab does not write {suffix}: {outcome.failure}")


def check_script(process: IsolatedProcess, plugins: tuple[Path, ...], path: Path) -> str:
    """Return the text of a filter script if PyMeshLab knows all its filters and parameters.

    Raises RecipeError with one sentence for each thing that is wrong.
    """
    try:
        text = path.read_text(encoding="utf-8")
        root = ElementTree.fromstring(text)
    except (OSError, UnicodeDecodeError, ElementTree.ParseError) as problem:
        raise RecipeError(f"{path} cannot be read as a filter script: {problem}.") from problem
    filters = root.findall("filter")
    if root.tag != "FilterScript" or not filters:
        raise RecipeError(f"{path} holds no filters: MeshLab saves such scripts as .mlx.")
    problems = [problem for node in filters for problem in _probe(process, node, plugins)]
    if problems:
        raise RecipeError("\n".join(f"{path}: {problem}" for problem in dict.fromkeys(problems)))
    return text


def _probe(
    process: IsolatedProcess, node: ElementTree.Element, plugins: tuple[Path, ...]
) -> list[str]:
    name = node.get("name", "")
    probe = ElementTree.Element("FilterScript")
    extended = copy.deepcopy(node)
    too_many = {"name": ONE_TOO_MANY, "type": "RichBool", "value": "true"}
    extended.insert(0, ElementTree.Element("Param", too_many))
    probe.append(extended)
    with tempfile.TemporaryDirectory() as folder:
        script, log = Path(folder) / "probe.mlx", Path(folder) / "log"
        # PyMeshLab's reader wants the document type.
        script.write_bytes(b"<!DOCTYPE FilterScript>\n" + ElementTree.tostring(probe))
        process.call(_warm_up, plugins, timeout=START_SECONDS)
        outcome = process.call(
            _apply_to_tetrahedron, str(script), timeout=PROBE_SECONDS, log=log, folder=script.parent
        )
        warned = WARNING.findall(log.read_text(encoding="utf-8", errors="replace"))
    if ONE_TOO_MANY not in warned:
        reason = "" if outcome.kind in ("returned", "raised") else f" ({outcome.failure})"
        return [f'PyMeshLab has no filter "{name}"{reason}. Is its plugin missing (--plugin)?']
    return [
        f'the filter "{name}" has no parameter {parameter}.'
        for parameter in warned
        if parameter != ONE_TOO_MANY
    ]


# --------------------------------------------------------------------------- inside the process


def _defaults(plugins: tuple[Path, ...], name: str) -> dict[str, Any]:
    load_plugins(plugins)
    document = pymeshlab.MeshSet(verbose=False)
    document.create_tetrahedron()
    try:
        found = document.filter_parameter_values(name)
    except pymeshlab.PyMeshLabException as problem:
        raise ValueError(details(problem)) from None
    simple = (bool, int, float, str)
    return {key: value if isinstance(value, simple) else None for key, value in found.items()}


def _save_something(target: str) -> None:
    document = pymeshlab.MeshSet(verbose=False)
    document.create_tetrahedron()
    try:
        document.save_current_mesh(target)
    except pymeshlab.PyMeshLabException as problem:
        raise ValueError(details(problem)) from None


def _warm_up(plugins: tuple[Path, ...]) -> None:
    load_plugins(plugins)
    pymeshlab.MeshSet(verbose=False)


def _apply_to_tetrahedron(script: str) -> None:
    document = pymeshlab.MeshSet(verbose=False)
    document.create_tetrahedron()
    document.load_filter_script(script)
    document.apply_filter_script()
