# SPDX-License-Identifier: GPL-3.0-or-later
"""`python -m neuralmesh` is the command `neuralmesh`."""

import sys

from .command import main

sys.exit(main())
