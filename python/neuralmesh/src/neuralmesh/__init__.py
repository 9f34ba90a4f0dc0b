# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface reconstruction from points: a growing neural network that is the mesh.

    import numpy as np
    import neuralmesh

    points = np.load("cloud.npy")                         # (N, 3)
    result = neuralmesh.reconstruct(points, vertices=5000)
    result.vertices, result.faces                         # (5000, 3), (M, 3)
    neuralmesh.write("mesh.ply", result)

The method is that of Ivrissimtzis, Jeong and Seidel, "Using Growing Cell Structures for Surface
Reconstruction", Shape Modeling International 2003. The same input, parameters and seed give the
same mesh as the filter of PyMeshLab, bit for bit.
"""

from __future__ import annotations

import atexit

from . import _core
from ._core import Cancelled, InvalidInput, __version__
from ._reconstruct import reconstruct
from ._result import Mesh, Result
from ._sources import ImplicitSurface, ParametricSurface, Sampler, Surface
from .files import Cloud, read, write

__all__ = [
    "Cancelled",
    "Cloud",
    "ImplicitSurface",
    "InvalidInput",
    "Mesh",
    "ParametricSurface",
    "Result",
    "Sampler",
    "Surface",
    "__version__",
    "read",
    "reconstruct",
    "write",
]

# A thread that was cancelled a moment ago must not outlive the interpreter.
atexit.register(_core.join_abandoned)
