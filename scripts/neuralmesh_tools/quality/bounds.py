# SPDX-License-Identifier: GPL-3.0-or-later
"""The bounds that the quality of the defaults has to keep to, against the rows of a run.

Each bound is one line: what it is, what was measured, whether it is kept. Without its rows it says
"not measured".
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from neuralmesh_tools.quality.models import MODELS
from neuralmesh_tools.quality.run import Row

BEST, TRUE = "poisson-best", "poisson-true"

# Of our error, in that of Poisson at its best.
BEST_LIMITS = {
    "clean": 0.9,
    "noise0.2": 0.95,
    "noise0.5": 0.95,
    "outliers": 0.8,
    "uneven": 0.9,
    "sparse": 0.65,
}


@dataclass(frozen=True)
class Bound:
    """One line of the summary; kept is None when nothing was measured."""

    bound: str
    measured: str
    kept: bool | None


class Rows:
    """Rows by model, condition and method, over all seeds that were run."""

    def __init__(self, rows: list[Row], ours: str = "ours") -> None:
        """Index the rows; ours is the label of the method that the bounds are for."""
        self.ours = ours
        self.by_key: dict[tuple[str, str, str, int], Row] = {
            (row.group.model, row.group.condition, row.method, row.group.seed): row for row in rows
        }
        self.models = list(dict.fromkeys(row.group.model for row in rows))
        self.seeds = sorted({row.group.seed for row in rows})

    def of(self, model: str, condition: str, method: str | None = None) -> list[Row]:
        """Rows of one case, one a seed, in order of seeds; failures included."""
        keys = [(model, condition, method or self.ours, seed) for seed in self.seeds]
        return [self.by_key[key] for key in keys if key in self.by_key]

    def pairs(self, model: str, condition: str, other: str) -> list[tuple[Row, Row]]:
        """Ours and another method's row of the same case, for each seed that has both."""
        mine = {row.group.seed: row for row in self.of(model, condition)}
        theirs = self.of(model, condition, other)
        return [(mine[row.group.seed], row) for row in theirs if row.group.seed in mine]

    def ratios(self, condition: str, peer: str, metric: Callable[[Row], float]) -> dict[str, float]:
        """Ours divided by the peer's, a model: geometric mean over seeds where both gave a mesh.

        A failure of ours counts as infinity, so that it cannot hide.
        """
        found = {}
        for model in self.models:
            logs = []
            for mine, other in self.pairs(model, condition, peer):
                if not other.failed:
                    logs.append(np.inf if mine.failed else np.log(metric(mine) / metric(other)))
            if logs:
                found[model] = float(np.exp(np.mean(logs)))
        return found


def to_mesh(row: Row) -> float:
    """RMS distance from the reference surface to the mesh, %."""
    return float(row.values["rms_to_mesh"])


def to_surface(row: Row) -> float:
    """RMS distance from the mesh to the reference surface, %."""
    return float(row.values["rms_to_surface"])


def hausdorff(row: Row) -> float:
    """The larger of both one-sided worst distances, %."""
    return float(max(row.values["max_to_mesh"], row.values["max_to_surface"]))


def wrong_handles(row: Row) -> float:
    """How far the genus is from the model's; infinite where there is none (open, non-manifold)."""
    found = row.values["genus"]
    return np.inf if found is None else abs(float(found) - MODELS[row.group.model].genus)


def all_bounds(rows: list[Row], ours: str = "ours") -> list[Bound]:
    """Every bound: a single model first, then the models together, then evenness and time."""
    table = Rows(rows, ours)
    return [
        *clean_bunny(table),
        *clean_models(table),
        *against_best_poisson(table),
        *models_with_handles(table),
        *outliers(table),
        *cortex(table),
        *evenness(table),
        fit_cost(table),
    ]


def clean_bunny(table: Rows) -> list[Bound]:
    """Error, worst distance, self-intersections and count on the clean bunny."""
    only = Rows([row for row in table.by_key.values() if row.group.model == "bunny"], table.ours)
    mine = table.of("bunny", "clean")
    error, worst = (only.ratios("clean", TRUE, metric) for metric in (to_mesh, hausdorff))
    return [
        ratio_bound("bunny clean: RMS to mesh ÷ Poisson true", 1.0, error),
        ratio_bound("bunny clean: Hausdorff ÷ Poisson true", 1.5, worst),
        count_bound("bunny clean: self-intersecting faces", 0, mine, "self_intersecting"),
        count_bound(
            "bunny clean: vertices off the target",
            0,
            mine,
            lambda row: abs(row.values["vertices"] - row.group.vertices),
        ),
    ]


def clean_models(table: Rows) -> list[Bound]:
    """The same ratio over all clean models: the geometric mean, and the worst."""
    name = "clean models: RMS to mesh ÷ Poisson true"
    ratios = table.ratios("clean", TRUE, to_mesh)
    return [
        ratio_bound(name, 1.0, ratios),
        ratio_bound(name, 1.5, ratios, worst=True),
    ]


