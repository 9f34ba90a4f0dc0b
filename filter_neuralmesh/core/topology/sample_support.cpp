// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/sample_support.h"

namespace neuralmesh {
namespace {

/// Some milliseconds.
constexpr std::size_t samplesPerLook = 1 << 14;

} // namespace

SampleSupport::SampleSupport(const Box3 &bounds, const std::vector<Point3> &samples,
                             Scalar widening, const Watch &watch)
    : samples_(samples), grid_(bounds), widening_(widening), watch_(watch)
{
    for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (i % samplesPerLook == 0)
            watch_.look();
        grid_.insert(static_cast<VertexId>(i), samples_[i]);
    }
}

bool SampleSupport::hasWithin(const Point3 &place, Scalar radius) const
{
    return grid_.hasWithin(place, widening_ * radius);
}

} // namespace neuralmesh
