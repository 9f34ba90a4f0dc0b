# SPDX-License-Identifier: GPL-3.0-or-later
"""Private: the C++ core (filter_neuralmesh/hosts/python/)."""

from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from typing import Any

import numpy as np
from numpy.typing import NDArray

__version__: str
POINTS_PER_VERTEX: int

Names = Mapping[str, str]
Progress = Callable[[float, str], object]
Corner = Sequence[float]
Arrays = tuple[NDArray[np.float64], NDArray[np.int32]]

class InvalidInput(ValueError): ...
class Cancelled(RuntimeError): ...

class SplitRule(Enum):
    balanced = ...
    paper = ...

class StartMesh(Enum):
    tetrahedron = ...
    octahedron = ...
    icosahedron = ...
    given = ...
    from_data = ...

class Boundaries(Enum):
    closed = ...
    open = ...

class Topology(Enum):
    of_start = ...
    learned = ...

class Parameters:
    vertices: int
    winner_rate: float
    smoothing_rate: float
    smoothing_passes: int
    signals_per_split: int
    inactivity_factor: int
    threads: int
    counter_decay: float
    split_rule: SplitRule
    edge_flips: bool
    surface_fit: bool
    topology: Topology
    start_mesh: StartMesh
    boundaries: Boundaries
    max_hole_size: float
    snapshots: list[int]
    random_seed: int
    def __init__(self) -> None: ...
    def check(self, names: Names) -> None: ...

class Deadline:
    def __init__(self) -> None: ...
    @property
    def has_passed(self) -> bool: ...

class Target:
    @property
    def diagonal(self) -> float: ...
    @property
    def outlier_remark(self) -> str: ...

def points_target(
    points: NDArray[Any],
    density: NDArray[np.float64] | None,
    names: Names,
    progress: Progress | None,
) -> Target: ...
def file_target(
    path: str, names: Names, progress: Progress | None, deadline: Deadline
) -> Target: ...
def surface_target(
    vertices: NDArray[Any],
    faces: NDArray[np.int64],
    density: NDArray[np.float64] | None,
    names: Names,
    progress: Progress | None,
) -> Target: ...
def implicit_target(
    expression: str, lower: Corner, upper: Corner, names: Names, progress: Progress | None
) -> Target: ...
def parametric_target(
    coordinates: Sequence[str], u: Corner, v: Corner, names: Names, progress: Progress | None
) -> Target: ...
def callback_target(
    draw: Callable[[int, int], NDArray[np.float64]], lower: Corner, upper: Corner, is_flat: bool
) -> Target: ...
def deadline_in(seconds: float, names: Names) -> Deadline: ...
def reconstruct(
    target: Target,
    parameters: Parameters,
    start: tuple[NDArray[Any], NDArray[np.int64]] | None,
    names: Names,
    progress: Progress | None,
    deadline: Deadline,
) -> tuple[Arrays, dict[str, Any], list[Arrays], str]: ...
def transfer_attributes(
    points: NDArray[Any],
    faces: NDArray[np.int64] | None,
    values: NDArray[np.float64],
    mesh_vertices: NDArray[np.float64],
    mesh_faces: NDArray[np.int64],
    deadline: Deadline,
) -> NDArray[np.float64]: ...
def lzf_decompressed(packed: bytes, size: int) -> bytes: ...
def join_abandoned() -> None: ...
