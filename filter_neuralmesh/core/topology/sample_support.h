// SPDX-License-Identifier: GPL-3.0-or-later
// Where the target space is: a set of its samples that can be asked for the nearest.
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"
#include "core/parallel/watch.h"
#include "core/space/point_grid.h"

namespace neuralmesh {

/// The place of a sample among those of a support.
using SampleId = VertexId;

class SampleSupport {
public:
    /// Needs at least one sample. Where even all points of the target space are sparse, `widening`
    /// makes up for it.
    SampleSupport(const Box3 &bounds, const std::vector<Point3> &samples, Scalar widening = 1,
                  const Watch &watch = {});

    /// Whether a sample lies within the radius, times the widening.
    bool hasWithin(const Point3 &place, Scalar radius) const;

    /// Whether so many samples lie within the radius, whatever the widening.
    bool hasWithin(const Point3 &place, Scalar radius, int count) const
    {
        return grid_.hasWithin(place, radius, count);
    }

    /// Most samples are within.
    const Box3 &bounds() const { return bounds_; }

    const std::vector<Point3> &samples() const { return samples_; }

    /// Calls visit(id) for each sample within the radius.
    template <class Visit>
    void forEachWithin(const Point3 &place, Scalar radius, const Visit &visit) const
    {
        grid_.forEachWithin(place, radius, visit);
    }

    /// Where work that asks for many places looks.
    const Watch &watch() const { return watch_; }

    SampleId nearestId(const Point3 &place) const { return grid_.nearest(place); }
    const Point3 &nearest(const Point3 &place) const { return samples_[nearestId(place)]; }
    Scalar squaredDistance(const Point3 &place) const
    {
        return (nearest(place) - place).SquaredNorm();
    }

private:
    Box3 bounds_;
    std::vector<Point3> samples_;
    PointGrid grid_;
    Scalar widening_;
    Watch watch_;
};

} // namespace neuralmesh
