# SPDX-License-Identifier: GPL-3.0-or-later
"""Comparisons kept in the output folder, so that the same command goes on where it was stopped.

DIR/.compare/FINGERPRINT.npz holds a cloud's comparison: arrays, and the rest as JSON. No pickles: a
folder may be somebody else's, and what is read from it must not run.
"""

from __future__ import annotations

import hashlib
import importlib
import io
import json
import zipfile
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from neuralmesh_tools.comparison.clouds import CloudFacts
from neuralmesh_tools.comparison.run import Comparison, Result, Settings
from neuralmesh_tools.files import sha256_of, write_in_one_step
from neuralmesh_tools.machine import version_of
from neuralmesh_tools.methods import METHODS, Reconstruction

STATE = ".compare"
# To be raised with every change of what is kept, or of how it is measured.
VERSION = 1
# A time-out is a result, the same whenever it is run; what crashed or wanted memory may go well.
LASTING = ("returned", "raised", "timed out")


def fingerprint(cloud: Path, settings: Settings) -> str:
    """A hash of everything that a cloud's comparison depends on; empty if it cannot be read."""
    try:
        parts = {
            "version": VERSION,
            "cloud": sha256_of(cloud),
            "methods": settings.methods,
            "numbers": [settings.vertices, settings.threshold, settings.timeout, settings.threads],
            "surface": [_hash_of(array) for array in settings.surface or ()],
            "plugin": hash_of_ours(settings.plugin),
            "pymeshlab": version_of("pymeshlab"),
        }
    except OSError:
        return ""
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def hash_of_ours(plugin: Path | None) -> str:
    """The SHA-256 of what runs our method: a plugin, or the package; empty if it is not there."""
    if plugin is None:
        plugin = Path(importlib.import_module("neuralmesh._core").__file__ or "")
    return sha256_of(plugin) if plugin.is_file() else ""


def keep(comparison: Comparison, out: Path, mark: str) -> None:
    """Keep a comparison, unless a later run may find another one. Raises OSError."""
    is_lasting = all(result.kind in LASTING for result in comparison.results)
    if not mark or comparison.cloud is None or not is_lasting:
        return
    arrays = {"shown": comparison.cloud.shown}
    facts = {**vars(comparison.cloud), "shown": None}
    results = []
    for number, result in enumerate(comparison.results):
        text = {**vars(result), "mesh": None, "face_error": None}
        if result.mesh is not None and result.face_error is not None:
            arrays[f"points{number}"] = result.mesh.points
            arrays[f"faces{number}"] = result.mesh.faces
            arrays[f"face_error{number}"] = result.face_error
            text["mesh"] = {**asdict(result.mesh), "points": None, "faces": None}
        results.append(text)
    told = json.dumps({"facts": facts, "vertices": comparison.vertices, "results": results})
    content = io.BytesIO()
    np.savez(content, told=np.array(told), **arrays)  # type: ignore[arg-type]
    write_in_one_step(out / STATE / f"{mark}.npz", content.getvalue())


def kept(name: str, path: str, out: Path, mark: str) -> Comparison | None:
    """Return the comparison that is kept under a fingerprint, None if none can be read."""
    file = out / STATE / f"{mark}.npz"
    try:
        if not mark or not file.is_file():
            return None
        with np.load(io.BytesIO(file.read_bytes()), allow_pickle=False) as arrays:
            told = json.loads(str(arrays["told"]))
            facts = CloudFacts(**{**told["facts"], "shown": arrays["shown"]})
            results = [_result(text, k, arrays) for k, text in enumerate(told["results"])]
            return Comparison(name, path, "", facts, int(told["vertices"]), results)
    except (OSError, EOFError, ValueError, LookupError, TypeError, zipfile.BadZipFile):
        return None


def _result(text: dict[str, Any], number: int, arrays: Any) -> Result:
    mesh, face_error = None, None
    if text["mesh"] is not None:
        given = {"points": arrays[f"points{number}"], "faces": arrays[f"faces{number}"]}
        mesh = Reconstruction(**{**text["mesh"], **given})
        face_error = arrays[f"face_error{number}"]
    curve = [(int(vertices), float(error)) for vertices, error in text["curve"]]
    result = Result(**{**text, "curve": curve, "mesh": mesh, "face_error": face_error})
    if result.method not in METHODS:
        raise ValueError(f"There is no method {result.method}.")
    return result


def _hash_of(array: Any) -> str:
    return hashlib.sha256(np.ascontiguousarray(array).tobytes()).hexdigest()
