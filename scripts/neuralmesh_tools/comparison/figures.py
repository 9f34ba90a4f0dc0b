# SPDX-License-Identifier: GPL-3.0-or-later
"""A cloud's 3D views, coloured by error on one scale, and its charts: Plotly figures."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
import plotly.graph_objects as go
from plotly.subplots import make_subplots

from neuralmesh_tools.comparison.clouds import CloudFacts
from neuralmesh_tools.comparison.measures import LARGEST_VALENCE
from neuralmesh_tools.comparison.run import CHART_FRACTIONS, Comparison, Result
from neuralmesh_tools.comparison.verdict import is_closed
from neuralmesh_tools.methods import METHODS

COLUMNS = 3
ROW_HEIGHT = 400
CHARTS_HEIGHT = 380
POINT_COLOUR = "#51606e"
# Low error blue, high error red (ColorBrewer's RdYlBu, reversed).
ERROR_COLOURS = [
    [0, "#313695"],
    [0.25, "#74add1"],
    [0.5, "#ffffbf"],
    [0.75, "#f46d43"],
    [1, "#a50026"],
]
# Of the methods in charts, in the order of the registry.
METHOD_COLOURS = dict(
    zip(METHODS, ("#d1495b", "#00798c", "#edae49", "#8d6a9f", "#7a7a7a"), strict=True)
)
# The scale ends where 98 % of the faces of the middle one of the results lie below: one result
# that is far off would turn all others blue.
SCALE_PERCENTILE = 98
SMALLEST_VALENCE = 3
# Three ticks a decade have room in the chart up to these; the margin is for markers on its edges.
MOST_DECADES = 3
MARGIN = 1.1
FONT = {"family": "system-ui, sans-serif", "size": 13, "color": "#1d2733"}
# As MeshLab opens a document: y up, seen from z.
CAMERA = {"up": {"x": 0, "y": 1, "z": 0}, "eye": {"x": 0.35, "y": 0.3, "z": 1.75}}


def error_scale(results: list[Result]) -> float:
    """The error at the red end, in % of the diagonal, common to all views of a cloud."""
    ends = [np.percentile(r.face_error, SCALE_PERCENTILE) for r in results if r.mesh is not None]
    return float(np.median(ends)) or 1.0


def views_height(comparison: Comparison) -> int:
    """The height of the views, in pixels."""
    shown = 1 + sum(result.mesh is not None for result in comparison.results)
    return -(-shown // COLUMNS) * ROW_HEIGHT + 40


def views(comparison: Comparison, against: str) -> go.Figure:
    """The cloud and each result, in scenes of their own; against: what errors are measured to."""
    cloud = comparison.cloud
    assert cloud is not None  # the page draws no comparison that failed
    shown = [result for result in comparison.results if result.mesh is not None]
    titles = [f"the cloud<br><sub>{cloud.count:,} points</sub>", *map(_title, shown)]
    row_count = -(-len(titles) // COLUMNS)
    figure = make_subplots(
        rows=row_count,
        cols=COLUMNS,
        specs=[[{"type": "scene"}] * COLUMNS for _ in range(row_count)],
        subplot_titles=titles,
        horizontal_spacing=0.01,
        vertical_spacing=0.12 / row_count,
    )
    for number, trace in enumerate([_points(cloud), *map(_mesh, shown)]):
        figure.add_trace(trace, row=1 + number // COLUMNS, col=1 + number % COLUMNS)
    hidden = {"visible": False}
    figure.update_scenes(
        xaxis=hidden, yaxis=hidden, zaxis=hidden, aspectmode="data", camera=CAMERA, dragmode="orbit"
    )
    figure.update_layout(
        height=views_height(comparison),
        margin={"l": 0, "r": 0, "t": 50, "b": 0},
        font=FONT,
        paper_bgcolor="white",
        showlegend=False,
        coloraxis={
            "colorscale": ERROR_COLOURS,
            "cmin": 0,
            "cmax": error_scale(shown),
            "colorbar": {
                "title": {"text": f"distance to {against},<br>% of the diagonal", "side": "right"},
                "thickness": 16,
                "exponentformat": "power",
                "ticksuffix": " %",
            },
        },
    )
    return figure


def _title(result: Result) -> str:
    values = result.values
    open_edges = f"{values['boundary_edges']:,} boundary edges"
    edge = "closed" if is_closed(result) else open_edges
    return f"<b>{result.label}</b><br><sub>RMS {values['rms_percent']:.2g} %, {edge}</sub>"


def _points(cloud: CloudFacts) -> go.Scatter3d:
    x, y, z = cloud.shown.T
    marker = {"size": 1.3, "color": POINT_COLOUR}
    return go.Scatter3d(x=x, y=y, z=z, mode="markers", marker=marker, hoverinfo="skip")


def _mesh(result: Result) -> go.Mesh3d:
    assert result.mesh is not None
    x, y, z = result.mesh.points.T.astype("f4")
    i, j, k = result.mesh.faces.T
    return go.Mesh3d(
        x=x,
        y=y,
        z=z,
        i=i,
        j=j,
        k=k,
        intensity=result.face_error,
        intensitymode="cell",
        coloraxis="coloraxis",
        name=result.label,
        lighting={"ambient": 0.55, "diffuse": 0.7, "specular": 0.05, "fresnel": 0.02},
        lightposition={"x": 2000, "y": 3000, "z": 5000},
        hovertemplate="error %{intensity:.3g} %<extra>%{fullData.name}</extra>",
    )


def charts(comparison: Comparison) -> go.Figure:
    """Error by number of vertices, and the valence histogram, side by side."""
    figure = make_subplots(
        rows=1,
        cols=2,
        subplot_titles=["RMS error by number of vertices", "neighbours of a vertex (valence)"],
        horizontal_spacing=0.09,
    )
    valences = list(range(SMALLEST_VALENCE, LARGEST_VALENCE + 1))
    names = [*map(str, valences[:-1]), f"≥ {LARGEST_VALENCE}"]
    for result in comparison.results:
        if result.mesh is None:
            continue
        style = {"name": result.label, "legendgroup": result.method}
        colour = METHOD_COLOURS[result.method]
        vertices, errors = zip(*result.curve, strict=True)
        line = go.Scatter(
            x=vertices,
            y=errors,
            mode="lines+markers",
            line={"color": colour, "width": 2.5},
            **style,
        )
        shares = result.valence_shares[SMALLEST_VALENCE:]
        bars = go.Bar(x=names, y=shares, marker={"color": colour}, showlegend=False, **style)
        figure.add_trace(line, row=1, col=1)
        figure.add_trace(bars, row=1, col=2)
    _set_axes(figure, comparison)
    figure.update_layout(
        height=CHARTS_HEIGHT,
        margin={"l": 70, "r": 10, "t": 50, "b": 50},
        font=FONT,
        plot_bgcolor="white",
        legend={"orientation": "h", "y": -0.18},
        bargap=0.15,
    )
    return figure


def _set_axes(figure: go.Figure, comparison: Comparison) -> None:
    grid = {"gridcolor": "#e4e8ec", "zeroline": False}
    errors = error_ticks(e for r in comparison.results if r.mesh is not None for _, e in r.curve)
    ticks = [round(comparison.vertices * fraction) for fraction in CHART_FRACTIONS]
    figure.update_xaxes(
        type="log",
        title_text="vertices",
        tickvals=ticks,
        ticktext=[f"{tick:,}" for tick in ticks],
        row=1,
        col=1,
        **grid,
    )
    figure.update_yaxes(
        type="log",
        title_text="% of the diagonal",
        tickvals=errors,
        ticktext=[f"{error:g}" for error in errors],
        range=np.log10([errors[0] / MARGIN, errors[-1] * MARGIN]).tolist(),
        row=1,
        col=1,
        **grid,
    )
    figure.update_xaxes(type="category", row=1, col=2)
    figure.update_yaxes(title_text="% of vertices", row=1, col=2, **grid)


def error_ticks(errors: Iterable[float]) -> list[float]:
    """Ticks that enclose all errors above 0: of 1, 2, 5 in each decade, of 1 only if they are many.

    Plotly's own have a digit without its decade, 5 for 0.5, and may be none within half a decade.
    """
    positive = [error for error in errors if error > 0] or [1.0]
    first, last = math.floor(math.log10(min(positive))), math.ceil(math.log10(max(positive)))
    digits = (1, 2, 5) if last - first <= MOST_DECADES else (1,)
    ticks = [float(f"{k}e{decade}") for decade in range(first - 1, last + 2) for k in digits]
    below = max(tick for tick in ticks if tick <= min(positive))
    above = min(tick for tick in ticks if tick >= max(positive))
    if below == above:  # a single error on a tick
        above = ticks[ticks.index(below) + 1]
    return [tick for tick in ticks if below <= tick <= above]
