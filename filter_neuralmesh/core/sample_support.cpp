// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_support.h"

namespace neuralmesh {

SampleSupport::SampleSupport(const Box3 &bounds, const std::vector<Point3> &samples)
    : samples_(samples), grid_(bounds)
{
    for (std::size_t i = 0; i < samples_.size(); ++i)
        grid_.insert(static_cast<VertexId>(i), samples_[i]);
}

bool SampleSupport::hasWithin(const Point3 &place, Scalar radius) const
{
    return grid_.hasWithin(place, radius);
}

} // namespace neuralmesh
