# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m neuralmesh_tools.fuzzing`, which scripts/fuzz calls."""

import sys

from neuralmesh_tools.fuzzing.command_line import main

if __name__ == "__main__":
    sys.exit(main())
