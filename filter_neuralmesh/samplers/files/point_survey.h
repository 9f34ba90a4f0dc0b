// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "neuralmesh/progress.h"
#include "samplers/files/point_layout.h"

namespace neuralmesh {

/// What one pass over all points finds.
struct PointSurvey {
    std::uint64_t looked = 0; ///< records: all, or the first, where time was up
    vcg::Box3d bounds;        ///< in world coordinates; meaningless where a point is not finite
    std::uint64_t notFinite = 0;
    std::uint64_t firstNotFinite = 0; ///< index of a point, where there is one
};

/// One pass over all records, from the first to the last, in constant memory. Throws Cancelled.
/// Where the time is up, ends after some of the first.
PointSurvey surveyPoints(const PointRecords &records, const Progress &progress = {});

} // namespace neuralmesh
