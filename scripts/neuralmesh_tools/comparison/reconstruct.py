# SPDX-License-Identifier: GPL-3.0-or-later
"""One method on one cloud, cut down to several numbers of vertices.

To be called in an isolated process, in a folder of its own: one of the filters leaves files behind.
"""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import numpy as np

from neuralmesh_tools.comparison.clouds import Cloud
from neuralmesh_tools.layers import document_of, figures_of, load_plugin
from neuralmesh_tools.methods import METHODS, Reconstruction, Task, cut_down, reconstruct


def reconstruct_at_counts(
    name: str, cloud: Cloud, counts: list[int], plugin: Path | None, threads: int
) -> list[Reconstruction]:
    """Reconstruct a cloud and return a mesh for each count of vertices, the largest first.

    Our method runs once a count, and prints its log for the first: the filter of a plugin, or
    without one the package neuralmesh. The others run once, and are
    then decimated, each from the mesh before. Normals are those of the cloud; the time to
    estimate them is not counted. Raises ValueError if a result has no faces,
    and what PyMeshLab raises.
    """
    method = METHODS[name]
    counts = sorted(counts, reverse=True)
    task = Task(counts[0], threads, cloud.spacing)
    if method.exact and plugin is None:
        return [_by_package(cloud, count, threads, count == counts[0]) for count in counts]
    if method.exact:
        load_plugin(plugin)
        tasks = [replace(task, vertices=count) for count in counts]
        # The log is that of the first, the largest.
        documents = (document_of(cloud.points, verbose=number == 0) for number in range(len(tasks)))
        return [reconstruct(method, *pair) for pair in zip(documents, tasks, strict=True)]
    document = document_of(cloud.points, normals=cloud.normals)
    meshes = [cut_down(reconstruct(method, document, task), counts[0])]
    for count in counts[1:]:
        meshes.append(cut_down(meshes[-1], count))
    return meshes


def _by_package(cloud: Cloud, count: int, threads: int, verbose: bool) -> Reconstruction:
    """Our method without a plugin; the mesh is the same."""
    import neuralmesh

    start, cpu_start = time.perf_counter(), time.process_time()
    result = neuralmesh.reconstruct(cloud.points, count, threads=threads)
    seconds, cpu_seconds = time.perf_counter() - start, time.process_time() - cpu_start
    if verbose:
        print(result.summary)
    faces = result.faces.astype(np.int32, order="C")
    return Reconstruction(result.vertices, faces, seconds, cpu_seconds, figures_of(result.info))
