# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done to every scan of a batch, and the fingerprint by which a rerun knows it again."""

from __future__ import annotations

import hashlib
import json
import math
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import Any

Value = bool | int | float | str

# Each input is the one layer of a document; with these the filter would look elsewhere.
_ONE_FILE = "every scan would become the mesh of one file. Give files as inputs."
_ONE_LAYER = "the document of a scan has no other layer."
REFUSED = {
    "pointfile": _ONE_FILE,
    "source=3": _ONE_FILE,
    "startlayer": _ONE_LAYER,
    "startmesh=3": _ONE_LAYER,
}


# Named, not imported: PyMeshLab is not for a worker's own process.
IN_PYMESHLAB = "neuralmesh_tools.batching.reconstruct:reconstruct"


class RecipeError(ValueError):
    """The recipe cannot be followed; the message is a sentence for the user."""


@dataclass(frozen=True)
class Recipe:
    """A filter with parameters, or a whole MeshLab filter script; then the output's format.

    plugins: paths of plugins to load. script: the text of a .mlx file; if there is one, filter and
    parameters are not used. suffix: the output's, with its dot. threads: what one item may use;
    it does not change a result. versions: those of the programs that the outputs depend on, or
    their SHA-256. by: the function that follows the recipe, called with it, a source and a target;
    it returns results, or raises ValueError with a sentence.
    """

    plugins: tuple[Path, ...]
    filter: str
    parameters: dict[str, Value]
    script: str
    suffix: str
    threads: int = 1
    versions: dict[str, str] = field(default_factory=dict)
    by: str = IN_PYMESHLAB

    def fingerprint(self, input_sha256: str) -> str:
        """A hash of everything that the output of an input depends on."""
        parts = {
            "input": input_sha256,
            "filter": "" if self.script else self.filter,
            "parameters": {} if self.script else self.parameters,
            "script": self.script,
            "suffix": self.suffix,
            "versions": self.versions,
        }
        return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def parse_settings(pairs: list[str], defaults: dict[str, Any]) -> dict[str, Value]:
    """Turn NAME=VALUE texts into parameters of the type that each one's default has.

    Raises RecipeError, with the names there are, on an unknown parameter; on text of another type.
    """
    parameters: dict[str, Value] = {}
    for pair in pairs:
        name, equals, text = pair.partition("=")
        name = name.strip().lower()
        if not equals:
            raise RecipeError(f"--set wants NAME=VALUE, not {pair}.")
        refuse_own_input(name, text.strip())
        if name not in defaults:
            known = ", ".join(sorted(defaults))
            near = get_close_matches(name, defaults, 1)
            meant = f" Is it {near[0]}?" if near else ""
            raise RecipeError(f"The filter has no parameter {name}.{meant} It has: {known}.")
        parameters[name] = parse_value(name, text.strip(), defaults[name])
    return parameters


def parse_value(name: str, text: str, default: Any) -> Value:
    """Read a value of the same type as the default; a float may be a percentage such as 5%."""
    try:
        if isinstance(default, bool):
            return {"true": True, "1": True, "false": False, "0": False}[text.lower()]
        if isinstance(default, int):
            return int(text)
        if isinstance(default, float):
            return _percentage(text) if text.endswith("%") else _finite(text)
        if isinstance(default, str):
            return text
    except (KeyError, ValueError):
        kinds = {bool: "true or false", int: "a whole number", float: "a number"}
        kind = kinds[type(default)]
        raise RecipeError(f"{name} is {kind} ({default} by default), not {text!r}.") from None
    raise RecipeError(f"{name} cannot be set from the command line: use a filter script (--mlx).")


def refuse_own_input(name: str, text: str) -> None:
    """Raise RecipeError on a setting by which the filter would not work on the item's own input."""
    if reason := REFUSED.get(name) or REFUSED.get(f"{name}={text}"):
        raise RecipeError(f"--set {name}={text} does not go with a batch: {reason}")


def _percentage(text: str) -> str:
    _finite(text[:-1])
    return text


def _finite(text: str) -> float:
    number = float(text)
    if not math.isfinite(number):
        raise ValueError
    return number
