# SPDX-License-Identifier: GPL-3.0-or-later
"""The function that everything else is for."""

from __future__ import annotations

import os
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core, files
from ._arrays import Points, as_colours, as_faces, as_points, as_quality, attribute_values
from ._core import InvalidInput
from ._implicit import ImplicitSampler
from ._parameters import Options, read_options, single
from ._parametric import ParametricSampler
from ._progress import Progress, part, reporting
from ._result import Mesh, Result
from ._sources import ImplicitSurface, ParametricSurface, Sampler, Surface

Source = (
    ArrayLike
    | str
    | os.PathLike[str]
    | Surface
    | ImplicitSurface
    | ParametricSurface
    | Sampler
    | files.Cloud
)

# Of the time of a run: the input is opened, which is one pass over a file.
SHARE_OF_OPENING = 0.1
DEFAULT_VERTICES = 5000
# Singular values of points on a plane differ by as much as rounding leaves.
FLATNESS = 1e-9


def reconstruct(
    points: Source,
    vertices: int | None = None,
    *,
    colours: ArrayLike | None = None,
    quality: ArrayLike | None = None,
    progress: Progress | bool | None = None,
    **parameters: Any,
) -> Result:
    """Grow a mesh of exactly so many vertices that learns the shape of the points.

    The method is that of Ivrissimtzis, Jeong and Seidel, "Using Growing Cell Structures for Surface
    Reconstruction" (SMI 2003). No normals are needed. The same input, parameters and seed give the
    same mesh, bit for bit, and the same as the filter of PyMeshLab.

    Parameters
    ----------
    points
        (N, 3), float32 or float64, of any strides; other numbers are converted. They are read once
        into a copy in double precision, 24 bytes a point. Or: the path of a file, of which binary
        PLY, LAS and NPY are read in place, without a copy; a `Cloud` that was read; a `Surface`; an
        `ImplicitSurface`; a `ParametricSurface`; a `Sampler` of your own.
    vertices
        Of the result: by default 5000, or half the points where there are fewer than 10,000. At
        least 4, at most the number of distinct points. Also `target_vert_num`.
    colours
        (N, 3) or (N, 4): whole numbers up to 255, or shares of 1. Averaged onto the result.
    quality
        (N,): averaged onto the result; with `density_from_quality`, points are drawn in proportion
        to it.
    progress
        True: a bar on standard error. A function: it is told the share that is done and the
        activity, on this thread, some ten times a second; where it returns False, `Cancelled` is
        raised.
    parameters
        Those of the filter, in snake case or as PyMeshLab spells them: `topology`, `boundaries`,
        `max_hole_size` (a length in units of the input, or "10 %" of its diagonal), `snapshots`,
        `random_seed`, `surface_fit`, `transfer_attributes`, `start_mesh` (also a pair of arrays:
        vertices and faces of a closed two-manifold), `density_from_quality`, `threads`,
        `winner_rate`, `smoothing_rate`, `smoothing_passes`, `signals_per_split`,
        `inactivity_factor`, `counter_decay`, `split_rule`, `edge_flips`, `time_limit` (seconds,
        after which the mesh so far is returned, and `info["reached_target"]` is False).
        docs/parameters.md says what they do.

    Returns
    -------
    Result
        Vertices (n, 3) float64 and faces (m, 3) int32, which are not copied from the core, `info`
        with the filter's results, `snapshots`, and `summary`, what the filter would log.

    Raises
    ------
    InvalidInput
        A ValueError: the input or a parameter cannot be used; the sentence says why.
    TypeError
        An unknown parameter, with the nearest that there is; or a value of another type.
    Cancelled, KeyboardInterrupt
        `progress` returned False; Ctrl-C was pressed, within 0.2 s.
    MemoryError, OSError
    """
    if vertices is not None:
        parameters = {"vertices": vertices, **parameters}
    with reporting(progress) as report:
        return run(points, parameters, colours=colours, quality=quality, progress=report)


