# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/compare.py and of `neuralmesh compare`."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from rich.console import Console

from neuralmesh_tools.batching.names import Source, distinct_names
from neuralmesh_tools.command_line import add_plugin, console, names
from neuralmesh_tools.comparison.arguments import COMMAND, parser_for_clouds
from neuralmesh_tools.comparison.clouds import REFERENCE_SAMPLES, load_surface
from neuralmesh_tools.comparison.kept import STATE, fingerprint, hash_of_ours, keep, kept
from neuralmesh_tools.comparison.measures import MESH_SAMPLES
from neuralmesh_tools.comparison.page import write_page
from neuralmesh_tools.comparison.run import (
    LEAST_VERTICES,
    MEASURE_SECONDS,
    Comparison,
    Settings,
    compare,
)
from neuralmesh_tools.comparison.tables import write_tables
from neuralmesh_tools.comparison.verdict import judge
from neuralmesh_tools.files import shown, write_in_one_step
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.machine import machine, version_of
from neuralmesh_tools.methods import METHODS
from neuralmesh_tools.project import PluginMissing, require_plugin

USAGE = 2
INTERRUPTED = 130  # what a shell reports of a program that Ctrl-C ended


def parse_arguments(description: str | None, given: Sequence[str] | None) -> argparse.Namespace:
    """Read the command line; exits with 2 on what cannot work.

    given: the arguments of `neuralmesh compare`, which has no plugin; None: those of the script.
    """
    parser = parser_for_clouds(description, COMMAND if given is not None else None, METHODS)
    if given is None:
        add_plugin(parser)
    options = parser.parse_intermixed_args(given)
    options.command = f"{COMMAND} {' '.join(given)}" if given is not None else _script_command()
    if given is not None:
        options.plugin = None
    options.methods = names(parser, "method", options.methods, METHODS)
    if options.vertices and options.vertices < LEAST_VERTICES:
        parser.error(f"--vertices must be at least {LEAST_VERTICES}")
    if options.threads < 1:
        parser.error("--threads must be at least 1")
    for path in [*options.clouds, *filter(None, [options.reference])]:
        if problem := _why_no_file(path):
            parser.error(problem)
    # Each cloud once, in the order given.
    options.clouds = list({path.resolve(): path for path in options.clouds}.values())
    if options.plugin and any(METHODS[name].exact for name in options.methods):
        try:
            require_plugin(options.plugin)
        except PluginMissing as problem:
            parser.error(str(problem))
    return options


def _script_command() -> str:
    return "scripts/compare.py " + " ".join(sys.argv[1:])


def _why_no_file(path: Path) -> str:
    """Why a path names no file that can be compared; empty if it does."""
    try:
        if path.is_file():
            return ""
        if path.is_dir():
            return f"{shown(path)} is a folder: name the files in it, as {shown(path / '*.ply')}"
    except OSError:  # such as a name that is too long
        pass
    return f"there is no file {shown(path)}"


def settings_of(options: argparse.Namespace) -> Settings:
    """Settings of the run; raises ValueError if the reference cannot be used."""
    surface = None
    if options.reference:
        with IsolatedProcess() as process:
            loaded = process.call(load_surface, str(options.reference), timeout=MEASURE_SECONDS)
        if not loaded.ok:
            raise ValueError(f"{shown(options.reference)}: {loaded.failure}")
        surface = loaded.value
    return Settings(
        options.methods,
        options.vertices,
        options.threshold,
        options.timeout,
        options.threads,
        options.plugin and options.plugin.resolve(),
        surface,
    )


