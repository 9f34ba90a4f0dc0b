# SPDX-License-Identifier: GPL-3.0-or-later
"""What the programs in scripts/ are made of.

What they share:

project.py    where plugins, samples and the cache are, what our filters are called
isolation.py  a call in a process of its own            files.py     writing in one step, hashes
layers.py     PyMeshLab's documents and arrays          geometry.py  normals, samples of surfaces
methods.py    the registry of reconstruction filters    metrics.py   what a mesh is worth
datasets/     public models by name                     machine.py   what a report says of it
drawing.py    pictures without a screen                 generated_clouds.py  clouds and PLY files
command_line.py  options that several programs have
operating_system.py  what Linux, macOS and Windows differ in
meshlab2.py   writes filters.json of the adapter for MeshLab's rewrite

And one package a program: quality/ and benchmarks/ (benchmark.py), comparison/ (compare.py),
batching/ (batch.py), paper/ (reproduce_paper.py), desktop/ (test_desktop), release/ (release);
quickstart.py is run by scripts/quickstart. comparison/, batching/ and what they need are in the
wheel of the package neuralmesh too, for `neuralmesh batch` and `neuralmesh compare`.
"""
