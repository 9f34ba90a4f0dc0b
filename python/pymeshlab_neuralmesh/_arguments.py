# SPDX-License-Identifier: GPL-3.0-or-later
"""What people pass for a parameter, as PyMeshLab takes it, which casts nothing itself."""

from __future__ import annotations

import difflib
import numbers
import os
from collections.abc import Iterable, Mapping

from pymeshlab import PercentageValue, PureValue

from ._documentation import ParameterDocumentation

# Source 3 is a point file.
SOURCE_OF_POINT_FILE = 3


def arguments_of(
    filter_name: str,
    given: Mapping[str, object],
    parameters: Iterable[ParameterDocumentation],
    defaults: Mapping[str, object],
) -> dict[str, object]:
    """Return the arguments as PyMeshLab takes them: of the type of each parameter's default.

    Whole floats are counts, lists of counts are texts, paths are texts, plain numbers and texts
    such as "5%" are percentages. Names may be written as in the dialog. A point file implies
    `source=3`. Raises TypeError for a name that the filter does not have, with the one that was
    likely meant, and for a value that cannot be one of the parameter's.
    """
    known = {parameter.name: parameter for parameter in parameters}
    arguments: dict[str, object] = {}
    for given_name, value in given.items():
        name = given_name.lower()
        if name not in known:
            raise TypeError(unknown(filter_name, given_name, known))
        if name in arguments:
            raise TypeError(f"{filter_name}() got {name} twice.")
        arguments[name] = converted(known[name], value, defaults[name])
    if arguments.get("pointfile") and "source" not in arguments:
        arguments["source"] = SOURCE_OF_POINT_FILE
    return arguments


def unknown(filter_name: str, name: str, known: Iterable[str]) -> str:
    """Return the sentence about a name that is none of the known ones."""
    near = difflib.get_close_matches(name.lower().replace("_", ""), known, 1, 0.5)
    meant = f" Is it {near[0]}?" if near else f" It has: {', '.join(known)}."
    return f"{filter_name}() has no parameter {name}.{meant}"


def converted(parameter: ParameterDocumentation, value: object, default: object) -> object:
    """Return a value as PyMeshLab takes it for a parameter with this default."""
    name = parameter.name
    if parameter.choices and isinstance(value, str):
        if value not in parameter.choices:
            raise TypeError(f"{name} is one of {', '.join(parameter.choices)}, not {value!r}.")
        return value
    if parameter.percentage:
        return _percentage(name, value)
    if isinstance(default, bool):
        if value in (False, True):  # 0, 1 and numpy's among them
            return bool(value)
        raise TypeError(f"{name} is True or False, not {value!r}.")
    if isinstance(default, int):
        return _whole(name, value)
    if isinstance(default, float):
        if isinstance(value, numbers.Real):
            return float(value)
        raise TypeError(f"{name} is a number, not {value!r}.")
    return _text(name, value)


def _whole(name: str, value: object) -> int:
    if isinstance(value, numbers.Real) and not isinstance(value, bool) and value == value // 1:
        return int(value)
    raise TypeError(f"{name} is a whole number, not {value!r}.")


def _percentage(name: str, value: object) -> object:
    if isinstance(value, numbers.Real):
        return PureValue(float(value))
    if isinstance(value, str) and value.strip().endswith("%"):
        try:
            return PercentageValue(float(value.strip()[:-1]))
        except ValueError:
            pass
    elif isinstance(value, (PercentageValue, PureValue)):
        return value
    raise TypeError(f'{name} is a length, or a text such as "5%" of the diagonal, not {value!r}.')


def _text(name: str, value: object) -> str:
    if isinstance(value, (str, os.PathLike)):
        return os.fspath(value)
    if isinstance(value, numbers.Real):
        return str(_whole(name, value))
    if isinstance(value, Iterable):
        return ",".join(str(_whole(name, entry)) for entry in value)
    raise TypeError(f"{name} is a text, not {value!r}.")
