# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of scripts/pictures.py."""

from __future__ import annotations

import argparse
import io
import subprocess
import sys
from pathlib import Path

from PIL import Image

from neuralmesh_tools.command_line import add_plugin, listed, parser_of
from neuralmesh_tools.datasets import Unavailable
from neuralmesh_tools.files import write_in_one_step
from neuralmesh_tools.layers import load_plugin
from neuralmesh_tools.pictures.scenes import SCENES
from neuralmesh_tools.pictures.screens import of_desktop, of_report
from neuralmesh_tools.project import ROOT, PluginMissing, require_plugin

PICTURES = ROOT / "docs" / "pictures"
COLOURS = 96  # of a picture: a third of the bytes, and no difference to the eye
ALL_COLOURS = 256  # of a window with icons


def small_png(png: bytes, colours: int = COLOURS) -> bytes:
    """Return a picture with a palette, which takes a fraction of the bytes."""
    picture = Image.open(io.BytesIO(png)).convert("RGB")
    small = io.BytesIO()
    picture.quantize(colours, dither=Image.Dither.NONE).save(small, "png", optimize=True)
    return small.getvalue()


def _write(path: Path, png: bytes, colours: int = COLOURS) -> None:
    picture = small_png(png, colours)
    write_in_one_step(path, picture)
    print(f"{path}: {len(picture) / 1024:.0f} KB")


def _draw_screens(options: argparse.Namespace) -> int:
    try:
        if options.report:
            _write(options.out / "compare.png", of_report(options.report))
        if options.screen:
            _write(options.out / "desktop.png", of_desktop(options.screen), ALL_COLOURS)
    except (OSError, subprocess.SubprocessError) as problem:
        print(problem, file=sys.stderr)
        return 1
    return 0


def main(description: str | None) -> int:
    """Draw what is asked for; return the exit code."""
    parser = parser_of(description)
    text = f"which to draw (default: all: {listed(SCENES)})"
    parser.add_argument("names", nargs="*", metavar="NAME", help=text)
    text = "where they go (default: docs/pictures)"
    parser.add_argument("--out", type=Path, default=PICTURES, metavar="DIR", help=text)
    text = "draw compare.png alone: this report of compare.py, in Chromium"
    parser.add_argument("--report", type=Path, metavar="FILE", help=text)
    text = "draw desktop.png alone: this picture of test_desktop"
    parser.add_argument("--screen", type=Path, metavar="FILE", help=text)
    add_plugin(parser)
    options = parser.parse_args()
    for name in options.names:
        if name not in SCENES:
            parser.error(f"there is no picture {name}; there are {listed(SCENES)}")
    if options.report or options.screen:
        return _draw_screens(options)
    try:
        load_plugin(require_plugin(options.plugin))
        for name in options.names or SCENES:
            _write(options.out / f"{name}.png", SCENES[name]())
    except (PluginMissing, Unavailable) as problem:
        print(problem, file=sys.stderr)
        return 1
    return 0
