# SPDX-License-Identifier: GPL-3.0-or-later
"""Progress: the caller's own function, or a bar by rich."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

# Told the share of the work that is done, from 0 to 1, and what is being done. False cancels.
Progress = Callable[[float, str], object]


@contextmanager
def reporting(progress: Progress | bool | None) -> Iterator[Progress | None]:
    """Give the function that is told the progress; True shows a bar on standard error."""
    if progress is True:
        with bar() as report:
            yield report
    else:
        yield progress or None


@contextmanager
def bar() -> Iterator[Progress]:
    """Show a bar on standard error; where that is no terminal, nothing."""
    from rich.console import Console
    from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeElapsedColumn
    from rich.progress import Progress as Bar

    console = Console(stderr=True)
    columns = (
        TextColumn("{task.description:20}"),
        BarColumn(),
        TaskProgressColumn(),
        TimeElapsedColumn(),
    )
    with Bar(*columns, console=console, transient=True, disable=not console.is_terminal) as shown:
        task = shown.add_task("Reading the input", total=1.0)

        def report(fraction: float, activity: str) -> None:
            shown.update(task, completed=fraction, description=activity)

        yield report


def part(progress: Progress | None, begin: float, end: float) -> Progress | None:
    """A part of the work as a whole of its own."""
    if progress is None:
        return None
    return lambda fraction, activity: progress(begin + (end - begin) * fraction, activity)