def against_best_poisson(table: Rows) -> list[Bound]:
    """Ratios to Poisson at its best for each input, both ways, in each condition."""
    return [
        ratio_bound(
            f"{condition}: RMS {way} ÷ Poisson best",
            limit,
            table.ratios(condition, BEST, metric),
        )
        for condition, limit in BEST_LIMITS.items()
        for way, metric in (("to mesh", to_mesh), ("to surface", to_surface))
    ]


def models_with_handles(table: Rows) -> list[Bound]:
    """Clean models of genus 1 and more, both ways."""
    rows = [row for row in table.by_key.values() if MODELS[row.group.model].genus > 0]
    handled = Rows(rows, table.ours)
    return [
        ratio_bound(
            f"clean models with handles: RMS {way} ÷ Poisson true",
            0.95,
            handled.ratios("clean", TRUE, metric),
        )
        for way, metric in (("to mesh", to_mesh), ("to surface", to_surface))
    ]


def outliers(table: Rows) -> list[Bound]:
    """Topology and folds among outliers."""
    bounds = []
    mine = [row for model in table.models for row in table.of(model, "outliers")]
    bounds.append(count_bound("outliers: handles too many or too few", 0, mine, wrong_handles))
    bounds.append(count_bound("outliers: components", 1, mine, "components"))
    bounds.append(
        count_bound(
            "outliers: self-intersecting % of faces",
            0.1,
            mine,
            lambda row: 100 * row.values["self_intersecting"] / row.values["faces"],
        )
    )
    return bounds


def cortex(table: Rows) -> list[Bound]:
    """No face across a sulcus, closed, genus 0."""
    mine = table.of("cortex", "clean")
    return [
        count_bound("cortex clean: worst distance to surface, %", 1.5, mine, "max_to_surface"),
        count_bound("cortex clean: boundary edges", 0, mine, "boundary_edges"),
        count_bound("cortex clean: handles", 0, mine, wrong_handles),
    ]


def evenness(table: Rows) -> list[Bound]:
    """Valences and angles on the paper's kind of models."""
    mine = [row for model in ("bunny", "armadillo", "dino") for row in table.of(model, "clean")]
    where = "bunny, armadillo, dino clean"
    return [
        count_bound(f"{where}: valence 6, %", 65, mine, "valence_6", at_least=True),
        count_bound(f"{where}: valence 5–7, %", 99.5, mine, "valence_5_to_7", at_least=True),
        count_bound(f"{where}: 1 % angle, °", 20, mine, "angle_1_percent", at_least=True),
    ]


def fit_cost(table: Rows) -> Bound:
    """The closing fit's share of the seconds, from the run without it."""
    shares = []
    for model in table.models:
        for mine, bare in table.pairs(model, "clean", "ours-no-fit"):
            if not mine.failed and not bare.failed:
                shares.append(100 * (1 - bare.values["seconds"] / mine.values["seconds"]))
    if not shares:
        return Bound("the fit's share of the time ≤ 20 %", "not measured", None)
    share = float(np.median(shares))
    return Bound("the fit's share of the time ≤ 20 %", f"{share:.0f} % (median)", share <= 20)


def ratio_bound(name: str, limit: float, ratios: dict[str, float], *, worst: bool = False) -> Bound:
    """Ratios to a peer by model: their geometric mean, or the worst of them, against the limit."""
    kind = "worst" if worst else "geometric mean"
    bound = f"{name} ≤ {limit:g}" if len(ratios) == 1 else f"{name}, {kind} ≤ {limit:g}"
    if not ratios:
        return Bound(bound, "not measured", None)
    names = sorted(ratios, key=lambda model: ratios[model])
    mean = float(np.exp(np.mean(np.log(list(ratios.values())))))
    value = ratios[names[-1]] if worst else mean
    measured = f"{value:.2f}"
    if len(ratios) > 1:
        spread = f"{names[0]} {ratios[names[0]]:.2f} … {names[-1]} {ratios[names[-1]]:.2f}"
        measured += f" ({len(ratios)} models: {spread})"
    return Bound(bound, measured, value <= limit)


def count_bound(
    name: str,
    limit: float,
    rows: list[Row],
    metric: str | Callable[[Row], float],
    at_least: bool = False,
) -> Bound:
    """A figure of our own rows: the worst of them against the limit; a failure never keeps it."""
    bound = f"{name} {'≥' if at_least else '≤'} {limit:g}"
    if not rows:
        return Bound(bound, "not measured", None)
    failures = [row for row in rows if row.failed]
    if failures:
        return Bound(bound, f"{failures[0].group.model} failed", False)
    values = [row.values[metric] if isinstance(metric, str) else metric(row) for row in rows]
    worst = min(range(len(rows)), key=lambda k: values[k] if at_least else -values[k])
    kept = values[worst] >= limit if at_least else values[worst] <= limit
    where = f" ({rows[worst].group.model})" if len(rows) > 1 else ""
    return Bound(bound, f"{values[worst]:.4g}{where}", kept)


def bounds_markdown(bounds: list[Bound]) -> str:
    """The summary as a table."""
    marks = {True: "yes", False: "NO", None: "–"}
    lines = ["| bound | measured | kept |", "|---|---|---|"]
    lines += [f"| {each.bound} | {each.measured} | {marks[each.kept]} |" for each in bounds]
    return "\n".join(lines)
