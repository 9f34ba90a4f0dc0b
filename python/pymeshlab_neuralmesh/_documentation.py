# SPDX-License-Identifier: GPL-3.0-or-later
"""Signatures and docstrings of the filters, from what the plugin says in MeshLab's dialogs."""

from __future__ import annotations

import ctypes
import html
import inspect
import json
import re
import textwrap
from dataclasses import dataclass
from pathlib import Path

from pymeshlab import MeshSet

RETURNS = """Returns
-------
A dictionary with the figures of the result, which is the new current layer: `vertices`, `faces`,
`genus`, `components`, `boundary_loops`, `self_intersections`, `splits`, `collapses`, `seed` (int),
`signals`, `seconds`, `rms_error`, `max_error` (float; errors in units of the input),
`coverage`, `unsupported_area` (float; shares),
`reached_target` (bool), `valence_histogram`, `convergence` (arrays).

Raises
------
PyMeshLabException on bad input, with a sentence that says what is wrong; the document stays as it
was."""


@dataclass(frozen=True)
class ParameterDocumentation:
    """One parameter as the dialog explains it."""

    name: str
    title: str
    help: str
    advanced: bool
    percentage: bool = False
    choices: tuple[str, ...] = ()

    def text(self) -> str:
        """Return the paragraph for the docstring."""
        numbered = [f"{number} {choice}" for number, choice in enumerate(self.choices)]
        choices = f" One of: {', '.join(numbered)}." if numbered else ""
        body = f"{self.title}{' (advanced)' if self.advanced else ''}: {self.help}{choices}"
        return f"{self.name}\n{textwrap.indent(textwrap.fill(body, 88), '    ')}"


@dataclass(frozen=True)
class FilterDocumentation:
    """One filter as the dialog explains it."""

    name: str
    info: str
    parameters: tuple[ParameterDocumentation, ...]

    def defaults(self) -> dict[str, object]:
        """Return the defaults by name, in the dialog's order, as PyMeshLab has them for a cube."""
        document = MeshSet(verbose=False)
        document.create_cube()
        values = document.filter_parameter_values(self.name)
        return {parameter.name: rounded(values[parameter.name]) for parameter in self.parameters}

    def signature(self) -> inspect.Signature:
        """Return the signature of the method; all parameters are to be given by name."""
        parameters = [inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)]
        for name, default in self.defaults().items():
            parameters.append(
                inspect.Parameter(
                    name,
                    inspect.Parameter.KEYWORD_ONLY,
                    default=default,
                    annotation=type(default),
                )
            )
        return inspect.Signature(parameters, return_annotation=dict[str, object])

    def docstring(self) -> str:
        """Return what `help` shows."""
        paragraphs = plain(self.info).split("\n")
        about = "\n".join(textwrap.fill(paragraph, 92) for paragraph in paragraphs)
        parameters = "\n".join(parameter.text() for parameter in self.parameters)
        return f"{about}\n\nParameters\n----------\n{parameters}\n\n{RETURNS}\n"


def documentation(plugin: Path) -> list[FilterDocumentation]:
    """Read the documentation out of the plugin; PyMeshLab's libraries have to be loaded."""
    library = ctypes.CDLL(str(plugin))
    library.neuralmesh_documentation.restype = ctypes.c_char_p
    return [
        FilterDocumentation(
            entry["name"],
            entry["info"],
            tuple(
                ParameterDocumentation(
                    **{**parameter, "choices": tuple(parameter.get("choices", ()))}
                )
                for parameter in entry["parameters"]
            ),
        )
        for entry in json.loads(library.neuralmesh_documentation())
    ]


def rounded(value: object) -> object:
    """Return a float as it was written: MeshLab keeps some in single precision."""
    return float(f"{value:.6g}") if isinstance(value, float) else value


def plain(text: str) -> str:
    """Return simple HTML as plain text."""
    return html.unescape(re.sub(r"<[^>]*>", "", re.sub(r"<br ?/?>", "\n", text)))
