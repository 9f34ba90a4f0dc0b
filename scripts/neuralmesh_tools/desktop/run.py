# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the desktop tests in the Debian root and reads back what they saved.

To be started by scripts/test_desktop in namespaces of its own (mounts, processes, network): the
mounts made here and whatever a test leaves running are gone with them. The root itself is
read-only during the run. Exit code: 0 all tests and checks passed; 1 not.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np

from neuralmesh_tools.layers import arrays_of, document_of, read_document
from neuralmesh_tools.project import BUILT_PLUGIN, ROOT, SCRIPTS, sample_meshes

TESTS = ROOT / "desktop_tests"
sys.path.insert(0, str(TESTS))

import scene  # noqa: E402 # the tests' own names and numbers

SCRIPT = f"""<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Delete Current Mesh"/>
 <filter name="{scene.OLD_NAME}"/>
</FilterScript>
"""


def main() -> int:
    """Prepare the folder that both sides see, run the tests, check what they saved."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=Path, required=True, help="the Debian root")
    parser.add_argument("--work", type=Path, required=True, help="an empty folder for this run")
    parser.add_argument("--out", type=Path, required=True, help="where screenshots are kept")
    parser.add_argument("--plugin", type=Path, required=True, help="the plugin to be tested")
    parser.add_argument("tests", nargs="*", help="options and names for pytest")
    options = parser.parse_args()
    prepare(options.work, options.plugin)
    mount(options.root, options.work)
    passed = run_tests(options.root, options.tests)
    keep_screenshots(options.work, options.out)
    left = other_processes()
    if left:
        print("test_desktop: still running after the tests:", *left, file=sys.stderr)
    if passed:
        # Without a selection, both files have to be there.
        if not options.tests or (options.work / scene.SAVED_MESH).exists():
            check_saved_mesh(options.work)
        if not options.tests or (options.work / scene.KEPT_CLOUD).exists():
            check_kept_cloud(options.work)
    return 0 if passed and not left else 1


def prepare(work: Path, plugin: Path) -> None:
    """Put the plugins and the input into the work folder."""
    shutil.copy(plugin, work / scene.SINGLE_PLUGIN)
    shutil.copy(BUILT_PLUGIN, work / scene.DOUBLE_PLUGIN)
    (work / scene.EMPTYING_SCRIPT).write_text(SCRIPT, encoding="utf-8")
    for script in scene.EXAMPLE_SCRIPTS:
        shutil.copy(SCRIPTS / "examples" / script, work / script)
    save_cloud(vertices(sample_meshes() / "bunny.obj"), work / scene.CLOUD)
    directions = np.random.default_rng(1).normal(size=(scene.SMALL_POINTS, 3))
    sphere = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    save_cloud(sphere, work / scene.SMALL)
    save_cloud(sphere[: scene.FEW_POINTS], work / scene.FEW)


def save_cloud(points: np.ndarray, path: Path) -> None:
    """Write points, shape (n, 3), as a mesh file without faces, in the desktop's precision."""
    document = document_of(points.astype(np.float32).astype(np.float64))
    document.save_current_mesh(str(path), binary=True)


def mount(root: Path, work: Path) -> None:
    """Lay the work folder and the tests into the root, which is read-only itself."""
    for arguments in (
        ["--bind", str(root), str(root)],
        ["-o", "remount,bind,ro", str(root)],
        ["--bind", str(work), str(root / "work")],
        ["--bind", "-o", "ro", str(TESTS), str(root / "tests")],
        ["-t", "proc", "proc", str(root / "proc")],
        ["-t", "tmpfs", "tmpfs", str(root / "tmp")],
        ["--rbind", "/dev", str(root / "dev")],
    ):
        subprocess.run(["mount", *arguments], check=True)


def run_tests(root: Path, selection: list[str]) -> bool:
    """Run pytest inside; return whether all tests passed."""
    environment = {
        "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
        "HOME": "/tmp",
        "LANG": "C.UTF-8",
        "XDG_RUNTIME_DIR": "/tmp",
        "PYTHONDONTWRITEBYTECODE": "1",
        "NEURALMESH_DESKTOP_WORK": "/work",
    }
    pytest = ["python3", "-m", "pytest", "-ra", "-p", "no:cacheprovider", "/tests", *selection]
    return (
        subprocess.run(["chroot", str(root), *pytest], env=environment, check=False).returncode == 0
    )


def other_processes() -> list[str]:
    """Return the names of all other processes of this namespace that have not ended."""
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            status = dict(
                line.split(":\t", 1) for line in (folder / "status").read_text().splitlines()
            )
        except (FileNotFoundError, ProcessLookupError, ValueError):
            continue
        if int(folder.name) != os.getpid() and not status["State"].startswith("Z"):
            found.append(f"{status['Name']} ({folder.name})")
    return found


def keep_screenshots(work: Path, out: Path) -> None:
    """Copy the pictures, those of failures too."""
    out.mkdir(parents=True, exist_ok=True)
    for older in out.glob("*.png"):
        older.unlink()
    for picture in sorted((work / scene.SCREENSHOTS).glob("*.png")):
        shutil.copy(picture, out)


def check_saved_mesh(work: Path) -> None:
    """Read the result back by PyMeshLab. Raises AssertionError with what is not so."""
    document = read_document(work / scene.SAVED_MESH)
    mesh = document.current_mesh()
    assert mesh.vertex_number() == scene.TARGET, mesh.vertex_number()
    topology = document.get_topological_measures()
    assert topology["genus"] == 0, topology
    assert topology["number_holes"] == 0, topology
    assert topology["connected_components_number"] == 1, topology
    print(f"read back by PyMeshLab: {mesh.vertex_number()} vertices, genus 0, closed")


def check_kept_cloud(work: Path) -> None:
    """Compare the layer that was refused, as saved afterwards, with the file it came from."""
    assert np.array_equal(vertices(work / scene.KEPT_CLOUD), vertices(work / scene.FEW))
    print("read back by PyMeshLab: the layer that was refused is as it was")


def vertices(path: Path) -> np.ndarray:
    """Return the vertices of a file, shape (n, 3)."""
    points, _ = arrays_of(read_document(path))
    return points


if __name__ == "__main__":
    sys.exit(main())
