# SPDX-License-Identifier: GPL-3.0-or-later
"""Which method to use for a cloud: a rule over the measured figures, and a sentence for it."""

from __future__ import annotations

from dataclasses import dataclass

from comparison.run import Comparison, Result

# Per cent of faces that may cross another one: a fold or two in a mesh of 5,000 vertices.
CROSSING_FACES = 0.1
# Per cent of a result's area that may lie further than three spacings from all points.
AWAY_FROM_POINTS = 2.0
# Errors this close to each other count as the same.
SAME_ERROR = 1.1

RULE = f"""A result is sound if no edge has more than two faces and at most {CROSSING_FACES:g} % of
its faces cross another. It lies on the data if at most {AWAY_FROM_POINTS:g} % of its area is
further than three point spacings from every point. If some sound, closed result lies on the data,
the cloud is taken for that of a closed surface and only such results stand for choice; otherwise
the scan is taken for open, and all sound results that lie on the data do. Of these, the one with
the least RMS error (both ways taken together) is recommended; where others are within
{100 * (SAME_ERROR - 1):.0f} % of it, the fastest of them."""


@dataclass(frozen=True)
class Verdict:
    """The method recommended ("" if none gave a mesh), a sentence, and more in a second one."""

    method: str
    sentence: str
    more: str = ""


def is_sound(result: Result) -> bool:
    """Whether a mesh is free of what breaks the programs that use it."""
    values = result.values
    crossing = 100 * values["self_intersecting"] / values["faces"]
    return values["non_manifold_edges"] == 0 and crossing <= CROSSING_FACES


def is_closed(result: Result) -> bool:
    """Whether a mesh has no boundary."""
    return bool(result.values["boundary_edges"] == 0)


def lies_on_data(result: Result) -> bool:
    """Whether nearly all of a mesh is near points of the cloud."""
    return bool(result.values["far_from_points"] <= AWAY_FROM_POINTS)


def judge(comparison: Comparison) -> Verdict:
    """Apply the rule to a cloud's results."""
    if comparison.failure:
        return Verdict("", comparison.failure)
    meshes = [result for result in comparison.results if not result.failure]
    if not meshes:
        return Verdict("", "No method gave a mesh.")
    on_data = [result for result in meshes if is_sound(result) and lies_on_data(result)]
    closed = [result for result in on_data if is_closed(result)]
    candidates = closed or on_data or [r for r in meshes if is_sound(r)] or meshes
    best = _best(candidates)
    kind = "closed" if closed else "open" if on_data else "unsure"
    opening = {
        "closed": f"Use {best.name}: of the closed, sound meshes",
        "open": f"The scan is open, so use {best.name}: of the sound meshes that stay on the data",
        "unsure": f"No mesh is both sound and on the data. Try {best.name}: of the rest",
    }[kind]
    alone = len(candidates) == 1
    rank = "it is the only one" if alone else _rank(best, candidates)
    sentence = f"{opening}, {rank} ({_figures(best, comparison)})."
    return Verdict(best.method, sentence, _more(best, candidates, meshes, comparison))


def _best(candidates: list[Result]) -> Result:
    least = min(result.values["rms"] for result in candidates)
    near = [result for result in candidates if result.values["rms"] <= SAME_ERROR * least]
    return min(near, key=lambda result: float(result.values["seconds"]))


def _rank(best: Result, candidates: list[Result]) -> str:
    least = min(candidates, key=lambda result: float(result.values["rms"]))
    if least is not best:
        times = least.values["seconds"] / best.values["seconds"]
        return f"it is as accurate as {least.name} and {times:.1f} times as fast"
    others = [result for result in candidates if result is not best]
    second = min(others, key=lambda result: float(result.values["rms"]))
    times = second.values["rms"] / best.values["rms"]
    if times <= SAME_ERROR:
        return f"it is as accurate as {second.name} and faster"
    return f"it has the least error; that of {second.name} is {times:.1f} times as large"


def _figures(result: Result, comparison: Comparison) -> str:
    assert comparison.cloud is not None  # a comparison without failure has one
    percent = 100 * result.values["rms"] / comparison.cloud.diagonal
    return f"{percent:.2g} % of the diagonal RMS, {result.values['seconds']:.1f} s"


def _more(
    best: Result, candidates: list[Result], meshes: list[Result], comparison: Comparison
) -> str:
    """What speaks for another one: a need for a closed mesh, or for speed."""
    if not is_closed(best):
        closed = [result for result in meshes if is_sound(result) and is_closed(result)]
        if not closed:
            return "No method gave a sound mesh without holes."
        other = _best(closed)
        away = other.values["far_from_points"]
        return (
            f"If it must be closed, use {other.name} ({_figures(other, comparison)}): "
            f"{away:.0f} % of its surface is made up where there are no points."
        )
    faster = [r for r in candidates if r.values["seconds"] < best.values["seconds"] / 2]
    if faster:
        other = _best(faster)
        times = best.values["seconds"] / other.values["seconds"]
        figures = _figures(other, comparison)
        return f"If time matters, {other.name} is {times:.0f} times as fast ({figures})."
    return ""
