# SPDX-License-Identifier: GPL-3.0-or-later
"""A cloud as the methods get it, and the reference that their results are measured against."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import KDTree

from neuralmesh_tools.geometry import Faces, Points, diagonal, face_normals, sample_surface
from neuralmesh_tools.layers import arrays_of, document_of, read_document, why_no_points
from neuralmesh_tools.methods import NORMAL_NEIGHBOURS, estimate_normals
from neuralmesh_tools.metrics import point_distances

# Distances between neighbours are taken at so many points: their median needs no more.
SPACING_SAMPLES = 10_000
REFERENCE_SAMPLES = 50_000
SEED = 20030512
# A vertex within so many spacings of the points can be judged by their tangent planes.
REACH = 3.0
# In the report's view of the cloud.
POINTS_SHOWN = 15_000
# Of the length of a normal: below, it is none.
LEAST_NORMAL = 1e-6
# What PyMeshLab reads with normals or faces; of other formats the package is the better reader.
WITH_NORMALS = (".ply", ".obj", ".stl", ".off")


@dataclass(frozen=True)
class Cloud:
    """Points (n, 3), unit normals (n, 3) and where these are from, in a sentence.

    spacing: the median distance of a point to its nearest neighbour. Lengths are in the input's
    units.
    """

    points: Points
    normals: Points
    normals_from: str
    spacing: float

    @property
    def diagonal(self) -> float:
        """The length of the bounding box's diagonal."""
        return diagonal(self.points)

    def facts(self) -> CloudFacts:
        """What the report says and shows of it."""
        shown = self.points
        if len(shown) > POINTS_SHOWN:
            generator = np.random.default_rng(SEED)
            shown = shown[generator.choice(len(shown), POINTS_SHOWN, replace=False)]
        return CloudFacts(
            len(self.points), self.normals_from, self.spacing, self.diagonal, shown.astype("f4")
        )


@dataclass(frozen=True)
class CloudFacts:
    """What is kept of a cloud: its number of points, its sizes, and some points (k, 3) to show."""

    count: int
    normals_from: str
    spacing: float
    diagonal: float
    shown: NDArray[np.float32]


def load_cloud(path: str) -> Cloud:
    """Read the vertices of a file that PyMeshLab reads; estimate normals if it brings none.

    Raises ValueError with a sentence if it cannot be read or holds fewer points than a normal
    needs.
    """
    points, normals, faces = _read(path)
    if len(points) == 0:
        raise ValueError(why_no_points(Path(path)))
    return _cloud(points, normals, faces)


def load_cloud_by_package(path: str) -> Cloud:
    """Read the points of a file of any format that the package neuralmesh reads, or PyMeshLab.

    Normals are taken from the formats of meshes only, and estimated for the others.
    Raises ValueError as load_cloud does.
    """
    from neuralmesh import files

    suffix = Path(path).suffix.lower()
    is_read = any(suffix in known.suffixes for known in files.FORMATS)
    if suffix in WITH_NORMALS or not is_read:
        return load_cloud(path)
    try:
        points = files.read(path).points
    except files.UnreadableFile as problem:
        raise ValueError(problem.reason[0].upper() + problem.reason[1:]) from None
    broken = np.count_nonzero(~np.isfinite(points).all(axis=1))
    if broken:
        raise ValueError(f"{broken} of its points have coordinates that are NaN or infinite.")
    points = _distinct(points)
    return _cloud(points, np.zeros_like(points), np.empty((0, 3), np.int32))


def _cloud(points: Points, normals: Points, faces: Faces) -> Cloud:
    """A cloud with its normals, which are zero where there are none."""
    if len(points) <= NORMAL_NEIGHBOURS:
        raise ValueError(f"It holds {len(points)} points; {NORMAL_NEIGHBOURS + 1} are the least.")
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    if np.all(lengths > LEAST_NORMAL):
        source = "computed from its faces" if len(faces) else "its own"
        normals = normals / lengths
    else:
        document = document_of(points)
        estimate_normals(document)
        normals = document.current_mesh().vertex_normal_matrix().copy()
        source = f"estimated from {NORMAL_NEIGHBOURS} neighbours, as it has none"
    return Cloud(points, normals, source, _spacing(points))


def _read(path: str) -> tuple[Points, Points, Faces]:
    """Vertices, their normals (zero without any) and faces of a file, without repeated points."""
    document = read_document(Path(path))
    mesh = document.current_mesh()
    points, normals = mesh.vertex_matrix(), mesh.vertex_normal_matrix()
    kept = _first_of_each(points)
    return points[kept], normals[kept], mesh.face_matrix().copy()


def _distinct(points: Points) -> Points:
    return np.ascontiguousarray(points[_first_of_each(points)])


def _first_of_each(points: Points) -> NDArray[np.intp]:
    _, first = np.unique(points, axis=0, return_index=True)
    return np.sort(first)


def _spacing(points: Points) -> float:
    generator = np.random.default_rng(SEED)
    chosen = points
    if len(points) > SPACING_SAMPLES:
        chosen = points[generator.choice(len(points), SPACING_SAMPLES, replace=False)]
    distances, _ = KDTree(points).query(chosen, k=2)
    return float(np.median(distances[:, 1]))


class Reference:
    """What a result is measured against: a surface, or the cloud itself.

    probes (n, 3) with unit normals (n, 3) are points of it, at most REFERENCE_SAMPLES.
    """

    def __init__(self, cloud: Cloud, surface: tuple[Points, Faces] | None) -> None:
        """Take a surface, vertices (n, 3) and faces (m, 3), or the cloud if that is None."""
        generator = np.random.default_rng(SEED)
        self.surface = surface
        self.reach = REACH * cloud.spacing
        if surface is not None:
            self.probes, self.normals = sample_surface(*surface, REFERENCE_SAMPLES, generator)
        else:
            chosen = np.arange(len(cloud.points))
            if len(chosen) > REFERENCE_SAMPLES:
                chosen = generator.choice(chosen, REFERENCE_SAMPLES, replace=False)
            self.probes, self.normals = cloud.points[chosen], cloud.normals[chosen]
        self._cloud = cloud
        self._tree = KDTree(cloud.points)

    def distances(self, points: Points) -> NDArray[np.float64]:
        """Distances (k,) of points (k, 3) to the reference.

        To a surface they are exact. To a cloud they are those to the tangent plane at the nearest
        of its points, so that the gaps between points are no error; but to the point itself where
        it is more than three spacings away.
        """
        if self.surface is not None:
            return point_distances(points, *self.surface)
        away, nearest = self._tree.query(points)
        offset = points - self._cloud.points[nearest]
        planar = np.abs(np.sum(offset * self._cloud.normals[nearest], axis=1))
        found: NDArray[np.float64] = np.where(away <= self.reach, planar, away)
        return found

    def far_from_points(self, points: Points) -> NDArray[np.bool_]:
        """Which of the points (k, 3) are more than three spacings from every point of the cloud."""
        away, _ = self._tree.query(points)
        return np.asarray(away > self.reach)


def load_surface(path: str) -> tuple[Points, Faces]:
    """Read the triangles of a reference; raises ValueError if it has none."""
    points, faces = arrays_of(read_document(Path(path)))
    if len(faces) == 0:
        raise ValueError("It has no faces, so it is no surface to measure against.")
    if not np.any(np.linalg.norm(face_normals(points, faces), axis=1) > 0):
        raise ValueError("None of its faces has an area.")
    return points, faces
