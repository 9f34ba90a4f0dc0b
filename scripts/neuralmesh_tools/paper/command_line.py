# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/reproduce_paper.py."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import pymeshlab

from neuralmesh_tools import datasets
from neuralmesh_tools.command_line import add_plugin, listed, names, parser_of
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.layers import load_plugin
from neuralmesh_tools.paper.page import DrawnFigure, MeasuredRow, page_html, table_text
from neuralmesh_tools.paper.pictures import draw_figure
from neuralmesh_tools.paper.reported import FIGURES, MODELS, TABLE_1, Figure
from neuralmesh_tools.paper.runs import SETTINGS, Mesh, Setting, growing_meshes, valence_counts
from neuralmesh_tools.project import PluginMissing, require_plugin

LEAST_VERTICES = 4


def parse_arguments(description: str | None) -> argparse.Namespace:
    """Read the command line; exits with 2 on an unknown model or a scale out of range."""
    parser = parser_of(description)
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="made if missing")
    parser.add_argument(
        "--models",
        default=",".join(MODELS),
        help=f"comma separated (default: all: {listed(MODELS)}); what needs others is left out",
    )
    parser.add_argument(
        "--scale", type=float, default=1, help="times the paper's vertex counts (default 1)"
    )
    add_plugin(parser)
    options = parser.parse_args()
    options.models = names(parser, "model", options.models, MODELS)
    if not 0 < options.scale <= 1:
        parser.error("--scale must be above 0 and at most 1")
    return options


def scaled(vertices: int, scale: float) -> int:
    """Return a vertex count of the paper at this scale."""
    return max(LEAST_VERTICES, round(vertices * scale))


def available(models: list[str]) -> tuple[list[str], list[str]]:
    """Fetch the models; return those that are here, and why others are not."""
    here: list[str] = []
    missing: list[str] = []
    for name in models:
        try:
            if MODELS[name].dataset:
                datasets.fetch(MODELS[name].dataset)
            here.append(name)
        except datasets.Unavailable as problem:
            missing.append(f"{MODELS[name].title}: {problem}")
    return here, missing


def measure_table(models: list[str], scale: float) -> list[MeasuredRow]:
    """Run each row of Table 1 whose model is among these, with both settings."""
    rows: list[MeasuredRow] = []
    for row in TABLE_1:
        if row.model not in models:
            continue
        vertices = scaled(row.vertices, scale)
        ours = {setting.title: valence_counts(row.model, vertices, setting) for setting in SETTINGS}
        rows.append(MeasuredRow(row, vertices, ours))
    return rows


def grow_models(models: list[str], scale: float, setting: Setting) -> dict[tuple[str, int], Mesh]:
    """Return the meshes of all figures, by model and the paper's vertex count: a run a model."""
    meshes: dict[tuple[str, int], Mesh] = {}
    for model in models:
        counts = {
            vertices: scaled(vertices, scale)
            for figure in FIGURES
            for name, vertices in figure.panels
            if name == model
        }
        if not counts:
            continue
        grown = growing_meshes(model, list(counts.values()), setting)
        meshes |= {(model, vertices): grown[count] for vertices, count in counts.items()}
    return meshes


def draw_figures(models: list[str], scale: float, out: Path) -> list[DrawnFigure]:
    """Draw each figure whose models are all among these, with both settings; write the PNGs."""
    pictures: dict[int, dict[str, bytes]] = {figure.number: {} for figure in FIGURES}
    wanted: list[Figure] = [
        figure for figure in FIGURES if all(model in models for model, _ in figure.panels)
    ]
    for order, setting in enumerate(SETTINGS):
        meshes = grow_models(models, scale, setting)
        for figure in wanted:
            panels = [(model, meshes[model, vertices]) for model, vertices in figure.panels]
            picture = draw_figure(panels, figure.wireframe)
            pictures[figure.number][setting.title] = picture
            name = f"figure-{figure.number:02}-{'paper' if order == 0 else 'defaults'}.png"
            write_in_one_step(out / name, picture)
    return [DrawnFigure(figure, pictures[figure.number]) for figure in wanted]


def main(description: str | None) -> int:
    """Run, write the page, print the table; return the exit code."""
    options = parse_arguments(description)
    try:
        load_plugin(require_plugin(options.plugin))
    except PluginMissing as problem:
        print(problem, file=sys.stderr)
        return 1
    options.out.mkdir(parents=True, exist_ok=True)
    models, missing = available(options.models)
    try:
        rows = measure_table(models, options.scale)
        print(f"Table 1: vertices by valence\n{table_text(rows)}", flush=True)
        figures = draw_figures(models, options.scale, options.out)
    except (pymeshlab.PyMeshLabException, RuntimeError) as problem:
        print(f"the filter failed: {problem}", file=sys.stderr)
        return 1
    page = options.out / "paper.html"
    write_in_one_step(page, page_html(rows, figures, missing))
    print(f"{len(figures)} figures with two settings each: {page}")
    for each in missing:
        print(f"left out: {each}", file=sys.stderr)
    return 1 if missing else 0
