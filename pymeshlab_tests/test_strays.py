# SPDX-License-Identifier: GPL-3.0-or-later
"""A few points far off change no mesh, and the log counts them: a small part of the table."""

from __future__ import annotations

from pathlib import Path

import pytest

from neuralmesh_tools.benchmarks.strays import table
from neuralmesh_tools.benchmarks.strays.run import Job
from neuralmesh_tools.isolation import IsolatedProcess

# The terrain's holes are measured by the document's box, which strays widen.
CASES = (
    ("single", 2, 100.0),
    ("tails", 60, 100.0),
    ("tails", 500, 1e7),
    ("repeated", 20, 3.0),
    ("clumps", 100, 1.5),
)


@pytest.mark.parametrize("cloud", ["sphere", "terrain"])
def test_strays_change_no_mesh_and_are_counted(plugin: Path, cloud: str):
    with IsolatedProcess() as process:  # with a log of its own
        job = Job(plugin, cloud, CASES)
        outcome = process.call(
            "neuralmesh_tools.benchmarks.strays.run:measure_body", job, timeout=300
        )
    assert outcome.ok, outcome.failure
    for case, figures in zip(CASES, outcome.value, strict=True):
        assert figures["same"], (case, figures)
        assert figures["left_out"] - figures["without"] == figures["strays"], (case, figures)


def test_a_case_is_missed_without_a_mesh_or_with_a_worse_one():
    assert table.is_missed({"failure": "All points lie on a line."})
    assert table.is_missed({"ratio": 1.11})
    assert not table.is_missed({"ratio": 1.0})
