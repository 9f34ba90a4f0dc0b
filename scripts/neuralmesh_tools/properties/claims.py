# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether what a refusal says of a cloud and its parameters is true."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np

from neuralmesh_tools.geometry import Points, diagonal
from neuralmesh_tools.properties.inputs import Case

# Of the diagonal: what counts as no width (flatExtent of samplers/input_checks.cpp), with what
# principal axes are off where the points are few.
FLAT = 4e-6
# Points of which some may be isolated, and the largest share of them.
LEAST_JUDGED = 500
MOST_ISOLATED = 0.2
# Planes and lines through random points, of which one lies in all points that are not isolated.
TRIALS = 300
STARTS = {0: 4, 1: 6, 2: 12}


def false_claim(sentence: str, case: Case) -> str:
    """Say what is wrong about a refusal, or nothing; also where no claim of it is known here."""
    points = case.recipe.points().astype(float)
    for pattern, is_true in CLAIMS.items():
        if match := re.fullmatch(pattern, sentence):
            return "" if is_true(match, case, points) else f"it is not true: {sentence}"
    return f"there is no such sentence: {sentence}"


def _broken(match: re.Match[str], _: Case, points: Points) -> bool:
    broken = np.flatnonzero(~np.isfinite(points).all(axis=1))
    count, of, first = (int(number) for number in match.groups())
    return (count, of) == (len(broken), len(points)) and first == next(iter(broken), -1)


def _one_place(_match: re.Match[str], _: Case, points: Points) -> bool:
    return diagonal(points) == 0


def _few_distinct(match: re.Match[str], _: Case, points: Points) -> bool:
    return _may_be_distinct(int(match[1]), points)


def _lie_on(match: re.Match[str], _: Case, points: Points) -> bool:
    """All points, but for so many, within a flat of so many dimensions."""
    isolated = int(match["ignored"] or 0)
    dimensions = 2 if match["flat"] == "plane" else 1
    if isolated > MOST_ISOLATED * len(points):
        return False
    if isolated == 0:
        return _width_beyond(points, dimensions) <= FLAT
    generator = np.random.default_rng(0)
    for _trial in range(TRIALS):
        through = points[generator.choice(len(points), dimensions + 1, replace=False)]
        axes = np.linalg.svd(through[1:] - through[0])[2][:dimensions]
        off = (points - through[0]) - (points - through[0]) @ axes.T @ axes
        nearest = np.argsort(np.linalg.norm(off, axis=1))[: len(points) - isolated]
        if _width_beyond(points[nearest], dimensions) <= FLAT:
            return True
    return False


def _width_beyond(points: Points, dimensions: int) -> float:
    """The largest width across a flat of so many dimensions that fits best, in diagonals."""
    centred = points - points.mean(axis=0)
    size = diagonal(points)
    across = np.linalg.svd(centred / size, full_matrices=False)[2][dimensions:]
    return float(np.ptp(centred @ across.T, axis=0).max()) / size


def _too_many_vertices(match: re.Match[str], case: Case, points: Points) -> bool:
    asked, distinct, most = (int(number) for number in match.groups())
    is_asked = asked == case.parameters["targetvertnum"]
    return is_asked and distinct == most < asked and _may_be_distinct(distinct, points)


def _may_be_distinct(count: int, points: Points) -> bool:
    """Whether so many places are left where isolated points are."""
    places = len(np.unique(points, axis=0))
    least = places if len(points) < LEAST_JUDGED else (1 - MOST_ISOLATED) * places
    return least <= count <= places


def _below_start(match: re.Match[str], case: Case, _: Points) -> bool:
    """What is asked for is below the start: of a known solid, or of a mesh from the data."""
    name, asked, least = match[1], int(match[2]), int(match[3])
    is_solid = case.parameters.get("topology", 1) == 0 and case.parameters.get("startmesh", 0) != 4
    is_start = least == STARTS[case.parameters.get("startmesh", 0)] if is_solid else True
    return is_start and asked == int(case.parameters[name]) and asked < least


def _snapshot_above_target(match: re.Match[str], case: Case, _: Points) -> bool:
    asked, target = int(match[1]), int(match[2])
    is_asked = asked == int(case.parameters["snapshots"])
    return is_asked and asked > target == case.parameters["targetvertnum"]


_ALL = r"All points(?: but (?P<ignored>\d+) isolated ones?)? lie on a (?P<flat>line|plane)"
CLAIMS: dict[str, Callable[[re.Match[str], Case, Points], bool]] = {
    r"(\d+) of (\d+) points have coordinates that are NaN or infinite \(the first is point (\d+)\)"
    r"\. Remove them and try again\.": _broken,
    r"All points lie in one place: there is no surface to reconstruct\.": _one_place,
    r"Only (\d+) distinct points: a closed surface needs at least 4\.": _few_distinct,
    _ALL + r": there is no surface to reconstruct\.": _lie_on,
    _ALL + r": a closed surface cannot be fitted to them\. Use topology=1, which makes a sheet of "
    r"them\.": _lie_on,
    _ALL + r", and are too few or too uneven for a sheet to be found in them\.": _lie_on,
    r"targetvertnum is (\d+), but there are only (\d+) distinct points to draw from: at most (\d+) "
    r"vertices are possible\.": _too_many_vertices,
    r"(targetvertnum) is (\d+), fewer than the (\d+) vertices of the starting mesh\.": _below_start,
    r"(snapshots) names (\d+) vertices, fewer than the (\d+) vertices of the starting mesh\.":
        _below_start,
    r"snapshots names (\d+) vertices, more than targetvertnum, which is (\d+)\.":
        _snapshot_above_target,
}  # fmt: skip
