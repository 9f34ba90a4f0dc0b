# SPDX-License-Identifier: GPL-3.0-or-later
"""The installed package pymeshlab_neuralmesh: ends with 0 only if it is whole and works."""

import inspect
import sys
from importlib.metadata import version
from pathlib import Path

import pymeshlab
import pymeshlab_neuralmesh as nm

ms = nm.MeshSet()
ms.load_new_mesh(str(Path(pymeshlab.__file__).parent / "tests/sample_meshes/bunny.obj"))
result = ms.generate_surface_reconstruction_neural_mesh(targetvertnum=500)
method = nm.MeshSet.generate_surface_reconstruction_neural_mesh
assert "targetvertnum" in inspect.signature(method).parameters
assert "Exact number of vertices" in " ".join(method.__doc__.split())
stub = Path(nm.__file__).with_suffix(".pyi").read_text()
assert nm.__version__ == version("pymeshlab-neuralmesh")
assert "__version__: str" in stub
assert all(f"def {name}(" in stub for name in nm.FILTERS)
sys.exit(result["vertices"] != 500)
