# SPDX-License-Identifier: GPL-3.0-or-later
"""filters.json of the adapter for MeshLab's rewrite: the plugin's own words, by that host's rules.

tests/hosts/meshlab2 runs the adapter with these values.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from neuralmesh_tools import meshlab2
from neuralmesh_tools.project import ROOT

DECLARED = json.loads(meshlab2.FILE.read_text("utf-8"))
FILTERS = DECLARED["filters"]
PARAMETERS = [parameter for filter_ in FILTERS for parameter in filter_["parameters"]]
# Of docs/design/adding_a_filter.md there, which takes any other word for "string".
TYPES = {"bool", "int", "double", "absperc", "enum", "string", "mesh", "fileopen"}


def test_file_is_what_the_plugin_says(plugin: Path) -> None:
    wanted = meshlab2.text()
    assert meshlab2.FILE.read_text("utf-8") == wanted, (
        "PYTHONPATH=scripts .venv/bin/python -m neuralmesh_tools.meshlab2 writes it anew"
    )


def test_rules_of_the_host_are_kept() -> None:
    adapter = ROOT / "filter_neuralmesh/hosts/meshlab2"
    cmake = (adapter / "CMakeLists.txt").read_text("utf-8")
    assert f'PREFIX "/filters/{DECLARED["pluginId"]}"' in cmake
    for filter_ in FILTERS:
        assert filter_["outputDomain"] == "NewMeshes"
        assert set(filter_["referenceIds"]) <= {each["id"] for each in DECLARED["references"]}
        # One plain sentence, without Markdown.
        assert re.fullmatch(r"[^*`$\[\]<>\n]+\.", filter_["shortDescription"])
        assert filter_["id"] in (adapter / "neuralmeshfilterplugin.cpp").read_text("utf-8")


@pytest.mark.parametrize("parameter", PARAMETERS, ids=lambda parameter: parameter["id"])
def test_parameter_is_declared_in_full(parameter: dict[str, Any]) -> None:
    assert parameter["type"] in TYPES
    assert all(parameter[key] for key in ("id", "label", "help", "group"))
    assert "\\n" not in parameter["help"]
    if parameter["type"] == "enum":
        assert parameter["default"] in [option["id"] for option in parameter["enumOptions"]]
    if "min" in parameter:
        assert parameter["min"] <= parameter["default"] <= parameter["max"]


def test_seed_follows_the_convention() -> None:
    for filter_ in FILTERS:
        (seed,) = (each for each in filter_["parameters"] if each["id"] == "randomSeed")
        assert (seed["type"], seed["default"], seed["min"]) == ("int", 0, 0)
