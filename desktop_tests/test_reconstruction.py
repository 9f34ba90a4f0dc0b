# SPDX-License-Identifier: GPL-3.0-or-later
"""The main job from the desktop, and what it does with input that it must refuse."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import pytest
from meshlab import MeshLab
from scene import (
    CLOUD,
    EMPTYING_SCRIPT,
    EXAMPLE_SCRIPTS,
    FEW,
    FILTER,
    KEPT_CLOUD,
    OLD_NAME,
    SAVED_MESH,
    SAVED_PROJECT,
    TARGET,
)

FAILURE = "Filter Failure"


def refusal(meshlab: MeshLab, name: str = FILTER) -> str:
    """Return the sentence of the box that reports a filter's failure, without its first line."""
    box = meshlab.window(FAILURE)
    text = max((label.text for label in box.all("label")), key=len)
    assert name in text
    return text.rsplit("\n", 1)[-1]


def dismiss(meshlab: MeshLab) -> None:
    meshlab.push(meshlab.window(FAILURE), "OK")
    meshlab.wait_until_closed(FAILURE)


def test_apply_adds_a_layer_that_can_be_saved(
    start_meshlab: Callable[..., MeshLab], screenshot: Callable[[str], None], work: Path
) -> None:
    meshlab = start_meshlab(CLOUD)
    meshlab.wait_until_open()
    dialog = meshlab.start_filter(FILTER)
    meshlab.set_field(dialog, "Target number of vertices", str(TARGET))
    meshlab.push(dialog, "Apply")
    meshlab.wait_for_layers("bunny", "bunny neural mesh")
    figures = meshlab.wait_for_log(r"([\d,]+) vertices, ([\d,]+) faces, RMS error (\S+) ")
    assert figures[1] == f"{TARGET:,}"
    assert figures[2] == f"{2 * TARGET - 4:,}"  # Euler: closed, genus 0
    assert float(figures[3]) > 0
    meshlab.wait_for_log(f"Applied filter: {FILTER} in")
    meshlab.push(dialog, "Close")
    meshlab.wait_until_closed(FILTER)
    meshlab.click(meshlab.eye("bunny"))  # hide the cloud
    screenshot("result")

    meshlab.save_layer(work / SAVED_MESH)
    meshlab.save_project(work / SAVED_PROJECT)
    layers = ET.parse(work / SAVED_PROJECT).getroot().iter("MLMesh")
    assert [layer.get("label") for layer in layers] == ["bunny.ply", "bunny neural mesh"]


@pytest.mark.parametrize(("script", "vertices"), EXAMPLE_SCRIPTS.items())
def test_example_script_runs(
    script: str, vertices: int, start_meshlab: Callable[..., MeshLab], work: Path
) -> None:
    meshlab = start_meshlab(CLOUD)
    meshlab.wait_until_open()
    meshlab.run_script(work / script)
    meshlab.wait_for_layers("bunny", "bunny neural mesh")
    meshlab.wait_for_log(f"Neural mesh: {vertices:,} vertices")
    last = ET.parse(work / script).getroot().findall("filter")[-1].get("name")
    meshlab.wait_for_log(f"Re-Applied filter {last}")


def test_refusal_shows_a_sentence_and_leaves_the_document_as_it_was(
    start_meshlab: Callable[..., MeshLab], screenshot: Callable[[str], None], work: Path
) -> None:
    meshlab = start_meshlab(FEW)
    meshlab.wait_until_open()
    dialog = meshlab.start_filter(FILTER)
    meshlab.push(dialog, "Apply")
    sentence = refusal(meshlab)
    screenshot("refusal")
    assert sentence == "Only 3 distinct points: a closed surface needs at least 4."
    dismiss(meshlab)
    meshlab.wait_for_log(f"{FILTER} failed: {sentence}")
    assert meshlab.layers() == ["few"]
    meshlab.save_layer(work / KEPT_CLOUD)  # compared with the input afterwards


def test_empty_document_is_refused_with_a_sentence(
    start_meshlab: Callable[..., MeshLab], screenshot: Callable[[str], None], work: Path
) -> None:
    meshlab = start_meshlab(FEW)
    meshlab.wait_until_open()
    # The menus close on an empty document: only a script comes there.
    meshlab.run_script(work / EMPTYING_SCRIPT)
    sentence = refusal(meshlab, OLD_NAME)
    screenshot("empty-document")
    assert sentence == "There is no current layer: open or make a point cloud or a mesh first."
    dismiss(meshlab)
    assert meshlab.layers() == []
