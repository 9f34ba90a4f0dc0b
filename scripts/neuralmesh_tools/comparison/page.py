# SPDX-License-Identifier: GPL-3.0-or-later
"""report.html: one file that needs no network, from the template beside this module."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jinja2
import plotly.graph_objects as go
from markupsafe import Markup
from plotly.offline import get_plotlyjs

from neuralmesh_tools.comparison.figures import CHARTS_HEIGHT, charts, views, views_height
from neuralmesh_tools.comparison.run import Comparison, Result
from neuralmesh_tools.comparison.tables import COLUMNS, Column
from neuralmesh_tools.comparison.verdict import RULE, is_closed, judge
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.methods import METHODS

TEMPLATE = "report.html.j2"


def write_page(comparisons: list[Comparison], about: dict[str, Any], out: Path) -> Path:
    """Write report.html into a folder; about: what is said of the run. Returns its path."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
        undefined=jinja2.StrictUndefined,
    )
    text = environment.get_template(TEMPLATE).render(
        clouds=[_cloud(comparison, about["against"]) for comparison in comparisons],
        columns=COLUMNS,
        methods=METHODS,
        rule=RULE,
        about=about,
        plotly=Markup(get_plotlyjs()),
    )
    path = out / "report.html"
    write_in_one_step(path, text)
    return path


def _cloud(comparison: Comparison, against: str) -> dict[str, Any]:
    """All that the template shows of a cloud, formatted."""
    verdict = judge(comparison)
    described: dict[str, Any] = {
        "name": comparison.name,
        "file": comparison.path,
        "verdict": verdict,
        "failure": comparison.failure,
        "rows": [_row(result, comparison, verdict.method) for result in comparison.results],
    }
    if comparison.cloud is not None:
        described |= {
            "points": f"{comparison.cloud.count:,}",
            "normals": comparison.cloud.normals_from,
            "spacing": f"{100 * comparison.cloud.spacing / comparison.cloud.diagonal:.2g} %",
            "diagonal": f"{comparison.cloud.diagonal:.4g}",
            "vertices": f"{comparison.vertices:,}",
            "views_height": views_height(comparison),
            "charts_height": CHARTS_HEIGHT,
            "views": _json(views(comparison, against)),
            "charts": _json(charts(comparison)),
        }
    return described


def _row(result: Result, comparison: Comparison, recommended: str) -> dict[str, Any]:
    row: dict[str, Any] = {
        "label": result.label,
        "failure": result.failure,
        "doubts": result.doubts,
        "why_none": "timed out" if result.kind == "timed out" else "no mesh",
        "recommended": result.method == recommended,
    }
    if not result.failure and comparison.cloud is not None:
        row |= {
            "percent": f"{result.values['rms_percent']:.2g} %",
            "closed": "closed" if is_closed(result) else "open",
            "seconds": f"{result.values['seconds']:.1f} s",
            "cells": [_cell(column, result, comparison) for column in COLUMNS],
        }
    return row


def _cell(column: Column, result: Result, comparison: Comparison) -> dict[str, Any]:
    """A figure as shown, as sorted, and whether it is the best of its column."""
    value = result.values.get(column.key)
    if value is None:
        return {"shown": "–", "value": "", "best": False}
    others = [r.values.get(column.key) for r in comparison.results if not r.failure]
    known = [other for other in others if other is not None]
    best = {"low": min(known), "high": max(known), None: None}[column.better]
    return {"shown": format(value, column.shown), "value": value, "best": value == best}


def _json(figure: go.Figure) -> Markup:
    """A figure as JSON that cannot end the script element it stands in."""
    return Markup(figure.to_json().replace("</", "<\\/"))
