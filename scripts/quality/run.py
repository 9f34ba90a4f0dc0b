"""Runs the rows of the table one after another; peers' rows come from a cache when they can.

A peer's row depends on nothing of ours, so it is kept under a key of everything it does depend
on: the input points and reference (hashed), the method, the vertex count, PyMeshLab's version and
the code of this harness (layout, comments, docstrings and imports do not count). Our rows
never are.
"""

from __future__ import annotations

import ast
import hashlib
import importlib.metadata
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import datasets
import numpy as np

from quality import inputs, methods, metrics

SCRIPTS = Path(__file__).resolve().parent.parent


@dataclass(frozen=True)
class Method:
    """A method and, for ours, the filter's parameters that differ from their defaults."""

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
        return self.name in methods.PEERS


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

    plugin: str
    timeout: float
    threads: int = 1
    fresh: bool = False
    keep: Path | None = None


def run_group(group: Group, wanted: list[Method], settings: Settings) -> Iterator[Row]:
    """Yield a row for each method wanted, then cached rows of the peers that were not.

    Raises datasets.Unavailable if the model cannot be had.
    """
    case = inputs.make_case(group.model, group.condition, group.seed)
    fingerprint = _fingerprint(case)
    asked = {method.name for method in wanted}
    others = [Method(name) for name in methods.PEERS if name not in asked]
    for method in [*wanted, *others]:
        kept = (
            _cache_path(fingerprint, method, group.vertices, settings.threads)
            if method.is_peer
            else None
        )
        if kept and kept.is_file() and not settings.fresh:
            values, cached = json.loads(kept.read_text(encoding="utf-8")), True
        elif method.name not in asked:
            continue
        else:
            values, cached = _run(case, method, group, settings), False
            if kept and not values.get("timed_out"):
                kept.parent.mkdir(parents=True, exist_ok=True)
                partial = kept.with_suffix(f".{os.getpid()}.part")
                partial.write_text(json.dumps(values), encoding="utf-8")
                partial.replace(kept)
        yield Row(group, method.label, values, cached)


def _run(case: inputs.Case, method: Method, group: Group, settings: Settings) -> dict[str, Any]:
    """Run one row in a process of its own and return its metrics, or {"failure": sentence}."""
    options = dict(method.options)
    if not method.is_peer:
        options.setdefault("randomseed", group.seed)
    job = {
        "method": method.name,
        "vertices": group.vertices,
        "threads": settings.threads,
        "plugin": settings.plugin,
        "options": options,
    }
    with tempfile.TemporaryDirectory() as folder:
        job_path, row_path = Path(folder) / "job.npz", Path(folder) / "row.json"
        np.savez(
            job_path,
            settings=np.array(json.dumps(job)),
            points=case.points,
            normals=case.normals,
            reference_points=case.reference_points,
            reference_faces=case.reference_faces,
        )
        command = [sys.executable, "-m", "quality.worker", str(job_path), str(row_path)]
        if settings.keep:
            settings.keep.mkdir(parents=True, exist_ok=True)
            name = f"{group.model}-{group.condition}-{group.seed}-{method.label}.ply"
            command.append(str(settings.keep.resolve() / name))
        started = time.strftime("%Y-%m-%d %H:%M")
        try:
            done = subprocess.run(
                command,
                cwd=SCRIPTS,
                check=False,
                timeout=settings.timeout,
                text=True,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
            )
        except subprocess.TimeoutExpired:
            failure = f"not done after {settings.timeout:g} s"
            return {"failure": failure, "timed_out": True, "measured": started}
        if not row_path.is_file():
            return {"failure": _last_words(done), "measured": started}
        values: dict[str, Any] = json.loads(row_path.read_text(encoding="utf-8"))
    return {**values, "measured": started}


def _last_words(done: subprocess.CompletedProcess[str]) -> str:
    if done.returncode < 0:
        return f"crashed with {signal.Signals(-done.returncode).name}"
    lines = done.stdout.strip().splitlines() or ["no message"]
    return f"ended with code {done.returncode}: {lines[-1]}"


def _fingerprint(case: inputs.Case) -> str:
    """A hash of everything a method and its metrics are given."""
    digest = hashlib.sha256()
    for array in (case.points, case.normals, case.reference_points, case.reference_faces):
        digest.update(np.ascontiguousarray(array).tobytes())
    return digest.hexdigest()


def _cache_path(fingerprint: str, method: Method, vertices: int, threads: int) -> Path:
    key = f"{fingerprint} {method.label} {vertices} {threads} {_harness_version()}"
    name = hashlib.sha256(key.encode()).hexdigest()[:32]
    return datasets.cache_root() / "quality" / f"{name}.json"


@cache
def _harness_version() -> str:
    digest = hashlib.sha256(importlib.metadata.version("pymeshlab").encode())
    for module in (methods, metrics, inputs):
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
