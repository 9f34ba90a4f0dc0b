# SPDX-License-Identifier: GPL-3.0-or-later
"""One scan of a batch, from file to file, in an isolated process."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from neuralmesh_tools.batching.per_cent import with_per_cent
from neuralmesh_tools.batching.recipe import Recipe
from neuralmesh_tools.geometry import diagonal

from .. import files
from .._reconstruct import run
from .._result import plain
from .options import FLAGS


def reconstruct(recipe: Recipe, source: str, target: str) -> dict[str, Any]:
    """Read source, reconstruct it by the recipe's parameters, write target.

    Returns the number of vertices and faces, and what the filter returns. Prints what it would log.
    Raises ValueError with a sentence for the user.
    """
    parameters: dict[str, Any] = {**recipe.parameters, "threads": recipe.threads}
    most = parameters.pop("most_points")
    cloud = _read(Path(source), most or None)
    if cloud.is_choice:
        print(f"{cloud.total:,} points, of which a uniform choice of {len(cloud.points):,} is kept")
    result = run(cloud, parameters, names=FLAGS)
    print(result.summary)
    try:
        # A name that is nearly too long has no room for what is put behind it meanwhile.
        written = Path(target).with_name(f"output{recipe.suffix}")
        print(files.write(written, result))
        written.replace(target)
    except OSError as problem:
        reason = problem.strerror or str(problem)
        raise ValueError(f"Its output cannot be written: {reason}.") from None
    results = {"vertices": len(result.vertices), "faces": len(result.faces)}
    return {**results, **with_per_cent(plain(result.info), diagonal(cloud.points))}


def _read(path: Path, most: int | None) -> files.Cloud:
    """The points of a file; raises ValueError with a sentence, which does not name it again."""
    try:
        return files.read(path, most_points=most)
    except files.UnreadableFile as problem:
        raise ValueError(problem.reason[0].upper() + problem.reason[1:]) from None
    except OSError as problem:
        raise ValueError(f"It cannot be read: {problem.strerror or problem}.") from None
