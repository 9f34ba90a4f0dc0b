# SPDX-License-Identifier: GPL-3.0-or-later
"""The constants of the core and the samplers: where they are, what half and double would do."""
