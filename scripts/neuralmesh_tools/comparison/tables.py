# SPDX-License-Identifier: GPL-3.0-or-later
"""The measured figures as a table: its columns, and results.csv and results.json."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from neuralmesh_tools.comparison.run import Comparison
from neuralmesh_tools.comparison.verdict import judge
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.methods import METHODS


@dataclass(frozen=True)
class Column:
    """A figure: its key, heading, meaning, format, and which values are better (None: neither)."""

    key: str
    heading: str
    meaning: str
    shown: str = ".3g"
    better: str | None = "low"


COLUMNS = (
    Column("seconds", "seconds", "reconstruction and cutting down; not the normals", ".2f"),
    Column(
        "peak_megabytes", "peak MB", "resident memory of the process, PyMeshLab included", ".0f"
    ),
    Column("vertices", "vertices", "of the result, after cutting down", ",d", None),
    Column(
        "rms_percent",
        "RMS error %",
        "both ways taken together, in % of the diagonal, as all errors",
    ),
    Column("rms_to_mesh_percent", "RMS to mesh %", "from the reference to the result"),
    Column("rms_to_reference_percent", "RMS to ref. %", "from the result to the reference"),
    Column(
        "hausdorff_to_mesh_percent", "worst to mesh %", "one-sided Hausdorff, reference to result"
    ),
    Column(
        "hausdorff_to_reference_percent",
        "worst to ref. %",
        "one-sided Hausdorff, result to reference",
    ),
    Column("chamfer_percent", "Chamfer %", "mean of the two mean distances"),
    Column("f_score", "F-score %", "of the shares within the threshold both ways", ".1f", "high"),
    Column(
        "normal_consistency", "normals %", "mean |cosine| between nearest normals", ".1f", "high"
    ),
    Column("missed", "missed %", "of the reference further than 3 spacings from the result", ".1f"),
    Column("far_from_points", "away %", "of area further than 3 spacings from all points", ".1f"),
    Column(
        "coverage_percent",
        "covered %",
        "by the filter's own figures: points near the mesh",
        ".1f",
        "high",
    ),
    Column(
        "unsupported_area_percent",
        "unsupported %",
        "by the filter's own: area far from all points",
        ".1f",
    ),
    Column("boundary_edges", "boundary", "edges with one face", ",d"),
    Column("non_manifold_edges", "non-manifold", "edges with more than two faces", ",d"),
    Column("self_intersecting", "crossing", "faces that intersect another", ",d"),
    Column("components", "parts", "connected components", ",d", None),
    Column("genus", "genus", "handles; – where the mesh is open or not manifold", "d", None),
    Column("min_angle", "min. angle °", "the smallest of all faces", ".1f", "high"),
    Column("angle_1_percent", "1 % angle °", "that 1 % of faces stay under", ".1f", "high"),
    Column("valence_6", "valence 6 %", "share of vertices with six neighbours", ".1f", "high"),
    Column("valence_5_to_7", "5–7 %", "share with five to seven", ".1f", "high"),
)


def rows(comparisons: list[Comparison]) -> Iterator[dict[str, Any]]:
    """One flat row a cloud and method; a failure is a sentence in the row."""
    for comparison in comparisons:
        head = {"cloud": comparison.name, "file": comparison.path}
        if comparison.failure:
            yield {**head, "method": "", "failure": comparison.failure}
        for result in comparison.results:
            figures = {column.key: result.values.get(column.key) for column in COLUMNS}
            about = {"failure": result.failure, "doubts": result.doubts}
            yield {**head, "method": result.method, **about, **figures}


def write_tables(comparisons: list[Comparison], about: dict[str, Any], out: Path) -> None:
    """Write results.csv, a row each, and results.json with all that the report shows but meshes."""
    names = ["cloud", "file", "method", "failure", "doubts", *(column.key for column in COLUMNS)]
    table = io.StringIO()
    writer = csv.DictWriter(table, names, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows(comparisons))
    write_in_one_step(out / "results.csv", table.getvalue())
    clouds = [_as_json(comparison) for comparison in comparisons]
    text = json.dumps({"about": about, "clouds": clouds}, indent=1)
    write_in_one_step(out / "results.json", text + "\n")


def _as_json(comparison: Comparison) -> dict[str, Any]:
    verdict, cloud = judge(comparison), comparison.cloud
    described = cloud and {
        "points": cloud.count,
        "normals": cloud.normals_from,
        "spacing": cloud.spacing,
        "diagonal": cloud.diagonal,
    }
    return {
        "cloud": comparison.name,
        "file": comparison.path,
        "failure": comparison.failure,
        "input": described,
        "vertices": comparison.vertices,
        "recommended": verdict.method,
        "verdict": " ".join(filter(None, [verdict.sentence, verdict.more])),
        "results": [
            {
                "method": result.method,
                "about": METHODS[result.method].about,
                "failure": result.failure,
                "outcome": result.kind,
                "doubts": result.doubts,
                "values": result.values,
                "error_by_vertices": result.curve,
                "valence_shares": result.valence_shares,
            }
            for result in comparison.results
        ],
    }
