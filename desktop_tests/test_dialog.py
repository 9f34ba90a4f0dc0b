# SPDX-License-Identifier: GPL-3.0-or-later
"""Where a person finds the filter, and what its dialog says."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from display import Display
from meshlab import MeshLab, field_beside
from polling import wait_for
from scene import CLOUD, FILTER, OLD_NAME, SMALL, SMALL_POINTS
from widgets import Widget

MENU = ("Filters", "Remeshing, Simplification and Reconstruction")
NEIGHBOURS = ("Surface Reconstruction: Screened Poisson", "Surface Reconstruction: Ball Pivoting")
ADVANCED = {"Winner rate", "Smoothing rate", "Split rule", "Edge flips"}


@pytest.fixture
def meshlab(start_meshlab: Callable[..., MeshLab]) -> MeshLab:
    opened = start_meshlab(CLOUD)
    opened.wait_until_open()
    return opened


def labels(dialog: Widget) -> set[str]:
    return {label.name for label in dialog.all("label")}


def unfold(meshlab: MeshLab, dialog: Widget) -> None:
    meshlab.push(dialog, "▼")
    wait_for("the advanced parameters", lambda: labels(dialog) >= ADVANCED)


def test_menu_shows_the_filter_beside_the_other_reconstructions(
    meshlab: MeshLab, display: Display, screenshot: Callable[[str], None]
) -> None:
    entries = {entry.name: entry for entry in meshlab.open_menu(*MENU)}
    entry = entries[FILTER]
    left, top, *_ = entry.box
    corner = left + 3, top + 3  # beside the text
    unlit = display.pixel(*corner)

    def lit() -> bool:
        meshlab.hover(entry)  # again: a menu takes a first move for one on the way elsewhere
        return display.pixel(*corner) != unlit

    wait_for("the entry lit up", lit)
    screenshot("menu")
    assert entries.keys() >= set(NEIGHBOURS)
    assert OLD_NAME not in entries
    # Below one another, that is, in the same menu, which is all there is to see.
    assert {entry.box[0]} == {entries[name].box[0] for name in NEIGHBOURS}


def test_search_opens_a_dialog_that_explains_itself(
    meshlab: MeshLab, screenshot: Callable[[str], None]
) -> None:
    dialog = meshlab.start_filter(FILTER)
    screenshot("dialog")
    explanation = max(labels(dialog), key=len)
    # As MeshLab's own filters cite, its HTML shown as text.
    assert "See:\nI. Ivrissimtzis, W.-K. Jeong, H.-P. Seidel\n" in explanation
    assert "<" not in explanation
    assert "generate_surface_reconstruction_neural_mesh" in labels(dialog)
    assert field_beside(dialog, "Target number of vertices").text == "5000"


def test_advanced_parameters_are_folded_away(
    meshlab: MeshLab, screenshot: Callable[[str], None]
) -> None:
    dialog = meshlab.start_filter(FILTER)
    assert not labels(dialog) & ADVANCED
    unfold(meshlab, dialog)
    screenshot("dialog-advanced")


def test_choices_have_names(meshlab: MeshLab) -> None:
    dialog = meshlab.start_filter(FILTER)
    unfold(meshlab, dialog)
    rule = field_beside(dialog, "Split rule")
    assert rule.role == "combo box"
    assert [item.name for item in rule.below_hidden("list item")] == [
        "Balanced valences",
        "As in the paper",
    ]


def test_help_button_shows_what_every_parameter_means(
    meshlab: MeshLab, screenshot: Callable[[str], None]
) -> None:
    dialog = meshlab.start_filter(FILTER)
    unfold(meshlab, dialog)
    fields = dialog.all("text", "combo box")
    tooltips = {label.help for label in dialog.all("label") if label.help}
    assert len(tooltips) > len(fields)  # one each, and those of the check boxes
    meshlab.push(dialog, "Help")
    wait_for("the help texts", lambda: labels(dialog) >= tooltips)
    screenshot("dialog-help")


def test_default_button_resets_what_was_changed(meshlab: MeshLab) -> None:
    dialog = meshlab.start_filter(FILTER)
    meshlab.set_field(dialog, "Target number of vertices", "77")
    meshlab.set_field(dialog, "Random seed", "9")
    meshlab.push(dialog, "Default")
    for label, value in (("Target number of vertices", "5000"), ("Random seed", "1")):
        wait_for(
            f"the default {value} of '{label}'",
            lambda name=label, text=value: field_beside(dialog, name).text == text,
        )


def test_default_target_is_half_of_a_small_layer(start_meshlab: Callable[..., MeshLab]) -> None:
    meshlab = start_meshlab(SMALL)
    meshlab.wait_until_open()
    dialog = meshlab.start_filter(FILTER)
    assert field_beside(dialog, "Target number of vertices").text == str(SMALL_POINTS // 2)
