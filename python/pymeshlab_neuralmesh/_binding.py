# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the plugin into PyMeshLab and makes its filters methods of MeshSet.

PyMeshLab binds methods of its own filters only, when it is imported itself, and without
signatures. Names, texts and choices come from the plugin, defaults and types from PyMeshLab.
"""

from __future__ import annotations

import importlib.metadata
import sys
from pathlib import Path

NAME = "filter_neuralmesh.dll" if sys.platform == "win32" else "libfilter_neuralmesh.so"
PLUGIN = Path(__file__).resolve().parent / NAME
PACKAGE = "pymeshlab-neuralmesh"


def require_version() -> None:
    """Raise ImportError unless PyMeshLab is the version that the plugin was built for."""
    try:
        pins = importlib.metadata.requires(PACKAGE) or []
    except importlib.metadata.PackageNotFoundError:
        return  # while the package itself is being built, against the version that it pins
    wanted = next(pin for pin in pins if pin.startswith("pymeshlab==")).removeprefix("pymeshlab==")
    found = importlib.metadata.version("pymeshlab")
    if found != wanted:
        raise ImportError(
            f"{PACKAGE} was built for pymeshlab {wanted}, and pymeshlab {found} is installed: "
            f"run `pip install pymeshlab=={wanted}`, or build {PACKAGE} for {found}."
        )


def installed_version() -> str:
    """Return the version of the package; "unknown" where its sources are imported as they are."""
    try:
        return importlib.metadata.version(PACKAGE)
    except importlib.metadata.PackageNotFoundError:
        return "unknown"


require_version()

# PyMeshLab comes second: a wrong version is to be named, not to fail in some way of its own.
from pymeshlab import MeshSet, filter_list, load_plugin  # noqa: E402

from ._arguments import arguments_of  # noqa: E402
from ._documentation import FilterDocumentation, documentation  # noqa: E402

DOCUMENTATION = documentation(PLUGIN)
FILTERS = tuple(filter_.name for filter_ in DOCUMENTATION)

# The plugin may be among PyMeshLab's own already, by `cmake --install`.
if not set(FILTERS) <= set(filter_list()):
    load_plugin(str(PLUGIN))

# A filter that raises leaves a fault in PyMeshLab: loading a mesh after the failed document was
# freed may crash. Failed documents stay until Python ends.
FAILED: dict[int, MeshSet] = {}

_described = {filter_.name: (filter_.parameters, filter_.defaults()) for filter_ in DOCUMENTATION}
_apply_filter = MeshSet.apply_filter


def apply_filter(self: MeshSet, filter_name: str, **given: object) -> dict[str, object]:
    """Apply a filter by its name. Arguments of our filters may be written as for their methods."""
    if filter_name in _described:
        given = arguments_of(filter_name, given, *_described[filter_name])
    try:
        return _apply_filter(self, filter_name, **given)
    except Exception:
        FAILED[id(self)] = self
        raise


def bind(filter_: FilterDocumentation) -> None:
    """Make a filter a method of MeshSet."""
    name = filter_.name

    def method(self: MeshSet, **given: object) -> dict[str, object]:
        return self.apply_filter(name, **given)

    method.__name__ = name
    method.__qualname__ = f"MeshSet.{name}"
    method.__doc__ = filter_.docstring()
    method.__signature__ = filter_.signature()  # type: ignore[attr-defined]
    setattr(MeshSet, name, method)


MeshSet.apply_filter = apply_filter
for described in DOCUMENTATION:
    bind(described)
