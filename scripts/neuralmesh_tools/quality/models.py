# SPDX-License-Identifier: GPL-3.0-or-later
"""The models of the quality table, why each is there, and how its points are taken."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from neuralmesh_tools import datasets
from neuralmesh_tools.geometry import Faces, Points
from neuralmesh_tools.quality import shapes


@dataclass(frozen=True)
class Model:
    """A clean reference surface and how it is presented to the methods.

    samples: points drawn uniformly by area from the surface; 0 takes the model's own vertices,
    which is right only where they are dense. vertices: what a result is cut to by default.
    genus: that of the reference, all of them closed and connected.
    """

    why: str
    samples: int = 100_000
    vertices: int = 5_000
    genus: int = 0
    generate: Callable[[], tuple[Points, Faces]] | None = None


# Closed, connected and free of non-manifold edges, each checked with get_topological_measures
# when loaded.
MODELS: dict[str, Model] = {
    "bunny": Model("the paper's model, its own 28,088 vertices: uneven, real scan", samples=0),
    "armadillo": Model("fine relief and thin fingers, its own 26,002 vertices", samples=0),
    "dino": Model("long limbs close to each other; the paper's kind of model"),
    "bone": Model("smooth and round: where normals are easiest and Poisson best"),
    "homer": Model("fingers, hair and a mouth: thin parts, narrow concavities"),
    "fandisk": Model("the classic CAD part: sharp creases that fade into smooth faces"),
    "bracket": Model("generated L-bracket: exact flats, right angles", generate=shapes.l_bracket),
    "cortex": Model("deep narrow folds: where surfaces bridge", samples=200_000, vertices=20_000),
    "knot1": Model("genus 1: a tube that is knotted", genus=1),
    "rotor": Model("genus 1 with creases", genus=1),
    "elephant": Model("genus 3: handles of a few edges", genus=3),
    "anchor": Model("genus 4: bores in a casting", genus=4),
    "bunny00": Model("the bunny from another merge of the scans, denser", samples=0),
    "step": Model("generated: a concave corner of three creases", generate=shapes.stepped_cube),
    "blade": Model("generated: two sides 0.6 to 2.9 % apart", generate=shapes.thin_blade),
    "triceratops": Model("thin horns, a coarse polygonal reference"),
    "retinal": Model("a molecule's surface: many round concavities"),
    "camel": Model("thin legs; its reference holds 20 self-intersecting faces"),
}

# The table; the others are asked for by name.
TABLE_MODELS = list(MODELS)[:12]


def load(name: str) -> tuple[Points, Faces]:
    """Return a model's reference surface; raises datasets.Unavailable if it cannot be had."""
    generate = MODELS[name].generate
    return generate() if generate else datasets.load(name)
