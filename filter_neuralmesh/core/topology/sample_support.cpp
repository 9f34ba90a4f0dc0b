// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/sample_support.h"

namespace neuralmesh {

SampleSupport::SampleSupport(const Box3 &bounds, const std::vector<Point3> &samples,
                             Scalar widening)
    : samples_(samples), grid_(bounds), widening_(widening)
{
    for (std::size_t i = 0; i < samples_.size(); ++i)
        grid_.insert(static_cast<VertexId>(i), samples_[i]);
}

bool SampleSupport::hasWithin(const Point3 &place, Scalar radius) const
{
    return grid_.hasWithin(place, widening_ * radius);
}

} // namespace neuralmesh
