# SPDX-License-Identifier: GPL-3.0-or-later
"""Clouds of shapes that are hard for a reconstruction: many are the surface of no body."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from neuralmesh_tools.generated_clouds import bent_sheet, cup, flat_square, spheres, torus
from neuralmesh_tools.geometry import Points
from neuralmesh_tools.properties.inputs import SHAPES as RANDOM_SHAPES

# Makes points (count, 3) of a seed.
Shape = Callable[[int, int], Points]


def _sphere(count: int, seed: int) -> Points:
    return _nested_spheres(count, seed, [1.0])


def _nested_spheres(count: int, seed: int, radii: Sequence[float]) -> Points:
    return spheres(count, seed, np.zeros((len(radii), 3)), np.array(radii))


def _chain(count: int, seed: int) -> Points:
    """Five rings through each other."""
    generator = np.random.default_rng(seed)
    links: Points = torus(count, seed) * [1, 1, 0.5]
    link = generator.integers(0, 5, count)
    odd = link % 2 == 1
    links[odd] = links[odd][:, [0, 2, 1]]
    links[:, 0] += 1.5 * link
    return links


def _mug(count: int, seed: int) -> Points:
    """A cup with walls of 3 % of its diagonal, and a handle that ends at its outside."""
    ring = torus(count // 8, seed)[:, [0, 2, 1]] * [0.6, 0.25, 0.6] + [1.1, 0, 1]
    outside = ring[np.hypot(ring[:, 0], ring[:, 1]) > 1]
    return np.vstack([cup(count - len(outside), seed, 0.1), outside])


def _stack_of_sheets(count: int, seed: int) -> Points:
    """Four bent sheets, one above the other, a twentieth of their side apart."""
    sheet = bent_sheet(count, seed)
    sheet[:, 2] += 0.05 * np.random.default_rng([seed, 1]).integers(0, 4, count)
    return sheet


def _room(count: int, seed: int) -> Points:
    """Floor, ceiling and walls of a room, with four boxes in it that stand on the floor."""
    generator = np.random.default_rng(seed)
    corners = [[0.0, 0, 0], *([*generator.uniform(0.1, 3.3, 2), 0] for _ in range(4))]
    sizes = [[4.0, 4, 2.5], *([*generator.uniform(0.3, 0.6, 2), 0.8] for _ in range(4))]
    return _boxes(count, generator, np.array(corners), np.array(sizes))


def _boxes(count: int, generator: np.random.Generator, corners: Points, sizes: Points) -> Points:
    """Points on boxes (k, 3), uniformly by area."""
    areas = np.stack([sizes[:, [1, 2]], sizes[:, [0, 2]], sizes[:, [0, 1]]]).prod(axis=2)
    side = generator.choice(areas.size, size=count, p=(areas / areas.sum()).ravel())
    across, box = np.divmod(side, len(sizes))
    within = generator.random((count, 3))
    within[np.arange(count), across] = generator.integers(0, 2, count)
    return corners[box] + within * sizes[box]


def _crossing_planes(count: int, seed: int) -> Points:
    """Three squares that cross each other in the middle."""
    generator = np.random.default_rng(seed)
    points = generator.uniform(-1, 1, (count, 3))
    points[np.arange(count), generator.integers(0, 3, count)] = 0
    return points


def _rolled_sheet(count: int, seed: int) -> Points:
    """A sheet of three turns, its layers 0.3 apart."""
    generator = np.random.default_rng(seed)
    angle = 6 * np.pi * np.sqrt(generator.uniform(0.1, 1, count))
    radius = 0.3 * angle / (2 * np.pi)
    return np.c_[radius * np.cos(angle), generator.uniform(0, 1.5, count), radius * np.sin(angle)]


def _moebius_strip(count: int, seed: int) -> Points:
    generator = np.random.default_rng(seed)
    around, across = generator.uniform(0, 2 * np.pi, count), generator.uniform(-0.4, 0.4, count)
    radius = 1 + across * np.cos(around / 2)
    return np.c_[radius * np.cos(around), radius * np.sin(around), across * np.sin(around / 2)]


def _plate(count: int, seed: int) -> Points:
    """Both sides of a square plate a fiftieth of its side thick, not scanned at its edges."""
    square = flat_square(count, seed)
    square[:, 2] = 0.02 * np.random.default_rng([seed, 1]).integers(0, 2, count)
    return square


def _grille(count: int, seed: int) -> Points:
    """Sixteen bars that lie on each other crosswise."""
    corners = [[*place, 0.0] for place in ([0.0, 0.5 * k] for k in range(8))]
    corners += [[*place, 0.1] for place in ([0.5 * k, 0.0] for k in range(8))]
    sizes = [[3.6, 0.1, 0.1]] * 8 + [[0.1, 3.6, 0.1]] * 8
    return _boxes(count, np.random.default_rng(seed), np.array(corners), np.array(sizes))


def _tubes(
    count: int, generator: np.random.Generator, starts: Points, ends: Points, radii: Points
) -> Points:
    """Points on cones without bases from starts to ends (k, 3) of radii (k, 2), by length."""
    lengths = np.linalg.norm(ends - starts, axis=1)
    chosen = generator.choice(len(starts), size=count, p=lengths / lengths.sum())
    along, around = generator.random(count), generator.uniform(0, 2 * np.pi, count)
    axis = ((ends - starts) / lengths[:, None])[chosen]
    helper = np.eye(3)[np.abs(axis).argmin(axis=1)]
    first = np.cross(axis, helper)
    first /= np.linalg.norm(first, axis=1)[:, None]
    second = np.cross(axis, first)
    radius = radii[chosen, 0] + along * (radii[chosen, 1] - radii[chosen, 0])
    centre = starts[chosen] + along[:, None] * (ends - starts)[chosen]
    on_circle = np.cos(around)[:, None] * first + np.sin(around)[:, None] * second
    result: Points = centre + radius[:, None] * on_circle
    return result


def _tree(count: int, seed: int) -> Points:
    """A trunk that forks six times, each branch thinner and shorter than what it grows from."""
    generator = np.random.default_rng(seed)
    starts, ends = [np.zeros(3)], [np.array([0.0, 0, 1])]
    radii, newest = [(0.1, 0.07)], [0]
    for _ in range(6):
        grown = []
        for parent in newest:
            for _fork in range(2):
                along = ends[parent] - starts[parent]
                branch = 0.8 * along + 0.5 * np.linalg.norm(along) * generator.normal(size=3)
                grown.append(len(starts))
                starts.append(ends[parent])
                ends.append(ends[parent] + branch)
                radii.append((radii[parent][1], 0.7 * radii[parent][1]))
        newest = grown
    return _tubes(count, generator, np.array(starts), np.array(ends), np.array(radii))


def _spring(count: int, seed: int) -> Points:
    """A wire of radius 0.05 along a helix of eight turns."""
    turns = np.linspace(0, 16 * np.pi, 400)
    line = np.c_[np.cos(turns), np.sin(turns), turns / 20]
    return _tubes(
        count, np.random.default_rng(seed), line[:-1], line[1:], np.full((len(line) - 1, 2), 0.05)
    )


def _line_of_a_spiral(count: int, seed: int) -> Points:
    """A curve, which has no surface at all."""
    angle = np.random.default_rng(seed).uniform(0, 16 * np.pi, count)
    return np.c_[angle * np.cos(angle), angle * np.sin(angle), angle] / 50


def _hedgehog(count: int, seed: int) -> Points:
    """A sphere with 60 spikes as long as its radius."""
    generator = np.random.default_rng(seed)
    points = _sphere(count, seed)
    spikes = _sphere(60, seed + 1)
    steepness = np.arccos(np.clip((points @ spikes.T).max(axis=1), -1, 1))
    grown = points * (1 + np.exp(-((steepness / 0.08) ** 2)))[:, None]
    return generator.permutation(grown)


def _gaussian_cloud(count: int, seed: int) -> Points:
    return np.random.default_rng(seed).normal(size=(count, 3))


def _clumps(count: int, seed: int) -> Points:
    generator = np.random.default_rng(seed)
    centres = generator.uniform(-1, 1, (30, 3))
    return centres[generator.integers(0, 30, count)] + generator.normal(scale=0.02, size=(count, 3))


def _noisy_sphere(count: int, seed: int) -> Points:
    noise = np.random.default_rng([seed, 1]).normal(scale=0.05, size=(count, 3))
    return _sphere(count, seed) + noise


def _uneven_sphere(count: int, seed: int) -> Points:
    """Points a hundred times as dense at one pole as at the other."""
    generator = np.random.default_rng(seed)
    height = 2 * (100.0 ** generator.random(count) - 1) / 99 - 1
    around: NDArray[np.float64] = generator.uniform(0, 2 * np.pi, count)
    radius = np.sqrt(1 - height**2)
    return np.c_[radius * np.cos(around), radius * np.sin(around), height]


def _lone_parts(count: int, seed: int) -> Points:
    """Two hundred spheres side by side."""
    places = np.stack(np.meshgrid(range(20), range(10), [0]), -1).reshape(-1, 3).astype(float)
    return spheres(count, seed, places, np.full(len(places), 0.35))


def _random(name: str) -> Shape:
    """A shape of the tests of random clouds."""
    return lambda count, seed: RANDOM_SHAPES[name](count, np.random.default_rng(seed))


BENIGN: Shape = _sphere
SHAPES: dict[str, Shape] = {
    "two-shells": lambda count, seed: _nested_spheres(count, seed, [1, 0.9]),
    "five-shells": lambda count, seed: _nested_spheres(count, seed, [1, 0.8, 0.6, 0.4, 0.2]),
    "lone-parts": _lone_parts,
    "chain": _chain,
    "mug": _mug,
    "grille": _grille,
    "room": _room,
    "plate": _plate,
    "flat-square": flat_square,
    "stack-of-sheets": _stack_of_sheets,
    "rolled-sheet": _rolled_sheet,
    "moebius-strip": _moebius_strip,
    "crossing-planes": _crossing_planes,
    "tree": _tree,
    "spring": _spring,
    "line-of-a-spiral": _line_of_a_spiral,
    "hedgehog": _hedgehog,
    "solid-cube": _random("uniform"),
    "gaussian-cloud": _gaussian_cloud,
    "heavy-tails": _random("heavy tails"),
    "clumps": _clumps,
    "lattice": _random("lattice"),
    "noisy-sphere": _noisy_sphere,
    "uneven-sphere": _uneven_sphere,
}
"""Twenty-four shapes, by name."""
