# SPDX-License-Identifier: GPL-3.0-or-later
"""Which method to use for a cloud: a rule over the measured figures, and a sentence for it."""

from __future__ import annotations

from dataclasses import dataclass

from neuralmesh_tools.comparison.run import Comparison, Result

# Per cent of faces that may cross another one, and of edges that may have more than two faces.
FLAWS = 0.5
# Per cent of a result's area that may lie further than three spacings from all points.
AWAY_FROM_POINTS = 2.0
# Errors this close to each other count as the same.
SAME_ERROR = 1.1

RULE = f"""A result is closed if every edge has two faces. It is sound if at most {FLAWS:g} % of its
faces cross another and at most {FLAWS:g} % of its edges have more than two faces. It lies on the
data if at most {AWAY_FROM_POINTS:g} % of its area is further than three point spacings from every
point. If some sound, closed result lies on the data, the cloud is taken for that of a closed
surface and only such results stand for choice; otherwise the scan is taken for open, and all sound
results that lie on the data do. Of these, the one with the least RMS error (both ways taken
together) is recommended; where others are within {100 * (SAME_ERROR - 1):.0f} % of it, the fastest
of them."""


@dataclass(frozen=True)
class Verdict:
    """The method recommended ("" if none gave a mesh), a sentence, and more in a second one."""

    method: str
    sentence: str
    more: str = ""


def is_sound(result: Result) -> bool:
    """Whether a mesh is nearly free of what breaks the programs that use it."""
    values = result.values
    edges = 1.5 * values["faces"]  # of a closed mesh; an open one has a few more
    return bool(
        values["self_intersecting"] <= FLAWS / 100 * values["faces"]
        and values["non_manifold_edges"] <= FLAWS / 100 * edges
    )


def is_closed(result: Result) -> bool:
    """Whether every edge of a mesh has two faces."""
    return bool(result.values["boundary_edges"] == result.values["non_manifold_edges"] == 0)


def lies_on_data(result: Result) -> bool:
    """Whether nearly all of a mesh is near points of the cloud."""
    return bool(result.values["far_from_points"] <= AWAY_FROM_POINTS)


def judge(comparison: Comparison) -> Verdict:
    """Apply the rule to a cloud's results."""
    if comparison.failure:
        return Verdict("", comparison.failure)
    meshes = [result for result in comparison.results if not result.failure]
    late = _given_up(comparison)
    if not meshes:
        return Verdict("", "No method gave a mesh.", late)
    on_data = [result for result in meshes if is_sound(result) and lies_on_data(result)]
    closed = [result for result in on_data if is_closed(result)]
    candidates = closed or on_data or [r for r in meshes if is_sound(r)] or meshes
    best = _best(candidates)
    kind = "closed, sound meshes" if closed else "sound meshes that stay on the data"
    if closed:
        opening = f"Use {best.name}"
    elif on_data:
        opening = f"The scan is open: use {best.name}"
    else:
        opening, kind = f"No mesh is both sound and on the data. Try {best.name}", "meshes"
    rank = _rank(best, candidates, kind)
    sentence = f"{opening}, {_figures(best)}: {rank}."
    more = [_more(best, candidates, meshes), _doubted(best), late]
    return Verdict(best.method, sentence, " ".join(filter(None, more)))


def _doubted(best: Result) -> str:
    return f"Look at it before you trust it: {best.doubts}" if best.doubts else ""


def _given_up(comparison: Comparison) -> str:
    """Name the methods that did not end in time: what they would have made is not known."""
    late = [result.name for result in comparison.results if result.kind == "timed out"]
    if not late:
        return ""
    names = " and ".join([", ".join(late[:-1]), late[-1]] if late[1:] else late)
    text = f"{names} timed out: a longer --timeout may change the answer."
    return text[0].upper() + text[1:]


def _best(candidates: list[Result]) -> Result:
    least = min(result.values["rms_percent"] for result in candidates)
    near = [result for result in candidates if result.values["rms_percent"] <= SAME_ERROR * least]
    return min(near, key=lambda result: float(result.values["seconds"]))


def _rank(best: Result, candidates: list[Result], kind: str) -> str:
    """Why it is the best of the candidates, which are of this kind."""
    others = [result for result in candidates if result is not best]
    if not others:
        return f"there are no other {kind}"
    next_best = min(others, key=lambda result: float(result.values["rms_percent"]))
    if best.values["rms_percent"] == 0 < next_best.values["rms_percent"]:
        return f"without error, alone of the {kind}"
    times = (
        next_best.values["rms_percent"] / best.values["rms_percent"]
        if best.values["rms_percent"]
        else 1.0
    )
    if times > SAME_ERROR:
        return f"the least error of the {kind}; {next_best.name} has {times:.2g} times as much"
    speed = next_best.values["seconds"] / best.values["seconds"]
    return f"as accurate as {next_best.name} and {speed:.2g} times as fast"


def _figures(result: Result) -> str:
    seconds = result.values["seconds"]
    return f"RMS error {result.values['rms_percent']:.2g} % of the diagonal, {seconds:.1f} s"


def _more(best: Result, candidates: list[Result], meshes: list[Result]) -> str:
    """What speaks for another one: a need for a closed mesh, or for speed."""
    if not is_closed(best):
        closed = [result for result in meshes if is_sound(result) and is_closed(result)]
        if not closed:
            return "No method gave a sound mesh without holes."
        other = _best(closed)
        away = other.values["far_from_points"]
        return (
            f"If it must be closed, use {other.name} ({_figures(other)}): "
            f"{away:.0f} % of its surface is made up where there are no points."
        )
    faster = [r for r in candidates if r.values["seconds"] < best.values["seconds"] / 2]
    if faster:
        other = _best(faster)
        times = best.values["seconds"] / other.values["seconds"]
        figures = _figures(other)
        return f"If time matters, {other.name} is {times:.0f} times as fast ({figures})."
    return ""
