# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds a C++ program with one source file changed, beside the build that is there.

The changed text never enters the checkout: it is compiled from a folder of its own by the very
commands of the build, and the program is linked again with the new object files in place of the
old ones. That takes seconds, where a copy of the tree would be built from nothing.
"""

from __future__ import annotations

import shlex
import subprocess
from collections.abc import Sequence
from pathlib import Path

TESTS = "filter_neuralmesh/tests/neuralmesh_tests"
INCLUDED_FROM = Path("filter_neuralmesh")  # what "core/..." is relative to
PRECOMPILED = ".gch"  # how the name of a precompiled header ends


class BuildFailed(RuntimeError):
    """A command of the build failed; the message holds its output."""


class Stale(RuntimeError):
    """A change no longer fits the source; the message says which and why."""


def changed_text(root: Path, path: str, text: str, replacement: str, name: str) -> str:
    """Return what a file holds with a text, which stands in it exactly once, replaced.

    Raises Stale, naming the change, if the file is not there or does not hold the text once.
    """
    file = root / path
    if not file.is_file():
        raise Stale(f"{name}: there is no {path}; its text has moved.")
    source = file.read_text(encoding="utf-8")
    if (count := source.count(text)) != 1:
        raise Stale(f"{name}: {path} holds its text {count} times, not once.")
    return source.replace(text, replacement)


class BuiltProgram:
    """The build of a C++ program in a folder that cmake and Ninja have filled."""

    def __init__(self, root: Path, folder: Path, program: str = TESTS) -> None:
        """Bring the build in `folder` of the checkout `root` up to date, and learn its commands.

        `program` is the executable's path in the folder. Its name is its target's.
        """
        self._root = root
        self.folder = folder
        self._program = program
        self._target = Path(program).name
        if not (folder / "build.ninja").is_file():
            raise BuildFailed(f"{folder} holds no build: run scripts/build release")
        self._ninja(self._target)
        self._commands = self._ninja("-t", "commands", self._target).splitlines()
        self._dependents = self._read_dependents(self._ninja("-t", "deps"))

    @property
    def executable(self) -> Path:
        """The program as it is, without any change."""
        return self.folder / self._program

    def with_change(self, file: str, text: str, scratch: Path) -> Path:
        """Return the program built with other text in a file (from the root, .h or .cpp).

        scratch is an empty folder that takes all that is made.
        """
        changed = scratch / Path(file).relative_to(INCLUDED_FROM)
        changed.parent.mkdir(parents=True)
        changed.write_text(text, encoding="utf-8")
        dependents = self._dependents.get((self._root / file).resolve(), [])
        is_precompiled = any(old.endswith(PRECOMPILED) for old in dependents)
        objects: dict[str, Path] = {}
        for number, old in enumerate(old for old in dependents if not old.endswith(PRECOMPILED)):
            objects[old] = scratch / f"{number}.o"
            words = self._words_to_compile(old, objects[old], file, changed, scratch)
            if is_precompiled:  # a precompiled header holds the file as it was
                del words[words.index("-include") : words.index("-include") + 2]
            _run(words, self.folder)
        if not objects:
            raise BuildFailed(f"no object of {self._target} depends on {file}")
        return self._link(objects, scratch)

    def _words_to_compile(
        self, old: str, new: Path, file: str, changed: Path, scratch: Path
    ) -> list[str]:
        # A mutant may leave something unused: that is no error in it.
        words = [w for w in shlex.split(self._only_command(f" -o {old} -c ")) if w != "-Werror"]
        source = str(self._root / file)
        words = [str(changed) if word == source else word.replace(old, str(new)) for word in words]
        place = next(i for i, word in enumerate(words) if word.startswith("-I"))
        words.insert(place, f"-I{scratch}")
        return words

    def _link(self, objects: dict[str, Path], scratch: Path) -> Path:
        linked = scratch / self._target
        commands = self._only_command(f" -o {self._program} ").split(" && ")
        words = shlex.split(next(c for c in commands if f" -o {self._program} " in c))
        words = [str(objects.pop(word)) if word in objects else word for word in words]
        # An object file that is given goes before a member of a library with the same symbols.
        place = words.index("-o")
        words[place : place + 2] = [*map(str, objects.values()), "-o", str(linked)]
        _run(words, self.folder)
        return linked

    def _only_command(self, part: str) -> str:
        found = [command for command in self._commands if part in command]
        if len(found) != 1:
            raise BuildFailed(f"{len(found)} commands of the build have {part!r}, not one")
        return found[0]

    def _ninja(self, *arguments: str) -> str:
        return _run(["ninja", *arguments], self.folder)

    def _read_dependents(self, listing: str) -> dict[Path, list[str]]:
        """Read `ninja -t deps`: an object, and below it, indented, the files that it came from."""
        mine = set(_objects_of(self._commands))
        dependents: dict[Path, list[str]] = {}
        current = ""
        for line in listing.splitlines():
            if line.startswith(" "):
                path = (self.folder / line.strip()).resolve()
                if current and path.is_relative_to(self._root.resolve()):
                    dependents.setdefault(path, []).append(current)
            else:
                name = line.partition(":")[0]
                current = name if name in mine else ""
        return dependents


def _objects_of(commands: Sequence[str]) -> list[str]:
    words = [shlex.split(command) for command in commands if " -c " in command]
    return [line[line.index("-o") + 1] for line in words if "-o" in line]


def _run(command: Sequence[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BuildFailed(f"{shlex.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout
