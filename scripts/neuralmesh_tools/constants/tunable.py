# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes constants of a source file variables that the environment sets when the program starts.

So a file with twenty constants is compiled once, not forty times.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from neuralmesh_tools.constants.source import Constant

_NUMBER = re.compile(r"-?[\d.]+(?:e-?\d+)?")
_READ = """\
#include <cstdlib>
static double valueFromEnvironment(const char *name, double otherwise)
{
    const char *const text = std::getenv(name);
    return text ? std::atof(text) : otherwise;
}
"""


def is_tunable(constant: Constant, values: Iterable[str]) -> bool:
    """Whether the constant is in a source file of its own and its values are plain numbers."""
    return constant.file.endswith(".cpp") and all(
        _NUMBER.fullmatch(value) for value in (constant.value, *values)
    )


def with_variables(text: str, constants: Iterable[Constant]) -> str:
    """Return the text of a file whose constants of these names are read from the environment."""
    for constant in constants:
        pattern = rf"constexpr ([\w:]+) {constant.name} = {re.escape(constant.value)};"
        read = rf'valueFromEnvironment("{constant.name}", {constant.value})'
        text, count = re.subn(
            pattern, rf"const \1 {constant.name} = static_cast<\1>({read});", text
        )
        assert count == 1, constant.name
    return _READ + text
