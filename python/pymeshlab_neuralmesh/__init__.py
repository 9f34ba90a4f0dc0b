# SPDX-License-Identifier: GPL-3.0-or-later
"""Neural Mesh Reconstruction for PyMeshLab: importing this makes its filters methods of MeshSet.

    import pymeshlab_neuralmesh as nm

    ms = nm.MeshSet()
    ms.load_new_mesh("cloud.ply")
    result = ms.generate_surface_reconstruction_neural_mesh(targetvertnum=2000)

Counts may be whole floats, `snapshots` a list, `pointfile` a `Path`, which implies `source=3`;
`maxholesize` is a length or a text such as "5%". A name that a filter does not have is a TypeError
that says which one was likely meant.

`MeshSet` is PyMeshLab's own class; here type checkers know the methods that are added to it.
`FILTERS` are the names of these, `__version__` is that of this package. Importing raises
ImportError if the PyMeshLab that is installed is not the version that the plugin was built for.
"""

from __future__ import annotations

from ._binding import FILTERS, MeshSet, installed_version

__all__ = ["FILTERS", "MeshSet", "__version__"]

__version__ = installed_version()
