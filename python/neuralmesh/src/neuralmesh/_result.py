# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reconstruction gives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Mesh:
    """A triangle mesh, an oriented two-manifold."""

    vertices: NDArray[np.float64]
    """(n, 3), in the units and coordinates of the input."""
    faces: NDArray[np.int32]
    """(m, 3), numbers of vertices, counter-clockwise seen from outside."""
    colours: NDArray[np.uint8] | None = None
    """(n, 4), red, green, blue and alpha, where the input had colours."""
    quality: NDArray[np.float64] | None = None
    """(n,), where the input had a quality."""

    def __repr__(self) -> str:
        """Sizes: arrays are too long to print."""
        return f"{type(self).__name__}({len(self.vertices)} vertices, {len(self.faces)} faces)"


@dataclass(frozen=True, eq=False, repr=False)
class Result(Mesh):
    """A reconstruction."""

    info: dict[str, Any] = field(default_factory=dict)
    """What the filter returns, under the same names: `genus`, `rms_error`, `seconds` and others."""
    snapshots: list[Mesh] = field(default_factory=list)
    """The meshes at the vertex counts of the parameter `snapshots`, by count."""
    summary: str = ""
    """What the filter logs: figures, topology, and warnings about what is not to be trusted."""


def plain(info: Mapping[str, Any]) -> dict[str, Any]:
    """Return `info` with lists for arrays: it can be written as JSON."""
    return {
        key: value.tolist() if isinstance(value, np.ndarray) else value
        for key, value in info.items()
    }