def about_the_run(options: argparse.Namespace) -> dict[str, Any]:
    """What the report says of how it came about."""
    here = machine()
    if options.reference:
        against = f"the surface {shown(options.reference.name)}"
        distance = "Distances to it are exact."
    else:
        against = "the cloud itself"
        distance = (
            "A distance to the cloud is that to the tangent plane at the nearest point, so that "
            "the gaps between points are no error, but to the point itself where it is more than "
            "three spacings away."
        )
    return {
        "against": against,
        "measuring": (
            f"Errors are measured against {against}: from up to {REFERENCE_SAMPLES:,} points of it "
            f"to the result, exactly, and back from {MESH_SAMPLES:,} points drawn on the result, "
            f"uniformly by area, in per cent of the cloud's diagonal. {distance} The F-score "
            f"counts points within {options.threshold:g} % of the cloud's diagonal. Colours show "
            "the RMS distance of each face, on one scale for all views of a cloud; what is beyond "
            "its end is as red as the end."
        ),
        "facts": {
            "date": time.strftime("%Y-%m-%d %H:%M"),
            "machine": f"{here['processor']}, {here['cores']} cores, "
            f"{here['memory_gigabytes']} GB, {here['system']}",
            "versions": f"PyMeshLab {version_of('pymeshlab')}, Python {here['python']}, "
            f"{_ours(options.plugin)}",
            "threads": f"{options.threads} a method",
            "time-out": f"{options.timeout:g} s of computing a method and cloud",
            "command": shown(options.command),
        },
    }


def _ours(plugin: Path | None) -> str:
    """What runs our method, with the beginning of its SHA-256."""
    name = "plugin" if plugin else f"neuralmesh {version_of('neuralmesh')}"
    return f"{name} {hash_of_ours(plugin)[:12] or 'not there'}"


def main(description: str | None, given: Sequence[str] | None = None) -> int:
    """Compare, write the report, print the answers. Returns the exit code.

    given: the arguments of `neuralmesh compare`, whose clouds are read and reconstructed by the
    package; None: those of scripts/compare.py.
    """
    options = parse_arguments(description, given)
    terminal = console()
    try:
        settings = settings_of(options)
        require_writable(options.out)
    except (ValueError, OSError) as problem:
        print(shown(problem), file=sys.stderr)
        return USAGE
    comparisons: list[Comparison] = []
    try:
        for comparison in compare_all(options, settings, terminal):
            comparisons.append(comparison)
            page = write_report(comparisons, options)
    except KeyboardInterrupt:
        done = f"{len(comparisons)} of {len(options.clouds)} clouds done"
        terminal.print(f"stopped; {done}; the same command goes on from here")
        return INTERRUPTED
    except OSError as problem:
        print(f"The report cannot be written: {shown(problem)}", file=sys.stderr)
        return USAGE
    for comparison in comparisons:
        verdict = judge(comparison)
        answer = f"{verdict.sentence} {verdict.more}"
        terminal.print(shown(f"{comparison.name}: {answer}"), soft_wrap=True)
    terminal.print(shown(page), soft_wrap=True)
    answered = all(judge(comparison).method for comparison in comparisons)
    return 0 if answered else 1


def compare_all(
    options: argparse.Namespace, settings: Settings, terminal: Console
) -> Iterator[Comparison]:
    """Yield the comparison of each cloud, kept from an earlier run or made and kept now."""
    sources = [Source(path.resolve(), Path(path.name)) for path in options.clouds]
    with terminal.status("reading") as status:

        def say(line: str) -> None:
            terminal.print(shown(line), soft_wrap=True)
            status.update("next")

        for path, name in zip(options.clouds, distinct_names(sources), strict=True):
            mark = fingerprint(path, settings)
            if earlier := kept(name, shown(path), options.out, mark):
                say(f"{name}: done before")
                yield earlier
                continue
            comparison = compare(path, name, settings, say)
            keep(comparison, options.out, mark)
            yield comparison


def write_report(comparisons: list[Comparison], options: argparse.Namespace) -> Path:
    """Write tables and page of the clouds that are done; return the page's path."""
    about = about_the_run(options)
    if len(comparisons) < len(options.clouds):
        about["facts"]["clouds"] = (
            f"{len(comparisons)} of {len(options.clouds)} so far; the same command does the rest"
        )
    write_tables(comparisons, about, options.out)
    return write_page(comparisons, about, options.out)


def require_writable(out: Path) -> None:
    """Make the output folder; raises OSError with a sentence if it cannot be written to."""
    try:
        for folder in (out, out / STATE):
            folder.mkdir(parents=True, exist_ok=True)
            if folder.is_symlink() and folder != out:
                raise OSError(f"{folder} is a link that leads elsewhere")
        write_in_one_step(out / STATE / "probe", b"")
        (out / STATE / "probe").unlink()
    except OSError as problem:
        reason = problem.strerror or problem
        raise OSError(f"{out} cannot be written to: {reason}.") from problem
