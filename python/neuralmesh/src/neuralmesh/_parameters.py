# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters: the filter's, in snake case or as PyMeshLab spells them."""

from __future__ import annotations

import difflib
import secrets
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _core
from ._core import InvalidInput

# What the numbers of choices stand for, as in the filter's dialog, and what they may be called.
CHOICES: dict[str, dict[str, Any]] = {
    "topology": {"start": _core.Topology.of_start, "learned": _core.Topology.learned},
    "boundaries": {"closed": _core.Boundaries.closed, "open": _core.Boundaries.open},
    "split_rule": {"balanced": _core.SplitRule.balanced, "paper": _core.SplitRule.paper},
    "start_mesh": {
        "tetrahedron": _core.StartMesh.tetrahedron,
        "octahedron": _core.StartMesh.octahedron,
        "icosahedron": _core.StartMesh.icosahedron,
        "given": _core.StartMesh.given,
        "data": _core.StartMesh.from_data,
    },
}
COUNTS = (
    "vertices",
    "threads",
    "smoothing_passes",
    "signals_per_split",
    "inactivity_factor",
    "random_seed",
)
NUMBERS = ("winner_rate", "smoothing_rate", "counter_decay")
SWITCHES = ("surface_fit", "edge_flips", "transfer_attributes", "density_from_quality")
NAMES = (
    "vertices",
    *CHOICES,
    "max_hole_size",
    "snapshots",
    *COUNTS[1:],
    *NUMBERS,
    *SWITCHES,
    "time_limit",
)

# The filter's parameters that are said otherwise here.
ELSEWHERE = {
    "source": "what is to be sampled is the first argument",
    "pointfile": "give the path as the first argument",
    "startlayer": "give start_mesh=(vertices, faces)",
    "expr": "give ImplicitSurface(expr) as the first argument",
}

MOST = 2**31 - 1
SHARE_OF_HOLES = _core.Parameters().max_hole_size


def single(number: float) -> float:
    """Round to single precision: MeshLab and PyMeshLab hand numbers to the filter that way.

    The mesh would differ from the filter's in the last digits of these parameters otherwise.
    """
    return float(np.float32(number))


def _defaults() -> _core.Parameters:
    parameters = _core.Parameters()
    for key in NUMBERS:
        setattr(parameters, key, single(getattr(parameters, key)))
    return parameters


@dataclass
class Options:
    """Parameters as the core takes them, and what this package sees to itself."""

    core: _core.Parameters = field(default_factory=_defaults)
    start: tuple[Any, Any] | None = None
    """Vertices and faces of the mesh to start from."""
    max_hole_share: float | None = SHARE_OF_HOLES
    """Of the diagonal of the input; None where `core.max_hole_size` is a length."""
    transfer_attributes: bool = True
    density_from_quality: bool = False
    deadline: _core.Deadline = field(default_factory=_core.Deadline)
    """When the run ends with the mesh so far."""
    names: dict[str, str] = field(default_factory=dict)
    """What the caller typed for a parameter."""

    def name(self, key: str) -> str:
        """Return what the caller calls a parameter."""
        return self.names.get(key, key)


def read_options(given: Mapping[str, Any], names: Mapping[str, str] | None = None) -> Options:
    """Return the options of keyword arguments, checked.

    A time limit starts to count. `names` says what the caller typed where that was no keyword, such
    as "--max-hole-size".
    Raises TypeError for unknown names and wrong types, InvalidInput for values out of range.
    """
    options = Options()
    for typed, value in given.items():
        key = key_of(typed)
        if key in options.names:
            raise TypeError(f"{options.names[key]} and {typed} are the same parameter.")
        options.names[key] = (names or {}).get(key, typed)
        _set(options, key, value)
    options.core.check(options.names)
    return options


def key_of(typed: str) -> str:
    """Return the name in snake case; raises TypeError with the nearest where there is none."""
    plain = _plain(typed)
    if plain in ("targetvertnum", "vertices"):
        return "vertices"
    keys = {_plain(name): name for name in NAMES}
    if plain in keys:
        return keys[plain]
    if plain in ELSEWHERE:
        raise TypeError(f"There is no parameter '{typed}' here: {ELSEWHERE[plain]}.")
    near = difflib.get_close_matches(plain, [*keys, "targetvertnum"], n=1, cutoff=0.5)
    if not near:
        raise TypeError(f"There is no parameter '{typed}'. There are {', '.join(NAMES)}.")
    snake = keys.get(near[0], "target_vert_num")
    is_pymeshlabs = "_" not in typed and len(plain) >= 0.7 * len(near[0])
    suggestion = near[0] if is_pymeshlabs else snake
    raise TypeError(f"There is no parameter '{typed}'. Did you mean '{suggestion}'?")


