# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/batch.py: filters of PyMeshLab, held against what it has."""

from __future__ import annotations

import argparse
from pathlib import Path

from neuralmesh_tools.batching import options as shared
from neuralmesh_tools.batching import preflight
from neuralmesh_tools.batching.inputs import PYMESHLAB_SUFFIXES
from neuralmesh_tools.batching.recipe import Recipe, parse_settings
from neuralmesh_tools.command_line import parser_of
from neuralmesh_tools.files import sha256_of
from neuralmesh_tools.isolation import IsolatedProcess
from neuralmesh_tools.machine import version_of
from neuralmesh_tools.project import PLUGIN, RECONSTRUCT, require_plugin


def batch_parser(description: str | None) -> argparse.ArgumentParser:
    """The parser, with the script's own description."""
    parser = parser_of(description)
    shared.add_inputs(parser, "ply, obj, stl, off, ...")
    recipe = parser.add_argument_group("what is done to each input")
    recipe.add_argument("--vertices", type=int, metavar="N", help="short for --set targetvertnum=N")
    text = "a parameter of the filter; may be repeated"
    recipe.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help=text)
    recipe.add_argument("--mlx", type=Path, metavar="FILE", help="a MeshLab filter script instead")
    text = "a PyMeshLab plugin to load; may be repeated (default: ours)"
    recipe.add_argument("--plugin", type=Path, action="append", metavar="FILE", help=text)
    shared.add_how(parser)
    return parser


def recipe_of(options: argparse.Namespace) -> Recipe:
    """Make the recipe and hold it against what PyMeshLab has.

    Raises RecipeError, and PluginMissing.
    """
    plugins = tuple(require_plugin(path) for path in options.plugin or [PLUGIN])
    suffix = shared.suffix_of(options)
    script, parameters = "", {}
    with IsolatedProcess() as process:
        preflight.check_suffix(process, suffix)
        if options.mlx:
            script = preflight.check_script(process, plugins, options.mlx)
        else:
            pairs = list(options.set)
            if options.vertices is not None:
                pairs.append(f"targetvertnum={options.vertices}")
            defaults = preflight.filter_defaults(process, plugins, RECONSTRUCT)
            parameters = parse_settings(pairs, defaults)
    versions = {"pymeshlab": version_of("pymeshlab")}
    versions |= {plugin.name: sha256_of(plugin) for plugin in plugins}
    return Recipe(plugins, RECONSTRUCT, parameters, script, suffix, options.threads, versions)


def main(description: str | None) -> int:
    """Read the command line, run the batch, return the exit code."""
    parser = batch_parser(description)
    options = parser.parse_intermixed_args()
    if options.mlx and (options.set or options.vertices is not None):
        parser.error("--mlx holds its own parameters: --set and --vertices do not go with it")
    shared.check(parser, options)
    return shared.run(options, PYMESHLAB_SUFFIXES, lambda: recipe_of(options))
