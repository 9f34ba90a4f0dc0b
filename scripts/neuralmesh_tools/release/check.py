# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the files of a release as a user would: unpacks, installs, loads and runs them."""

from __future__ import annotations

import argparse
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

from neuralmesh_tools.project import PLUGIN_NAME, SCRIPTS
from neuralmesh_tools.release import needs

SKIPPED = 77  # of scripts/test_desktop

# Programs that end with 0 only if what was installed works.
HERE = Path(__file__).resolve().parent
USE_PLUGIN, USE_WHEEL, USE_PACKAGE = (
    HERE / f"use_{what}.py" for what in ("plugin", "wheel", "package")
)

# The licences of what is compiled in ask for them beside every binary.
NOTICES = ("LICENSE", "THIRD_PARTY_NOTICES.txt")


def main() -> int:
    """Check everything in a folder; raise with the reason if something is not as it should be."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="what scripts/release made")
    parser.add_argument("--no-desktop", action="store_true", help="do not start MeshLab")
    options = parser.parse_args()
    folder: Path = options.folder
    for made in [*folder.glob("*.tar.gz"), *folder.glob("*.whl")]:
        check_notices(made)
    with tempfile.TemporaryDirectory() as temporary:
        work = Path(temporary)
        desktop = unpacked(next(folder.glob("*-meshlab-*.tar.gz")), work)
        check_needs(desktop)
        if not options.no_desktop:
            check_desktop(desktop)
        scripted = unpacked(next(folder.glob("*-pymeshlab-*.tar.gz")), work)
        check_needs(scripted)
        run([sys.executable, str(USE_PLUGIN), str(scripted)])
        check_wheel(
            next(folder.glob("pymeshlab_neuralmesh-*manylinux*.whl")), work / "venv", USE_WHEEL
        )
        check_wheel(next(folder.glob("neuralmesh-*manylinux*.whl")), work / "plain", USE_PACKAGE)
    for made in sorted(folder.iterdir()):
        print(f"{made.stat().st_size / 1024:7.0f} KB  {made}")
    return 0


def unpacked(archive: Path, work: Path) -> Path:
    """Unpack an archive; return the plugin in it."""
    with tarfile.open(archive) as tar:
        tar.extractall(work, filter="data")
    return work / archive.name.removesuffix(".tar.gz") / PLUGIN_NAME


def check_notices(made: Path) -> None:
    """Raise if an archive or a wheel lacks the texts of licences."""
    if made.suffix == ".whl":
        with zipfile.ZipFile(made) as wheel:
            held = wheel.namelist()
    else:
        with tarfile.open(made) as tar:
            held = tar.getnames()
    if missing := set(NOTICES) - {Path(name).name for name in held}:
        raise RuntimeError(f"{made.name} lacks {', '.join(sorted(missing))}")


def check_needs(plugin: Path) -> None:
    """Raise if a plugin needs more than its host and the C++ run time, or looks in odd places."""
    if superfluous := needs.superfluous(plugin):
        raise RuntimeError(f"{plugin.name} needs {', '.join(sorted(superfluous))}")
    if folders := needs.search_path(plugin):
        raise RuntimeError(f"{plugin.name} looks for libraries in {', '.join(folders)}")


def check_desktop(plugin: Path) -> None:
    """Reconstruct with the plugin in the real MeshLab, where that can be had."""
    command = [str(SCRIPTS / "test_desktop"), "--plugin", str(plugin), "-q", "-k", "apply"]
    code = subprocess.run(command, check=False).returncode
    if code not in (0, SKIPPED):
        raise RuntimeError(f"scripts/test_desktop ended with {code}")


def check_wheel(wheel: Path, venv: Path, use: Path) -> None:
    """Install a wheel, with what it needs, into a new environment and use it."""
    run([sys.executable, "-m", "venv", str(venv)])
    python = str(venv / "bin" / "python")
    pip = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    run([*pip, str(wheel)])
    run([python, str(use)])


def run(command: list[str]) -> None:
    """Run a command; raise CalledProcessError if it fails."""
    subprocess.run(command, check=True)


if __name__ == "__main__":
    sys.exit(main())