def _plain(name: str) -> str:
    return name.replace("_", "").lower()


def _set(options: Options, key: str, value: Any) -> None:
    name = options.name(key)
    if key in CHOICES:
        _set_choice(options, key, value)
    elif key == "max_hole_size":
        _set_hole_size(options, value)
    elif key == "snapshots":
        options.core.snapshots = _counts(name, value)
    elif key == "time_limit":
        options.deadline = _core.deadline_in(_real_number(name, value), options.names)
    elif key == "random_seed":
        options.core.random_seed = _seed(name, value)
    elif key in COUNTS:
        setattr(options.core, key, whole_number(name, value))
    elif key in NUMBERS:
        setattr(options.core, key, single(_real_number(name, value)))
    elif not isinstance(value, bool | np.bool_) and value not in (0, 1):
        raise TypeError(f"{name} must be True or False, not {value!r}.")
    else:
        setattr(options.core if hasattr(options.core, key) else options, key, bool(value))


def _set_choice(options: Options, key: str, value: Any) -> None:
    choices, name = CHOICES[key], options.name(key)
    if key == "start_mesh" and not isinstance(value, str | int | float | np.number):
        options.start = _start_of(name, value)
        options.core.start_mesh = _core.StartMesh.given
        return
    labels = list(choices)
    if isinstance(value, str) and value.lower() in choices:
        label = value.lower()
    elif isinstance(value, int | np.integer) and 0 <= value < len(labels):
        label = labels[int(value)]
    else:
        listed = ", ".join(f"{number} '{label}'" for number, label in enumerate(labels))
        raise InvalidInput(f"{name} must be one of {listed}, not {value!r}.")
    if label == "given":
        raise InvalidInput(f"Give the mesh itself: {name}=(vertices, faces).")
    setattr(options.core, key, choices[label])


def _start_of(name: str, value: Any) -> tuple[Any, Any]:
    """A pair of arrays, or any object that has vertices and faces."""
    if hasattr(value, "vertices") and hasattr(value, "faces"):
        return value.vertices, value.faces
    if isinstance(value, tuple | list) and len(value) == 2:
        return value[0], value[1]
    raise TypeError(f"{name} must be a name, a number or (vertices, faces).")


def _set_hole_size(options: Options, value: Any) -> None:
    """A length in units of the input, or "5 %" of its diagonal."""
    name = options.name("max_hole_size")
    if isinstance(value, str):
        text = value.strip()
        try:
            options.max_hole_share = float(text.removesuffix("%")) / 100
        except ValueError:
            text = ""
        if not text.endswith("%"):
            raise InvalidInput(f"{name} must be a length or a percentage, not {value!r}.")
        options.core.max_hole_size = options.max_hole_share or 0.0
    else:
        options.core.max_hole_size = _real_number(name, value)
        options.max_hole_share = None


def whole_number(name: str, value: Any) -> int:
    """Return an int; a float or a text that is one passes. Raises TypeError or InvalidInput."""
    number = _converted(name, value, int)
    if number != value and not isinstance(value, str):
        raise TypeError(f"{name} must be a whole number, not {value!r}.")
    if abs(number) > MOST:
        raise InvalidInput(f"{name} is {number}, but {MOST} is the most that is possible.")
    return int(number)


def _real_number(name: str, value: Any) -> float:
    return float(_converted(name, value, float))


def _converted(name: str, value: Any, kind: Callable[[Any], Any]) -> Any:
    what = "a whole number" if kind is int else "a number"
    if isinstance(value, bool):
        raise TypeError(f"{name} must be {what}, not {value!r}.")
    try:
        return kind(value)
    except (TypeError, ValueError, OverflowError):
        raise TypeError(f"{name} must be {what}, not {value!r}.") from None


def _counts(name: str, value: Any) -> list[int]:
    """Numbers, or "20,100,1000" as for the filter, in any order."""
    if isinstance(value, str):
        entries: list[Any] = [entry.strip() for entry in value.split(",")] if value.strip() else []
    else:
        entries = list(np.atleast_1d(value))
    try:
        return sorted(whole_number(name, entry) for entry in entries)
    except TypeError:
        raise InvalidInput(
            f"{name} must be vertex counts separated by commas, such as 20,100,1000, or a list "
            f"of them, not {value!r}."
        ) from None


def _seed(name: str, value: Any) -> int:
    seed = whole_number(name, value)
    if seed < 0:
        raise InvalidInput(f"{name} must be 0 (a fresh seed) or positive, not {seed}.")
    return seed or secrets.randbelow(MOST) + 1
