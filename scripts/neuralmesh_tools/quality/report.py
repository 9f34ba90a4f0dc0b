# SPDX-License-Identifier: GPL-3.0-or-later
"""The table: one group a model and condition, one row a method, in Markdown."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict
from typing import Any

import numpy as np

from neuralmesh_tools.methods import TABLE_METHODS
from neuralmesh_tools.quality import models
from neuralmesh_tools.quality.inputs import CONDITIONS
from neuralmesh_tools.quality.run import Group, Row

HEADINGS = (
    "method",
    "V",
    "RMS to mesh %",
    "÷ Poisson best",
    "÷ Poisson true",
    "RMS to surface %",
    "max to mesh %",
    "max to surface %",
    "self-int.",
    "boundary",
    "non-man.",
    "genus",
    "comp.",
    "min angle °",
    "1 % angle °",
    "valence 6 %",
    "5–7 %",
    "s",
)

LEGEND = """Distances are in per cent of the bounding box diagonal of the clean surface, "to mesh"
from that surface, "to surface" from the result. The two ÷ columns divide the RMS to mesh by that of
screened Poisson at its best and with true normals. self-int.: faces that intersect another;
boundary, non-man.: edges; comp.: components; 1 % angle: the angle that the worst 1 % of faces
stay under. A genus of – is undefined (open or non-manifold). s: all the method's seconds;
* marks a row from the cache, its seconds measured in an earlier run."""


def group_markdown(group: Group, rows: list[Row]) -> str:
    """The heading and the rows of one case."""
    label = CONDITIONS[group.condition].label
    lines = [f"\n### {group.model}, {label}, {group.vertices:,} vertices (seed {group.seed})\n"]
    lines.append("| " + " | ".join(HEADINGS) + " |")
    lines.append("|---|" + "--:|" * (len(HEADINGS) - 1))
    by_method = {row.method: row for row in rows}
    lines += ["| " + " | ".join(_cells(row, by_method)) + " |" for row in rows]
    return "\n".join(lines)


def _cells(row: Row, by_method: dict[str, Row]) -> list[str]:
    if row.failed:
        return [row.method, f"failed: {row.values['failure']}", *[""] * (len(HEADINGS) - 2)]
    v = row.values
    return [
        row.method,
        f"{v['vertices']:,}",
        f"{v['rms_to_mesh']:.4f}",
        ratio_text(row, by_method.get("poisson-best")),
        ratio_text(row, by_method.get("poisson-true")),
        f"{v['rms_to_surface']:.4f}",
        f"{v['max_to_mesh']:.3f}",
        f"{v['max_to_surface']:.3f}",
        str(v["self_intersecting"]),
        str(v["boundary_edges"]),
        str(v["non_manifold_edges"]),
        "–" if v["genus"] is None else str(v["genus"]),
        str(v["components"]),
        f"{v['min_angle']:.1f}",
        f"{v['angle_1_percent']:.1f}",
        f"{v['valence_6']:.1f}",
        f"{v['valence_5_to_7']:.1f}",
        f"{v['seconds']:.2f}{'*' if row.from_cache else ''}",
    ]


def ratio_text(row: Row, peer: Row | None) -> str:
    """The row's RMS from surface to mesh divided by the peer's; empty without one."""
    if peer is None or peer.failed or peer.method == row.method:
        return ""
    return f"{row.values['rms_to_mesh'] / peer.values['rms_to_mesh']:.2f}"


def overview_markdown(rows: list[Row]) -> str:
    """RMS to mesh / to surface of every method, a table a condition, a row a model.

    Of several seeds, the geometric mean.
    """
    methods = list(dict.fromkeys(row.method for row in rows))
    lines = []
    for condition in dict.fromkeys(row.group.condition for row in rows):
        lines.append(f"\n### {CONDITIONS[condition].label}: RMS to mesh / to surface, %\n")
        lines.append(f"| model | {' | '.join(methods)} |")
        lines.append("|---|" + "--:|" * len(methods))
        of_condition = [row for row in rows if row.group.condition == condition]
        for model in dict.fromkeys(row.group.model for row in of_condition):
            of_model = [row for row in of_condition if row.group.model == model]
            cells = [_both_ways([r for r in of_model if r.method == method]) for method in methods]
            lines.append(f"| {model} | {' | '.join(cells)} |")
    return "\n".join(lines)


def _both_ways(seeds: list[Row]) -> str:
    if not seeds or any(row.failed for row in seeds):
        return "–"
    means = (
        np.exp(np.mean([np.log(row.values[metric]) for row in seeds]))
        for metric in ("rms_to_mesh", "rms_to_surface")
    )
    return " / ".join(f"{mean:.3f}" for mean in means)


def introduction(model_names: Iterable[str], method_names: Iterable[str]) -> str:
    """How to read the table; one line a method, what it is; one a model, why it is there."""
    of_methods = (f"- {name}: {TABLE_METHODS[name].about}" for name in method_names)
    of_models = (f"- {name}: {models.MODELS[name].why}" for name in model_names)
    return "\n\n".join([LEGEND, "\n".join(of_methods), "\n".join(of_models)])


def as_json(rows: list[Row]) -> list[dict[str, Any]]:
    """Rows as plain dictionaries, one a row, metrics at the top level."""
    return [
        {
            **asdict(row.group),
            "method": row.method,
            "from_cache": row.from_cache,
            **{**row.values, "target": row.group.vertices},
        }
        for row in rows
    ]
