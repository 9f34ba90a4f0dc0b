# SPDX-License-Identifier: GPL-3.0-or-later
"""`neuralmesh INPUT... -o OUTPUT`: reads, reconstructs, writes, and says what it did."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .. import files
from .._core import Deadline, __version__
from .._parameters import read_options
from .._progress import bar, part
from .._reconstruct import run as reconstruct
from .._result import Mesh, Result, plain
from .exits import DONE, say, say_what_is_left_out
from .options import most_points, parameters_of, parser

# Of the time of a run: the input is read.
SHARE_OF_READING = 0.3


def run(arguments: Sequence[str]) -> int:
    """Reconstruct; return the exit code."""
    given = parser()
    options = given.parse_args(arguments)
    parameters, names = parameters_of(options)
    # Refuse before the work what would be refused after reading; from here on, time counts.
    deadline = read_options(parameters, names).deadline
    inputs = _inputs(given, options)
    _require_output(options.output)
    if options.quiet:
        result = _reconstruct(inputs, options, parameters, names, None, deadline)
    else:
        with bar() as progress:
            result = _reconstruct(inputs, options, parameters, names, progress, deadline)
    written = _write(options.output, result)
    _tell(options, result, written)
    return DONE


def _inputs(given: argparse.ArgumentParser, options: argparse.Namespace) -> list[Path]:
    if options.merge:
        folders = [files.look_into(path) for path in options.inputs]
        if not options.quiet:
            for folder in folders:
                say_what_is_left_out(folder)
        return [file for folder in folders for file in folder.files]
    if len(options.inputs) > 1:
        given.error("several inputs make one cloud with --merge; else give one")
    if options.inputs[0].is_dir():
        given.error(f"'{options.inputs[0]}' is a folder: its files make one cloud with --merge")
    return options.inputs


def _require_output(output: Path) -> None:
    """Refuse before the work what could not be written after it."""
    if output.suffix.lower() not in files.WRITTEN:
        listed = ", ".join(files.WRITTEN)
        raise ValueError(f"'{output}': its ending must be one of {listed}.")
    if output.is_dir():
        raise ValueError(f"'{output}' is a folder.")
    if not output.absolute().parent.is_dir():
        raise ValueError(f"'{output}': there is no folder '{output.parent}'.")


def _reconstruct(
    inputs: list[Path],
    options: argparse.Namespace,
    parameters: dict[str, Any],
    names: dict[str, str],
    progress: Any,
    deadline: Deadline,
) -> Result:
    most = most_points(options)
    cloud = files.read_merged(
        inputs,
        most_points=most,
        progress=part(progress, 0, SHARE_OF_READING),
        is_time_up=lambda: deadline.has_passed,
    )
    if not options.quiet:
        _log_input(inputs, cloud)
    return reconstruct(
        cloud,
        parameters,
        progress=part(progress, SHARE_OF_READING, 1),
        names=names,
        deadline=deadline,
    )


def _log_input(inputs: list[Path], cloud: files.Cloud) -> None:
    where = f"{inputs[0].name}" if len(inputs) == 1 else f"{len(inputs)} files"
    choice = ""
    if cloud.is_choice:
        choice = (
            f"; {len(cloud.points):,} of them, a uniform choice, are kept in memory "
            "(--most-points 0 keeps all)"
        )
    say(f"{where}: {cloud.total:,} points{choice}.")


def _write(output: Path, result: Result) -> list[Path]:
    written = []
    for mesh in (*result.snapshots, result):
        path = output if mesh is result else _snapshot_path(output, mesh)
        if remark := files.write(path, mesh):
            say(remark)
        written.append(path)
    return written


def _snapshot_path(output: Path, mesh: Mesh) -> Path:
    return output.with_name(f"{output.stem}_{len(mesh.vertices)}{output.suffix}")


def _tell(options: argparse.Namespace, result: Result, written: list[Path]) -> None:
    if options.json:
        info = plain(result.info)
        info |= {"files": [str(path) for path in written], "version": __version__}
        print(json.dumps(info))
        return
    if not options.quiet:
        say(result.summary)
    for path in written:
        print(path)
