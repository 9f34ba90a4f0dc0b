# SPDX-License-Identifier: GPL-3.0-or-later
"""A case in a process of its own, and what is wrong about what became of it."""

from __future__ import annotations

from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.properties.claims import false_claim
from neuralmesh_tools.properties.inputs import Case
from neuralmesh_tools.properties.promises import broken_promise
from neuralmesh_tools.properties.runs import Run

# Seconds of CPU time that a case may take: the largest clouds take two.
TIMEOUT = 60.0
CALLS = 100_000  # in one process: starting it takes longer than most cases


def new_process() -> IsolatedProcess:
    """Return a process for many cases; a crash costs the case only."""
    return IsolatedProcess(recycle_after=CALLS)


def fault(case: Case, run: Run) -> str:
    """Say which promise a run breaks, or what in its refusal is not true, or nothing."""
    return false_claim(run.refusal, case) if run.refusal else broken_promise(case, run)


def judge_run(process: IsolatedProcess, runner: str, case: Case) -> tuple[Run | None, str]:
    """Run a case by the function of runs.py named: what became of it, and what is wrong, if any."""
    outcome = process.call(f"{Run.__module__}:{runner}", case, cpu_timeout=TIMEOUT)
    return outcome.value, fault(case, outcome.value) if outcome.ok else outcome.failure


def judge(process: IsolatedProcess, runner: str, case: Case) -> str:
    """Run a case likewise, and say what is wrong, or nothing."""
    return judge_run(process, runner, case)[1]
