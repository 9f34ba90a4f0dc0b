# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the project's parts are on this machine, and what its filters are called in Python.

Needs the standard library only and imports no PyMeshLab, so that every process can afford it.
"""

from __future__ import annotations

import importlib.util
import os
from pathlib import Path

from neuralmesh_tools.operating_system import PLUGIN_NAME

ROOT = Path(__file__).resolve().parent.parent.parent
SCRIPTS = ROOT / "scripts"

# Of the desktop, in single precision, and of PyMeshLab, in double precision.
DESKTOP_PLUGIN = ROOT / "build" / "meshlab" / PLUGIN_NAME
BUILT_PLUGIN = ROOT / "build" / "pymeshlab" / PLUGIN_NAME
# $NEURALMESH_PLUGIN names one that was built elsewhere, as for another version of PyMeshLab.
PLUGIN = Path(os.environ.get("NEURALMESH_PLUGIN") or BUILT_PLUGIN)

RECONSTRUCT = "generate_surface_reconstruction_neural_mesh"
FROM_IMPLICIT = "create_neural_mesh_from_implicit_surface"


class PluginMissing(RuntimeError):
    """The plugin has not been built; the message is a sentence for the user."""


def require_plugin(path: Path) -> Path:
    """Return the absolute path of a plugin; raises PluginMissing if there is no such file."""
    if not path.is_file():
        raise PluginMissing(f"The plugin {path} is not there: run scripts/build.")
    return path.resolve()


def cache_root() -> Path:
    """The project's cache folder, outside the checkout (not created here)."""
    base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(base) / "neural-mesh-reconstruction"


def sample_meshes() -> Path:
    """The folder of bunny.obj and the other meshes that the pymeshlab wheel brings.

    Raises ModuleNotFoundError if pymeshlab is not installed.
    """
    spec = importlib.util.find_spec("pymeshlab")
    if spec is None or spec.origin is None:
        raise ModuleNotFoundError("PyMeshLab is not installed; its wheel holds the sample meshes.")
    return Path(spec.origin).resolve().parent / "tests" / "sample_meshes"
