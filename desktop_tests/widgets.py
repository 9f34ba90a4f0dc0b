# SPDX-License-Identifier: GPL-3.0-or-later
"""What MeshLab shows, as it tells assistive technology (AT-SPI): windows, labels, fields, lists."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi  # noqa: E402 # the version has to be chosen first
from polling import wait_for  # noqa: E402

# A reply that is lost, as when a window closes, is not waited for as long as at a program's start.
Atspi.set_timeout(2000, 0)


@dataclass(frozen=True)
class Widget:
    """One thing on the screen. Positions are pixels of the screen."""

    accessible: Atspi.Accessible
    role: str
    name: str

    @property
    def showing(self) -> bool:
        """Whether a person sees it: it and all around it is visible."""
        states = self.accessible.get_state_set()
        return states.contains(Atspi.StateType.SHOWING)

    def has(self, state: Atspi.StateType) -> bool:
        """Whether the widget is in a state, such as CHECKED or SELECTED."""
        return self.accessible.get_state_set().contains(state)

    @property
    def box(self) -> tuple[int, int, int, int]:
        """Left, top, width and height."""
        area = self.accessible.get_component_iface().get_extents(Atspi.CoordType.SCREEN)
        return area.x, area.y, area.width, area.height

    @property
    def centre(self) -> tuple[int, int]:
        """The middle, where a person would click."""
        left, top, width, height = self.box
        return left + width // 2, top + height // 2

    @property
    def text(self) -> str:
        """What stands in a text field; the name of anything else."""
        text = self.accessible.get_text_iface()
        if text is None:
            return self.name
        return Atspi.Text.get_text(text, 0, Atspi.Text.get_character_count(text))

    @property
    def help(self) -> str:
        """The tooltip."""
        return self.accessible.get_description()

    def below(self) -> Iterator[Widget]:
        """Yield what shows inside, depth first. Raises GLib.Error if something vanishes."""
        for inner in _children(self):
            if inner.showing:
                yield inner
                yield from inner.below()

    def below_hidden(self, role: str) -> Iterator[Widget]:
        """Yield the widgets of a role inside, such as items of a folded list, seen or not."""
        for inner in _children(self):
            if inner.role == role:
                yield inner
            yield from inner.below_hidden(role)

    def all(self, *roles: str, name: str | None = None) -> list[Widget]:
        """Return what shows inside and has one of the roles and, if given, the name."""
        # A list is true, even with nothing found, once it was read without anything vanishing.
        return wait_for(
            f"the widgets of '{self.name}'",
            lambda: [[w for w in self.below() if w.role in roles and name in (None, w.name)]],
        )[0]

    def first(self, role: str, name: str | None = None) -> Widget | None:
        """Return the first of `all`, or None."""
        return next(iter(self.all(role, name=name)), None)


def _widget(accessible: Atspi.Accessible | None) -> Widget | None:
    if accessible is None:
        return None
    return Widget(accessible, accessible.get_role_name(), accessible.get_name() or "")


def _children(parent: Widget | None) -> Iterator[Widget]:
    if parent is not None:
        for index in range(parent.accessible.get_child_count()):
            child = _widget(parent.accessible.get_child_at_index(index))
            if child is not None:
                yield child


def windows() -> list[Widget]:
    """Return the windows of all programs that tell of themselves; here, MeshLab's."""
    return [
        window
        for program in _children(_widget(Atspi.get_desktop(0)))
        for window in _children(program)
    ]
