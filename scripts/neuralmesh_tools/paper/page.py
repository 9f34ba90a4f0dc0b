# SPDX-License-Identifier: GPL-3.0-or-later
"""The table as text and as HTML, and the page that holds it with all figures."""

from __future__ import annotations

import base64
from dataclasses import dataclass
from html import escape

from neuralmesh_tools.paper.reported import MODELS, VALENCES, Counts, Figure, Row
from neuralmesh_tools.paper.runs import SETTINGS, Setting

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; max-width: 1200px; margin: 2em auto; padding: 0 1em;
       color: #222; background: #fff; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .15em .8em; text-align: right; }
th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left; }
tr.paper td { border-top: 1px solid #bbb; padding-top: .4em; }
tr.paper td, thead th { font-weight: 600; }
figure { margin: 1em 0 2em; }
figure img { max-width: 100%; display: block; }
figcaption { color: #555; }
"""


@dataclass(frozen=True)
class MeasuredRow:
    """A row of the paper's table and ours, one for each setting, at `vertices` vertices."""

    reported: Row
    vertices: int
    ours: dict[str, Counts]  # by the title of the setting


@dataclass(frozen=True)
class DrawnFigure:
    """A figure of the paper and our pictures of it, PNG, by the title of the setting."""

    reported: Figure
    pictures: dict[str, bytes]


def shares(counts: Counts) -> tuple[float, float]:
    """Return the per cent of vertices of valence 6, and of valence 5 to 7."""
    total = sum(counts)
    return 100 * counts[2] / total, 100 * sum(counts[1:4]) / total


def _lines(row: MeasuredRow) -> list[tuple[str, str, Counts]]:
    """What is said of a row: its name, by whom, and the counts; the paper comes first."""
    model = MODELS[row.reported.model].title
    lines = [(row.reported.title, "the paper", row.reported.counts)]
    for title, counts in row.ours.items():
        lines.append((f"{model} {row.vertices:,}", title, counts))
    return lines


def table_text(rows: list[MeasuredRow]) -> str:
    """Return the table for a terminal."""
    head = f"{'':16} {'':16}" + "".join(f"{name:>7}" for name in (*VALENCES, "% 6", "% 5-7"))
    lines = [head]
    for row in rows:
        for name, by, counts in _lines(row):
            figures = "".join(f"{count:7}" for count in counts)
            lines.append(
                f"{name:16} {by:16}{figures}" + "".join(f"{s:7.1f}" for s in shares(counts))
            )
    return "\n".join(lines)


def _table_html(rows: list[MeasuredRow]) -> str:
    head = "".join(f"<th>{name}</th>" for name in ("", "", *VALENCES, "6, %", "5 to 7, %"))
    body = []
    for row in rows:
        for name, by, counts in _lines(row):
            cells = [escape(name), escape(by), *(f"{count:,}" for count in counts)]
            cells += [f"{share:.1f}" for share in shares(counts)]
            kind = ' class="paper"' if by == "the paper" else ""
            body.append(f"<tr{kind}>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(body)}</tbody></table>"


def _figure_html(figure: DrawnFigure) -> str:
    parts = [f"<h2>Figure {figure.reported.number}: {escape(figure.reported.caption)}</h2>"]
    for setting, picture in figure.pictures.items():
        data = base64.b64encode(picture).decode("ascii")
        caption = f"{setting}; numbers of vertices below"
        parts.append(
            f'<figure><img alt="{escape(caption)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{escape(caption)}</figcaption></figure>"
        )
    return "\n".join(parts)


def _setting_text(setting: Setting) -> str:
    given = ", ".join(f"{name}={value}" for name, value in setting.parameters.items())
    return f"<li><b>{escape(setting.title)}</b>: {escape(given or 'no parameter given')}</li>"


def page_html(rows: list[MeasuredRow], figures: list[DrawnFigure], missing: list[str]) -> str:
    """Return a page that needs no other file."""
    models = {row.reported.model for row in rows} | {
        model for figure in figures for model, _ in figure.reported.panels
    }
    stand_ins = "".join(
        f"<li><b>{each.title}</b>: {escape(each.remark)}</li>"
        for name, each in MODELS.items()
        if name in models
    )
    left_out = "".join(f"<p><b>Left out.</b> {escape(each)}</p>" for each in missing)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<title>Growing Cell Structures: the paper's results</title><style>{STYLE}</style></head><body>
<h1>The paper's table and figures, made again</h1>
<p>I. Ivrissimtzis, W.-K. Jeong, H.-P. Seidel: <i>Using Growing Cell Structures for Surface
Reconstruction</i>, Shape Modeling International 2003. Ours are of two settings, seed 1:</p>
<ul>{"".join(map(_setting_text, SETTINGS))}</ul>
<p>The paper's decay of the signal counters, 0.95 at every signal, forgets all but the last twenty
and does not give its Table 1; both settings apply theirs once for as many signals as there are
vertices.</p>
<ul>{stand_ins}</ul>
{left_out}
<h2>Table 1: vertices by valence</h2>
{_table_html(rows)}
{"".join(map(_figure_html, figures))}
</body></html>
"""
