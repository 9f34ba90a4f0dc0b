# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of screens: the report of scripts/compare.py in Chromium, and MeshLab's window."""

from __future__ import annotations

import io
import subprocess
import tempfile
from pathlib import Path

from PIL import Image

CHROMIUM = "chromium"
# The report's top, down to the end of the first cloud's views.
PAGE = (1200, 1925)
WIDTH = 700  # of the page in the documents, in pixels
SCREEN_WIDTH = 1100
# Milliseconds of the page's own clock, which runs ahead of ours: enough for WebGL to draw.
DRAWING = 60_000
LIMIT = 120.0  # seconds of ours
OPTIONS = (
    "--headless=new",
    "--no-sandbox",  # root has none
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--no-first-run",
    "--hide-scrollbars",
)


def of_report(page: Path) -> bytes:
    """Return a PNG of a report; raises OSError or subprocess.SubprocessError without Chromium."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "page.png"
        command = [CHROMIUM, *OPTIONS, f"--user-data-dir={folder}/profile"]
        command += [f"--window-size={PAGE[0]},{PAGE[1]}", f"--virtual-time-budget={DRAWING}"]
        command += [f"--screenshot={picture}", page.resolve().as_uri()]
        subprocess.run(command, check=True, capture_output=True, timeout=LIMIT)
        return _narrowed(picture, WIDTH)


def of_desktop(screen: Path) -> bytes:
    """Return a PNG of a picture that the desktop's tests took, such as out/desktop/result.png."""
    return _narrowed(screen, SCREEN_WIDTH)


def _narrowed(path: Path, width: int) -> bytes:
    png = io.BytesIO()
    with Image.open(path) as picture:
        height = round(picture.height * width / picture.width)
        size = (width, height)
        picture.convert("RGB").resize(size, Image.Resampling.LANCZOS).save(png, "png")
    return png.getvalue()
