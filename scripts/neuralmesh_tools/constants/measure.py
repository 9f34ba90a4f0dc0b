# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the measuring program and compares what a change makes of its figures."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import geometric_mean, mean, median

PROGRAM = "filter_neuralmesh/bench/measure_shapes"
# A changed constant may make growth endless. All shapes and three seeds take half a minute.
TIMEOUT = 300.0
# A shape is named where its error changes by so much more than that of all.
REMARKABLE = 1.1


class NotMeasured(RuntimeError):
    """The program failed or did not end; the message says which."""


@dataclass(frozen=True)
class Figures:
    """Of one mesh: errors in per cent of the diagonal, seconds of processor time."""

    shape: str
    seed: int
    rms: float
    greatest: float
    valence6: float
    seconds: float
    crossings: int

    def is_same_mesh(self, other: Figures) -> bool:
        """Whether all but the time is the same."""
        return (self.shape, self.seed, self.rms, self.greatest, self.valence6) == (
            other.shape,
            other.seed,
            other.rms,
            other.greatest,
            other.valence6,
        )


@dataclass(frozen=True)
class Task:
    """What is reconstructed: so many vertices, these seeds."""

    vertices: int = 1500
    seeds: tuple[int, ...] = (1, 2, 3)

    def run(
        self,
        program: Path,
        shapes: Iterable[str],
        parameters: Iterable[str] = (),
        environment: Mapping[str, str] | None = None,
    ) -> list[Figures]:
        """Measure some shapes; parameters are like winnerRate=0.1. Raises NotMeasured.

        `environment` is what the program finds in its environment besides our own.
        """
        seeds = ",".join(map(str, self.seeds))
        command = [str(program), str(self.vertices), seeds, *shapes, *parameters]
        try:
            done = subprocess.run(
                command,
                capture_output=True,
                text=True,
                timeout=TIMEOUT,
                check=False,
                env=os.environ | dict(environment or {}),
            )
        except subprocess.TimeoutExpired as late:
            raise NotMeasured(f"no end after {TIMEOUT:.0f} s") from late
        if done.returncode != 0:
            raise NotMeasured(done.stderr.strip() or f"exit code {done.returncode}")
        return [_figures(line) for line in done.stdout.splitlines()[1:]]


@dataclass(frozen=True)
class Effect:
    """What a change makes of the figures, as ratios, of crossings as a difference."""

    rms: float
    greatest: float
    valence6: float
    seconds: float
    crossings: int
    furthest: str
    """The shape whose RMS changes most; with what ratio:"""
    furthest_rms: float
    is_none: bool
    """Whether all meshes are the same."""

    def __str__(self) -> str:
        """RMS (a remarkable shape's) / greatest / valence 6 / time / crossings."""
        if self.is_none:
            return "the same meshes"
        apart = max(self.furthest_rms / self.rms, self.rms / self.furthest_rms)
        shape = f" ({self.furthest} {self.furthest_rms:.2f})" if apart >= REMARKABLE else ""
        crossings = f" / {self.crossings:+d}" if self.crossings else ""
        return (
            f"{self.rms:.2f}{shape} / {self.greatest:.2f} / {self.valence6:.2f} / "
            f"{self.seconds:.2f}{crossings}"
        )


def compare(before: Sequence[Figures], after: Sequence[Figures]) -> Effect:
    """Compare figures of the same shapes: the median of the seeds, the geometric mean of shapes."""
    shapes = list(dict.fromkeys(f.shape for f in before))

    def ratios(of: Callable[[Figures], float], summary: Callable[..., float]) -> dict[str, float]:
        def one(figures: Sequence[Figures], shape: str) -> float:
            return summary([of(f) for f in figures if f.shape == shape])

        return {shape: one(after, shape) / one(before, shape) for shape in shapes}

    rms = ratios(lambda f: f.rms, median)
    furthest = max(shapes, key=lambda shape: max(rms[shape], 1 / rms[shape]))
    return Effect(
        geometric_mean(rms.values()),
        geometric_mean(ratios(lambda f: f.greatest, median).values()),
        geometric_mean(ratios(lambda f: f.valence6, mean).values()),
        geometric_mean(ratios(lambda f: f.seconds, sum).values()),
        sum(f.crossings for f in after) - sum(f.crossings for f in before),
        furthest,
        rms[furthest],
        all(a.is_same_mesh(b) for a, b in zip(before, after, strict=True)),
    )


def _figures(line: str) -> Figures:
    shape, seed, rms, greatest, valence6, seconds, crossings = line.split("\t")
    return Figures(
        shape,
        int(seed),
        float(rms),
        float(greatest),
        float(valence6),
        float(seconds),
        int(crossings),
    )