@dataclass
class Input:
    """What is sampled, with the attributes that the result may take."""

    target: _core.Target
    points: Points | None = None
    faces: NDArray[np.int64] | None = None
    colours: NDArray[np.uint8] | None = None
    quality: NDArray[np.float64] | None = None


def run(
    source: Any,
    parameters: Mapping[str, Any],
    *,
    colours: ArrayLike | None = None,
    quality: ArrayLike | None = None,
    progress: Progress | None = None,
    names: Mapping[str, str] | None = None,
    deadline: _core.Deadline | None = None,
) -> Result:
    """Reconstruct; `names` says what the caller typed for parameters that were no keywords.

    A `deadline` that was set before takes the place of the time limit.
    """
    begin = time.perf_counter()
    options = read_options(parameters, names)
    options.deadline = deadline or options.deadline
    if isinstance(source, str | os.PathLike):
        source = _of_path(Path(source), options, part(progress, 0, SHARE_OF_OPENING))
    if isinstance(source, files.Cloud):
        colours = source.colours if colours is None else colours
        quality = source.quality if quality is None else quality
        source = source.points
    opened = _open(source, colours, quality, options, part(progress, 0, SHARE_OF_OPENING))
    if options.max_hole_share is not None:
        options.core.max_hole_size = options.max_hole_share * opened.target.diagonal
    options.core.max_hole_size = single(options.core.max_hole_size)
    arrays, info, snapshots, summary = _grow(opened.target, options, progress)
    meshes = [_with_attributes(mesh, opened, options) for mesh in (*snapshots, arrays)]
    info["seconds"] = time.perf_counter() - begin
    remark = opened.target.outlier_remark
    if progress is not None:
        progress(1.0, "Done")
    result = meshes.pop()
    return Result(
        result.vertices,
        result.faces,
        result.colours,
        result.quality,
        info,
        meshes,
        f"{summary} {remark}".rstrip(),
    )


def _grow(target: _core.Target, options: Options, progress: Progress | None) -> Any:
    start = None
    if options.start is not None:
        places = as_points(options.start[0], "vertices of start_mesh")
        start = (places, as_faces(options.start[1], "faces of start_mesh", len(places)))
    try:
        return _core.reconstruct(
            target,
            options.core,
            start,
            options.names,
            part(progress, SHARE_OF_OPENING, 1),
            options.deadline,
        )
    except MemoryError:
        name = options.name("vertices")
        raise MemoryError(f"Too little memory for this input and {name}.") from None


def _of_path(path: Path, options: Options, progress: Progress | None) -> Any:
    """A target of a file that is read in place, or the points of another, at most so many."""
    if files.is_read_in_place(path) and not options.density_from_quality:
        return _core.file_target(os.fspath(path), options.names, progress, options.deadline)
    most = files.most_points_for(options.core.vertices)
    return files.read(
        path, most_points=most, progress=progress, is_time_up=lambda: options.deadline.has_passed
    )


def _open(
    source: Any,
    colours: ArrayLike | None,
    quality: ArrayLike | None,
    options: Options,
    progress: Progress | None,
) -> Input:
    if isinstance(source, _core.Target):
        return Input(source)
    if isinstance(source, ImplicitSurface | ParametricSurface):
        return Input(_function_target(source, options, progress))
    if isinstance(source, Sampler):
        return Input(_sampler_target(source))
    if isinstance(source, Surface):
        return _open_surface(source, colours, quality, options, progress)
    if hasattr(source, "vertices") and hasattr(source, "faces"):
        raise TypeError(
            "points must be an array: give mesh.vertices, or Surface(mesh.vertices, mesh.faces) "
            "to sample the surface of a mesh."
        )
    return _open_points(source, colours, quality, options, progress)


