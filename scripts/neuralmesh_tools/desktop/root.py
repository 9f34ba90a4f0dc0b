# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the Debian root in which the real MeshLab runs, once, in the cache; prints its path.

Debian's unstable has MeshLab 2025.07, whatever release this machine runs, and the machine's own
mirror has Debian's unstable. Exit codes: 0 the path is on standard output; 77 no root can be made
here, and standard error says why; 1 making it failed.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

from neuralmesh_tools.project import cache_root

MESHLAB_VERSION = "2025.07"
CANNOT = 77

# MeshLab itself; what its plugins recommend, without which it passes the user's plugins over; a
# screen, a window manager, keys and clicks, pictures; and the bus on which it tells what it shows.
PACKAGES = (
    *("meshlab", "lib3ds-1-3", "libmuparser2v5", "libopenctm1", "libqhull-r8.0", "libgomp1"),
    *("xvfb", "openbox", "xdotool", "x11-utils", "imagemagick", "libgl1-mesa-dri"),
    *("fonts-dejavu-core", "dbus-daemon", "at-spi2-core", "gir1.2-atspi-2.0"),
    *("python3-gi", "python3-pytest"),
)

# Faster, and smaller: a root that can be made again needs no safe writes and no manuals.
DPKG_OPTIONS = """force-unsafe-io
path-exclude=/usr/share/doc/*
path-exclude=/usr/share/man/*
path-exclude=/usr/share/locale/*
"""


class CannotMakeRoot(Exception):
    """This machine or this user cannot have such a root; the text says why."""


def main() -> int:
    """Print the path of the root, which is made if need be."""
    try:
        print(desktop_root())
    except CannotMakeRoot as reason:
        print(f"test_desktop: skipped: {reason}", file=sys.stderr)
        return CANNOT
    except subprocess.CalledProcessError as failure:
        print(f"test_desktop: {failure}", file=sys.stderr)
        return 1
    return 0


def desktop_root() -> Path:
    """Return the cached root; make it, aside and then moved into place, where there is none."""
    recipe = hashlib.sha256(repr((PACKAGES, DPKG_OPTIONS)).encode()).hexdigest()[:8]
    cache = cache_root()
    root = cache / f"desktop-sid-{recipe}"
    check_machine()
    cache.mkdir(parents=True, exist_ok=True)
    with (cache / "desktop.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # two runs at once make one root
        if not root.is_dir():
            make_root(root)
    check_version(root)
    return root


def check_machine() -> None:
    """Raise CannotMakeRoot where this process cannot make roots and enter them."""
    if os.geteuid() != 0:
        raise CannotMakeRoot("only root can make and enter the Debian root with MeshLab.")
    if shutil.which("debootstrap") is None:
        raise CannotMakeRoot("debootstrap is not installed.")
    probe = ["unshare", "--mount", "--pid", "--net", "--fork", "true"]
    if subprocess.run(probe, capture_output=True, check=False).returncode != 0:
        raise CannotMakeRoot("this machine allows no namespaces (`unshare --mount --pid --net`).")


def debian_mirror() -> str:
    """Return the address from which this machine itself takes its packages."""
    query = ["apt-get", "indextargets", "--format", "$(REPO_URI)"]
    lines = subprocess.run(query, capture_output=True, text=True, check=True).stdout.splitlines()
    for line in lines:
        if "debian" in line.lower() and "security" not in line.lower():
            return line
    raise CannotMakeRoot("no Debian mirror is among this machine's package sources.")


def make_root(root: Path) -> None:
    """Install everything into `root`; a failed or interrupted run leaves nothing there."""
    print("test_desktop: making a Debian root with MeshLab, once", file=sys.stderr)
    mirror = debian_mirror()
    part = root.with_suffix(".part")
    shutil.rmtree(part, ignore_errors=True)  # of a run that was killed
    try:
        run(["debootstrap", "--variant=minbase", "sid", str(part), mirror])
        (part / "etc/dpkg/dpkg.cfg.d/test-root").write_text(DPKG_OPTIONS, encoding="utf-8")
        inside(
            "apt-get", "-qq", "install", "--yes", "--no-install-recommends", *PACKAGES, root=part
        )
        inside("apt-get", "clean", root=part)
        for place in ("work", "tests"):
            (part / place).mkdir()
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise
    part.rename(root)
    for older in root.parent.glob("desktop-sid-*"):
        if older != root:
            shutil.rmtree(older, ignore_errors=True)


def inside(*command: str, root: Path) -> None:
    """Run a command in the root, in namespaces that end with it: no mount or process stays."""
    enter = 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec chroot "$0" "$@"'
    alone = ["unshare", "--mount", "--pid", "--fork", "--kill-child"]
    run([*alone, "sh", "-c", enter, str(root), *command])


def run(command: list[str]) -> None:
    """Run a command; its output is shown only if it fails, which raises CalledProcessError."""
    environment = os.environ | {"DEBIAN_FRONTEND": "noninteractive", "LC_ALL": "C.UTF-8"}
    done = subprocess.run(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )
    if done.returncode != 0:
        sys.stderr.buffer.write(done.stdout[-4000:])
        raise subprocess.CalledProcessError(done.returncode, command)


def check_version(root: Path) -> None:
    """Raise CannotMakeRoot if Debian's unstable has gone on to another MeshLab."""
    query = ["chroot", str(root), "dpkg-query", "-W", "-f", "${Version}", "meshlab"]
    version = subprocess.run(query, capture_output=True, text=True, check=True).stdout
    if not version.startswith(MESHLAB_VERSION):
        raise CannotMakeRoot(f"Debian's unstable has MeshLab {version}, not {MESHLAB_VERSION}.")


if __name__ == "__main__":
    sys.exit(main())
