// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neuralmesh/progress.h"
#include "samplers/files/point_layout.h"

namespace neuralmesh {

/// What one pass over all points finds.
struct PointSurvey {
    vcg::Box3d bounds; ///< in world coordinates; meaningless where a point is not finite
    std::uint64_t notFinite = 0;
    std::uint64_t firstNotFinite = 0; ///< index of a point, where there is one
};

/// One pass over all records, from the first to the last, in constant memory. Throws Cancelled.
PointSurvey surveyPoints(const PointRecords &records, const Progress &progress = {});

} // namespace neuralmesh
