# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the type stub of pymeshlab_neuralmesh from the built plugin; CMake calls it.

Usage: make_stub.py PLUGIN STUB
"""

from __future__ import annotations

import sys
import textwrap
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

import pymeshlab

HEAD = '''"""Neural Mesh Reconstruction for PyMeshLab: the filters as methods of MeshSet."""

from collections.abc import Sequence
from os import PathLike

import pymeshlab

FILTERS: tuple[str, ...]
__version__: str

class MeshSet(pymeshlab.MeshSet):
'''
# What the methods take besides the type of the default.
WIDER = {"snapshots": "str | Sequence[int]", "pointfile": "str | PathLike[str]"}
PERCENTAGE = "float | str | pymeshlab.PercentageValue | pymeshlab.PureValue"


def main() -> int:
    """Write the stub."""
    plugin, stub = map(Path, sys.argv[1:])
    pymeshlab.load_plugin(str(plugin))
    module = documentation_module()
    methods = [method_stub(filter_) for filter_ in module.documentation(plugin)]
    stub.write_text(HEAD + "\n".join(methods), encoding="utf-8")
    return 0


def documentation_module() -> ModuleType:
    """Import _documentation.py alone: the package around it would look for its plugin."""
    path = Path(__file__).resolve().parent / "pymeshlab_neuralmesh" / "_documentation.py"
    spec = spec_from_file_location("documentation", path)
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    sys.modules["documentation"] = module
    spec.loader.exec_module(module)
    return module


def method_stub(filter_: object) -> str:
    """Return the lines of one method."""
    parameters = filter_.signature().parameters.values()
    types = WIDER | {p.name: PERCENTAGE for p in filter_.parameters if p.percentage}
    listed = [
        f"{p.name}: {types.get(p.name, p.annotation.__name__)} = {p.default!r},"
        for p in parameters
        if p.name != "self"
    ]
    signature = "\n".join(
        [f"def {filter_.name}(", "    self,", "    *,", *(f"    {p}" for p in listed)]
    )
    text = filter_.docstring().replace("\\", "\\\\")
    method = f'{signature}\n) -> dict[str, object]:\n    """{text}"""\n'
    return textwrap.indent(method, "    ")


if __name__ == "__main__":
    sys.exit(main())
