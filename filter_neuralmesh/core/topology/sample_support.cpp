// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/sample_support.h"

namespace neuralmesh {
SampleSupport::SampleSupport(const Box3 &bounds, const std::vector<Point3> &samples,
                             Scalar widening, const Watch &watch)
    : bounds_(bounds), samples_(samples), grid_(bounds, samples), widening_(widening), watch_(watch)
{
}

bool SampleSupport::hasWithin(const Point3 &place, Scalar radius) const
{
    return grid_.hasWithin(place, widening_ * radius);
}

} // namespace neuralmesh
