# SPDX-License-Identifier: GPL-3.0-or-later
"""All mutants, in the order in which they are tried."""

from __future__ import annotations

from neuralmesh_tools.mutants.catalogue_closing import CLOSING
from neuralmesh_tools.mutants.catalogue_field import FIELD
from neuralmesh_tools.mutants.catalogue_growth import GROWTH
from neuralmesh_tools.mutants.catalogue_samplers import SAMPLERS
from neuralmesh_tools.mutants.catalogue_shape import SHAPE
from neuralmesh_tools.mutants.catalogue_webs import WEBS
from neuralmesh_tools.mutants.mutant import Mutant

MUTANTS: tuple[Mutant, ...] = GROWTH + WEBS + FIELD + SHAPE + CLOSING + SAMPLERS