def _open_points(
    source: Any, colours: Any, quality: Any, options: Options, progress: Progress | None
) -> Input:
    points = as_points(source, "points")
    if "vertices" not in options.names and len(points) > 8:
        options.core.vertices = min(DEFAULT_VERTICES, len(points) // 2)
    rgba = None if colours is None else as_colours(colours, len(points))
    qualities = None if quality is None else as_quality(quality, len(points))
    density = _density(qualities, options)
    target = _core.points_target(points, density, options.names, progress)
    return Input(target, points, None, rgba, qualities)


def _open_surface(
    source: Surface, colours: Any, quality: Any, options: Options, progress: Progress | None
) -> Input:
    vertices = as_points(source.vertices, "vertices")
    faces = as_faces(source.faces, "faces", len(vertices))
    rgba = None if colours is None else as_colours(colours, len(vertices))
    qualities = None if quality is None else as_quality(quality, len(vertices))
    density = _density(qualities, options)
    target = _core.surface_target(vertices, faces, density, options.names, progress)
    return Input(target, vertices, faces, rgba, qualities)


def _density(quality: NDArray[np.float64] | None, options: Options) -> NDArray[np.float64] | None:
    if not options.density_from_quality:
        return None
    if quality is None:
        raise InvalidInput(f"{options.name('density_from_quality')}: give a quality too.")
    return quality


def _function_target(
    source: ImplicitSurface | ParametricSurface, options: Options, progress: Progress | None
) -> _core.Target:
    if isinstance(source, ImplicitSurface):
        if callable(source.function):
            return _sampler_target(ImplicitSampler(source.function, source.lower, source.upper))
        return _core.implicit_target(
            source.function, tuple(source.lower), tuple(source.upper), options.names, progress
        )
    if callable(source.coordinates):
        return _sampler_target(ParametricSampler(source.coordinates, source.u, source.v))
    return _core.parametric_target(
        tuple(source.coordinates), tuple(source.u), tuple(source.v), options.names, progress
    )


def _sampler_target(sampler: Any) -> _core.Target:
    """A target space that Python draws from."""

    def draw(seed: int, count: int) -> NDArray[np.float64]:
        samples = sampler.draw(np.random.default_rng(seed), count)
        samples = np.ascontiguousarray(samples, dtype=np.float64)
        if samples.shape != (count, 3):
            raise InvalidInput(f"draw() must return ({count}, 3) numbers, not {samples.shape}.")
        if not np.isfinite(samples).all():
            raise InvalidInput("draw() returned coordinates that are NaN or infinite.")
        return samples

    pilot = getattr(sampler, "pilot", None)
    if pilot is None:
        pilot = draw(0, 1000)
    spread = np.linalg.svd(pilot - pilot.mean(axis=0), compute_uv=False)
    if not spread[1] > FLATNESS * spread[0]:
        raise InvalidInput("All points lie on a line.")
    lower, upper = (tuple(map(float, corner)) for corner in (sampler.lower, sampler.upper))
    return _core.callback_target(draw, lower, upper, bool(spread[2] <= FLATNESS * spread[0]))


def _with_attributes(arrays: tuple[Any, Any], opened: Input, options: Options) -> Mesh:
    """The mesh with the means of the input's colours and quality, as far as it has any."""
    vertices, faces = arrays
    has_any = opened.colours is not None or opened.quality is not None
    if not options.transfer_attributes or not has_any or opened.points is None:
        return Mesh(vertices, faces)
    values = attribute_values(len(opened.points), opened.colours, opened.quality)
    points = opened.points
    if opened.faces is None:  # more points than this for a vertex add nothing that can be seen
        stride = len(points) // (_core.POINTS_PER_VERTEX * len(vertices)) + 1
        points, values = points[::stride], np.ascontiguousarray(values[::stride])
    mean = _core.transfer_attributes(
        points, opened.faces, values, vertices, faces.astype(np.int64), options.deadline
    )
    return Mesh(
        vertices,
        faces,
        None if opened.colours is None else np.clip(mean[:, :4] + 0.5, 0, 255).astype(np.uint8),
        None if opened.quality is None else np.ascontiguousarray(mean[:, 4]),
    )
