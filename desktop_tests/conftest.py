# SPDX-License-Identifier: GPL-3.0-or-later
"""Fixtures of the desktop tests, which run inside the root that scripts/test_desktop makes."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent))

from display import Display
from meshlab import MeshLab
from scene import SCREENSHOTS, SINGLE_PLUGIN


@pytest.fixture(scope="session")
def work() -> Path:
    """The folder with the plugins and the clouds, where results go."""
    return Path(os.environ["NEURALMESH_DESKTOP_WORK"])


@pytest.fixture(scope="session")
def display(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Display]:
    """A screen for the whole run."""
    screen = Display(tmp_path_factory.mktemp("display"))
    yield screen
    screen.close()


@pytest.fixture
def screenshot(display: Display, work: Path) -> Callable[[str], None]:
    """Keep what the screen shows, under a name."""
    folder = work / SCREENSHOTS
    folder.mkdir(exist_ok=True)
    return lambda name: display.screenshot(folder / f"{name}.png")


@pytest.fixture
def start_meshlab(
    request: pytest.FixtureRequest, screenshot: Callable[[str], None], work: Path
) -> Iterator[Callable[..., MeshLab]]:
    """Start a MeshLab with files of the work folder; it ends with the test."""
    running: list[MeshLab] = []

    def start(*files: str, plugin: str = SINGLE_PLUGIN) -> MeshLab:
        meshlab = MeshLab(work / plugin, *(work / file for file in files))
        running.append(meshlab)
        return meshlab

    yield start
    if request.node.stash.get(FAILED, False):
        screenshot(f"failed-{request.node.name}")
        print(*(meshlab.output() for meshlab in running))
    for meshlab in running:
        meshlab.close()


FAILED = pytest.StashKey[bool]()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Iterator[pytest.TestReport]:
    """Remember for the fixtures whether the test itself failed."""
    report = yield
    if report.when == "call":
        item.stash[FAILED] = report.failed
    return report
