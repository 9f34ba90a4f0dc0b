# SPDX-License-Identifier: GPL-3.0-or-later
"""Memory: runs leave none behind, large clouds are kept once, too little of it is a sentence."""

from __future__ import annotations

import re
import resource
from collections.abc import Iterator
from pathlib import Path

import pytest
from documents import Points, document_of, reconstruct, sphere_points

from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.layers import load_plugin
from neuralmesh_tools.project import PLUGIN
from neuralmesh_tools.properties.inputs import Case, Recipe
from neuralmesh_tools.properties.runs import by_package, by_plugin

MEGABYTE = 2**20
RUNNERS = [by_package, by_plugin]
# Kilobytes, in steps of 1.4.
ADDRESS_SPACE = [round(64 * 1.4**step) for step in range(28)]
SENTENCE = re.compile(r"Too little memory for this input and |vertices need about .* are free\.$")


@pytest.fixture
def process() -> Iterator[IsolatedProcess]:
    with IsolatedProcess(recycle_after=1000) as process:
        yield process


def status(name: str) -> int:
    """A figure of this process in bytes: VmRSS resident, VmHWM the most of it, VmSize address."""
    lines = Path("/proc/self/status").read_text(encoding="utf-8").splitlines()
    return next(int(line.split()[1]) * 1024 for line in lines if line.startswith(f"{name}:"))


def small_case(seed: int) -> Case:
    return Case(
        Recipe("sphere", 300, seed), {"targetvertnum": 60, "topology": 0, "randomseed": seed + 1}
    )


def growth_of_runs(runner: str) -> int:
    """Of resident memory, from the 50th run of 200 to the last, in bytes."""
    run = {function.__name__: function for function in RUNNERS}[runner]
    for number in range(200):
        if number == 50:
            before = status("VmRSS")
        assert run(small_case(number)).refusal == ""
    return status("VmRSS") - before


@pytest.mark.parametrize("runner", ["by_package", "by_plugin"])
def test_200_runs_in_a_process_do_not_grow(runner: str, process: IsolatedProcess) -> None:
    outcome = process.call(growth_of_runs, runner)
    assert outcome.ok, outcome.failure
    # A run that left its mesh of 60 vertices behind would add 10 KB, 1.5 MB in all.
    assert outcome.value < MEGABYTE


def memory_of_ten_million_points() -> float:
    """What a reconstruction adds at the most, as a share of the coordinates."""
    import neuralmesh

    neuralmesh.reconstruct(sphere_points(1000), 50)
    points = sphere_points(10_000_000)
    before = status("VmRSS")
    Path("/proc/self/clear_refs").write_text("5", encoding="utf-8")
    neuralmesh.reconstruct(points, 100, topology=0)
    return (status("VmHWM") - before) / points.nbytes


def test_ten_million_points_are_kept_once(process: IsolatedProcess) -> None:
    outcome = process.call(memory_of_ten_million_points)
    assert outcome.ok, outcome.failure
    assert outcome.value < 1.5


def failures_within(runner: str) -> list[str]:
    """What runs end in that have more and more address space, from next to none to enough."""
    import neuralmesh
    import pymeshlab

    points = sphere_points(100_000)
    asked = {"targetvertnum": 1000, "signalspersplit": 1, "topology": 0, "threads": 2}

    load_plugin(PLUGIN)

    def run(points: Points, parameters: dict[str, object]) -> None:
        if runner == "by_plugin":
            reconstruct(document_of(points), **parameters)
        else:
            neuralmesh.reconstruct(points, **parameters)

    run(points[:100], {"targetvertnum": 20})
    failures = []
    before = resource.getrlimit(resource.RLIMIT_AS)
    for kilobytes in ADDRESS_SPACE:
        limit = status("VmSize") + 1024 * kilobytes
        resource.setrlimit(resource.RLIMIT_AS, (limit, before[1]))
        try:
            run(points, asked)
            failures.append("")
        except (MemoryError, neuralmesh.InvalidInput, pymeshlab.PyMeshLabException) as failure:
            failures.append(str(failure))
        finally:
            resource.setrlimit(resource.RLIMIT_AS, before)
    return failures


@pytest.mark.parametrize("runner", ["by_package", "by_plugin"])
def test_too_little_memory_is_a_sentence(runner: str, process: IsolatedProcess) -> None:
    outcome = process.call(failures_within, runner)
    assert outcome.ok, outcome.failure
    *failures, last = outcome.value
    assert last == ""
    assert any(failures)
    for failure in filter(None, failures):
        assert SENTENCE.search(failure), outcome.value
