# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of Python functions: a gyroid, a shell and a sampler of one's own, into out/."""

from pathlib import Path

import neuralmesh
import numpy as np


def gyroid(x, y, z):
    """Zero on a surface with many handles; cut off by a ball, which closes it."""
    wave = np.sin(x) * np.cos(y) + np.sin(y) * np.cos(z) + np.sin(z) * np.cos(x)
    return np.maximum(np.abs(wave) - 0.6, np.sqrt(x * x + y * y + z * z) - 4)


def shell(u, v):
    """Return x, y and z of a sea shell."""
    width = np.exp(u / 8)
    ring = 1.2 + np.cos(v)
    return width * ring * np.cos(u), width * ring * np.sin(u), width * (2.2 + np.sin(v))


class Terrain:
    """A distribution of one's own: low hills, drawn anew for every sample."""

    lower, upper = (0, 0, -0.2), (10, 10, 0.2)

    def draw(self, random, count):
        """Return samples, (count, 3)."""
        x, y = 10 * random.random((2, count))
        return np.column_stack([x, y, 0.2 * np.sin(x) * np.cos(y)])


out = Path("out")
out.mkdir(exist_ok=True)
box = {"lower": (-4.5, -4.5, -4.5), "upper": (4.5, 4.5, 4.5)}
for name, source, parameters in (
    ("gyroid", neuralmesh.ImplicitSurface(gyroid, **box), {"vertices": 2000}),
    ("shell", neuralmesh.ParametricSurface(shell, u=(0, 12), v=(0, 6.2831853)), {"vertices": 1000}),
    ("terrain", Terrain(), {"vertices": 1000, "boundaries": "open"}),
):
    result = neuralmesh.reconstruct(source, **parameters)
    neuralmesh.write(out / f"{name}.ply", result)
    print(f"{name}: {len(result.vertices)} vertices, genus {result.info['genus']},", end=" ")
    print(f"{result.info['boundary_loops']} boundary loops")
