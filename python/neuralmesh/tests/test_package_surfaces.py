# SPDX-License-Identifier: GPL-3.0-or-later
"""Target spaces besides clouds: meshes, expressions, Python functions, samplers of one's own."""

from __future__ import annotations

import neuralmesh
import numpy as np
import pytest
from neuralmesh import ImplicitSurface, ParametricSurface, Surface
from neuralmesh._implicit import ImplicitSampler
from neuralmesh._parametric import ParametricSampler
from numpy.typing import NDArray

Points = NDArray[np.float64]


def sphere(x: Points, y: Points, z: Points) -> Points:
    return x * x + y * y + z * z - 0.5


def torus(x: Points, y: Points, z: Points) -> Points:
    return (np.hypot(x, y) - 0.6) ** 2 + z * z - 0.04


def ellipsoid(u: Points, v: Points) -> tuple[Points, Points, Points]:
    return 2 * np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)


def chi_square(counts: NDArray[np.int64]) -> float:
    expected = counts.mean()
    return float(((counts - expected) ** 2 / expected).sum())


def test_samples_of_a_function_are_uniform_by_area() -> None:
    sampler = ImplicitSampler(sphere, (-1, -1, -1), (1, 1, 1))
    samples = sampler.draw(np.random.default_rng(1), 40_000)
    assert samples.shape == (40_000, 3)
    assert np.abs(sphere(*samples.T)).max() < 1e-9
    for axis in range(3):  # by Archimedes, slices of one height have one area
        counts = np.histogram(samples[:, axis], 20, (-np.sqrt(0.5), np.sqrt(0.5)))[0]
        assert chi_square(counts) < 44  # of 19 degrees of freedom, one in a thousand is above


def test_samples_of_a_parametric_function_are_uniform_by_area() -> None:
    def round_(u: Points, v: Points) -> tuple[Points, Points, Points]:
        return np.cos(u) * np.sin(v), np.sin(u) * np.sin(v), np.cos(v)

    sampler = ParametricSampler(round_, (0, 2 * np.pi), (0, np.pi))
    samples = sampler.draw(np.random.default_rng(1), 40_000)
    for axis in range(3):
        assert chi_square(np.histogram(samples[:, axis], 20, (-1, 1))[0]) < 44


@pytest.mark.parametrize(("function", "genus"), [(sphere, 0), (torus, 1)])
def test_a_function_makes_a_mesh(function: object, genus: int) -> None:
    made = neuralmesh.reconstruct(ImplicitSurface(function), 800)
    assert made.info["genus"] == genus
    # Faces of 800 vertices cut the round by some thousandths.
    assert np.abs(function(*made.vertices.T)).max() < 0.02
    again = neuralmesh.reconstruct(ImplicitSurface(function), 800)
    assert np.array_equal(again.vertices, made.vertices)


def test_a_parametric_function_makes_a_mesh() -> None:
    made = neuralmesh.reconstruct(ParametricSurface(ellipsoid), 500)
    x, y, z = made.vertices.T
    assert np.abs(x * x / 4 + y * y + z * z - 1).max() < 0.1
    assert made.info["genus"] == 0


def test_the_surface_of_a_mesh_is_sampled() -> None:
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=float)
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    made = neuralmesh.reconstruct(Surface(corners, faces), 200)
    assert len(made.vertices) == 200
    assert made.info["genus"] == 0


class Shell:
    """A sampler of one's own."""

    lower = (-1, -1, -1)
    upper = (1, 1, 1)

    def draw(self, random: np.random.Generator, count: int) -> Points:
        points = random.normal(size=(count, 3))
        return points / np.linalg.norm(points, axis=1)[:, None]


def test_a_sampler_of_ones_own() -> None:
    first, second = (neuralmesh.reconstruct(Shell(), 300) for _ in range(2))
    assert np.array_equal(first.vertices, second.vertices)
    assert first.info["rms_error"] < 0.01


def test_a_type_checker_takes_a_sampler_whose_corners_are_tuples() -> None:
    # A member that may be assigned to would have to be a Sequence in the class, too.
    assert isinstance(Shell(), neuralmesh.Sampler)
    for corner in ("lower", "upper"):
        member = vars(neuralmesh.Sampler)[corner]
        assert isinstance(member, property)
        assert member.fset is None


class Failing(Shell):
    def draw(self, random: np.random.Generator, count: int) -> Points:
        raise LookupError("mine")


class TooFew(Shell):
    def draw(self, random: np.random.Generator, count: int) -> Points:
        return np.zeros((count - 1, 3))


def test_what_a_sampler_raises_comes_out() -> None:
    with pytest.raises(LookupError, match="mine"):
        neuralmesh.reconstruct(Failing(), 300)
    with pytest.raises(neuralmesh.InvalidInput, match=r"draw\(\) must return \(1000, 3\) numbers"):
        neuralmesh.reconstruct(TooFew(), 300)


@pytest.mark.parametrize(
    ("source", "sentence"),
    [
        (ImplicitSurface("x*x+"), "expr does not parse: .* at position 5"),
        (
            ImplicitSurface("x*x+1"),
            "No surface was found in the box: expr passes through zero nowhere",
        ),
        (ImplicitSurface(lambda x, y, z: x * x + 1), "There is no surface in the box: the funct"),
        (ImplicitSurface(lambda x, y, z: 1 / np.maximum(x, 0)), "The function is not finite at "),
        (ImplicitSurface(lambda x, y, z: x[:5]), "must return as many values as it is given"),
        (ImplicitSurface("x", (1, 1, 1), (0, 2, 2)), r"lower\[0\] must be below upper\[0\]"),
        (ImplicitSurface(sphere, (1, 1, 1), (0, 2, 2)), r"lower\[0\] must be below upper\[0\]"),
        (ParametricSurface(("u", "v", "0"), u=(1, 0)), r"u\[0\] must be below u\[1\]"),
        (ParametricSurface(ellipsoid, v=(1, 0)), r"v\[0\] must be below v\[1\]"),
        (ParametricSurface(lambda u, v: (u, v)), "must return three arrays"),
        (ParametricSurface(lambda u, v: (u * np.nan, v, u)), "not finite at u = 0, v = 0"),
        (ParametricSurface(lambda u, v: (0 * u, 0 * u, 0 * u)), "The surface has no area"),
        (Surface(np.zeros((3, 3)), [[0, 1, 3]]), "faces name a vertex that is not there"),
        (Surface(np.eye(3), np.zeros((0, 3), int)), "no faces|no area|face"),
    ],
)
def test_what_has_no_surface_is_refused(source: object, sentence: str) -> None:
    with pytest.raises(neuralmesh.InvalidInput, match=sentence), np.errstate(divide="ignore"):
        neuralmesh.reconstruct(source, 100)
