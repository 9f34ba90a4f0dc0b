# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays as the core takes them. What has the right type already is not copied here."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import InvalidInput

Points = NDArray[np.float32] | NDArray[np.float64]


def as_points(value: Any, name: str) -> Points:
    """Return n x 3 numbers as float32 or float64, of any strides.

    Other numbers become float64. Raises TypeError for what is no array of numbers, InvalidInput
    for another shape.
    """
    return _readable(_shaped(_numbers(value, name), name, 3))


def as_faces(value: Any, name: str, vertex_count: int) -> NDArray[np.int64]:
    """Return m x 3 vertex numbers; raises InvalidInput where one is not there."""
    faces = np.asarray(value)
    if faces.dtype.kind not in "iu":
        raise TypeError(f"{name} must be whole numbers, not {faces.dtype}.")
    faces = _readable(_shaped(faces, name, 3).astype(np.int64, copy=False))
    if faces.size and not (faces.min() >= 0 and faces.max() < vertex_count):
        raise InvalidInput(f"{name} name a vertex that is not there.")
    return faces


def as_quality(value: Any, count: int) -> NDArray[np.float64]:
    """Return one number for each point."""
    quality = _readable(_numbers(value, "quality").astype(np.float64, copy=False))
    if quality.shape != (count,):
        raise InvalidInput(
            f"quality must be one number for each point, of the shape ({count},), "
            f"not {quality.shape}."
        )
    return quality


def as_colours(value: Any, count: int) -> NDArray[np.uint8]:
    """Return red, green, blue and alpha of each point, from 0 to 255.

    Whole numbers are taken as they are, others as shares of 1; alpha is 255 where it is left out.
    """
    colours = _numbers(value, "colours")
    if colours.ndim != 2 or colours.shape[0] != count or colours.shape[1] not in (3, 4):
        raise InvalidInput(
            f"colours must have the shape ({count}, 3) or ({count}, 4), not {colours.shape}."
        )
    scaled = colours if colours.dtype.kind in "iu" else np.rint(255 * colours)
    rgba = np.full((count, 4), 255, np.uint8)
    rgba[:, : colours.shape[1]] = np.clip(scaled, 0, 255)
    return rgba


def attribute_values(
    count: int, colours: NDArray[np.uint8] | None, quality: NDArray[np.float64] | None
) -> NDArray[np.float64]:
    """Return n x 5: red, green, blue, alpha and quality, 0 where there are none."""
    values = np.zeros((count, 5))
    if colours is not None:
        values[:, :4] = colours
    if quality is not None:
        values[:, 4] = quality
    return values


def _numbers(value: Any, name: str) -> NDArray[Any]:
    array = np.asarray(value)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"{name} must be numbers, not {_described(value, array)}.")
    if array.dtype not in (np.float32, np.float64) and name != "colours":
        return array.astype(np.float64)
    return array


def _described(value: Any, array: NDArray[Any]) -> str:
    return type(value).__name__ if array.dtype == object else str(array.dtype)


def _shaped(array: NDArray[Any], name: str, columns: int) -> NDArray[Any]:
    if array.ndim != 2 or array.shape[1] != columns:
        raise InvalidInput(f"{name} must have the shape (N, {columns}), not {array.shape}.")
    return array


def _readable(array: NDArray[Any]) -> NDArray[Any]:
    """The core steps from item to item: a field of packed records may lie between them."""
    steps_whole = all(stride % array.itemsize == 0 for stride in array.strides)
    if array.dtype.isnative and array.flags.aligned and steps_whole:
        return array
    return array.astype(array.dtype.newbyteorder("="), order="C")
