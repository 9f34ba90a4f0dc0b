# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the rows of the table one after another; peers' rows come from a cache when they can.

A peer's row depends on nothing of ours, so it is kept under a key of everything it does depend
on: the input points and reference (hashed), the method, the vertex count, PyMeshLab's version and
the code that runs and measures it (layout, comments, docstrings and imports do not count). Our rows
never are.
"""

from __future__ import annotations

import ast
import hashlib
import json
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from neuralmesh_tools import geometry, methods, metrics
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.machine import version_of
from neuralmesh_tools.methods import PEERS, TABLE_METHODS, Task
from neuralmesh_tools.project import cache_root
from neuralmesh_tools.quality import inputs, row
from neuralmesh_tools.quality.row import Job


@dataclass(frozen=True)
class Variant:
    """A method by its name in the table and, for ours, parameters that differ from the defaults."""

    name: str
    options: dict[str, Any] = field(default_factory=dict)

    @property
    def label(self) -> str:
        """What the table calls it."""
        settings = ",".join(f"{key}={value}" for key, value in self.options.items())
        return f"{self.name}[{settings}]" if settings else self.name

    @property
    def is_peer(self) -> bool:
        """Whether its rows can be cached."""
        return self.name in PEERS


@dataclass(frozen=True)
class Group:
    """What the rows of one group of the table share; vertices is the count asked for."""

    model: str
    condition: str
    seed: int
    vertices: int


@dataclass
class Row:
    """One method on one case. values holds the metrics, or a failure's sentence."""

    group: Group
    method: str
    values: dict[str, Any]
    from_cache: bool = False

    @property
    def failed(self) -> bool:
        """Whether the method gave no mesh."""
        return "failure" in self.values


@dataclass(frozen=True)
class Settings:
    """How rows are run: the plugin's path, seconds allowed, threads, caching, meshes kept."""

    plugin: Path
    timeout: float
    threads: int = 1
    fresh: bool = False
    keep: Path | None = None


def run_group(group: Group, wanted: list[Variant], settings: Settings) -> Iterator[Row]:
    """Yield a row for each variant wanted, then cached rows of the peers that were not.

    Raises datasets.Unavailable if the model cannot be had.
    """
    case = inputs.make_case(group.model, group.condition, group.seed)
    fingerprint = _fingerprint(case)
    asked = {variant.name for variant in wanted}
    others = [Variant(name) for name in PEERS if name not in asked]
    for variant in [*wanted, *others]:
        kept = (
            _cache_path(fingerprint, variant, group.vertices, settings.threads)
            if variant.is_peer
            else None
        )
        if kept and kept.is_file() and not settings.fresh:
            values, cached = json.loads(kept.read_text(encoding="utf-8")), True
        elif variant.name not in asked:
            continue
        else:
            values, cached = _run(case, variant, group, settings), False
            if kept and not values.get("timed_out"):
                write_in_one_step(kept, json.dumps(values))
        yield Row(group, variant.label, values, cached)


def _run(case: inputs.Case, variant: Variant, group: Group, settings: Settings) -> dict[str, Any]:
    """Run one row in a process of its own and return its metrics, or {"failure": sentence}."""
    plugin = mesh = None
    options = dict(variant.options)
    if not variant.is_peer:
        plugin = settings.plugin
        options.setdefault("randomseed", group.seed)
    if settings.keep:
        settings.keep.mkdir(parents=True, exist_ok=True)
        name = f"{group.model}-{group.condition}-{group.seed}-{variant.label}.ply"
        mesh = settings.keep.resolve() / name
    outliers = inputs.CONDITIONS[group.condition].outliers > 0
    task = Task(group.vertices, settings.threads, outliers=outliers, parameters=options)
    method = TABLE_METHODS[variant.name]
    job = Job(method, case, task, plugin, mesh)
    timeout = settings.timeout * max(1, len(method.settings))
    started = time.strftime("%Y-%m-%d %H:%M")
    with IsolatedProcess({"OMP_NUM_THREADS": str(settings.threads)}) as process:
        name = "neuralmesh_tools.quality.row:measure_row"
        outcome = process.call(name, job, timeout=timeout)
    if outcome.ok:
        return {**outcome.value, "measured": started}
    values = {"failure": outcome.failure, "measured": started}
    return values | {"timed_out": True} if outcome.kind == "timed out" else values


def _fingerprint(case: inputs.Case) -> str:
    """A hash of everything a method and its metrics are given."""
    digest = hashlib.sha256()
    for array in (case.points, case.normals, case.reference_points, case.reference_faces):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def _cache_path(fingerprint: str, variant: Variant, vertices: int, threads: int) -> Path:
    key = f"{fingerprint} {variant.label} {vertices} {threads} {_harness_version()}"
    name = hashlib.sha256(key.encode()).hexdigest()[:32]
    return cache_root() / "quality" / f"{name}.json"


@cache
def _harness_version() -> str:
    """A hash of PyMeshLab's version and of the code that a peer's row depends on."""
    digest = hashlib.sha256(version_of("pymeshlab").encode())
    for module in (geometry, methods, metrics, row):
        tree = ast.parse(Path(str(module.__file__)).read_text(encoding="utf-8"))
        tree.body = [
            node for node in tree.body if not isinstance(node, ast.Import | ast.ImportFrom)
        ]
        for node in ast.walk(tree):
            if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and (
                ast.get_docstring(node, clean=False) is not None
            ):
                del node.body[0]
        digest.update(ast.dump(tree).encode())
    return digest.hexdigest()
