# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m neuralmesh_tools.mutants`, which scripts/test --mutants calls."""

import sys

from neuralmesh_tools.mutants.command_line import main

if __name__ == "__main__":
    sys.exit(main())
