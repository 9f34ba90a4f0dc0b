// SPDX-License-Identifier: GPL-3.0-or-later
// Points that can be asked for those near a place.
#pragma once

#include <vector>

#include "core/space/point_grid.h"

namespace neuralmesh {

/// Refers to the points, which have to stay.
class PointIndex {
public:
    PointIndex(const std::vector<Point3> &points) : points_(points), grid_(boundsOf(points), points)
    {
    }

    const std::vector<Point3> &points() const { return points_; }

    /// Whether a point lies within the radius.
    bool hasWithin(const Point3 &place, double radius) const
    {
        return grid_.hasWithin(place, static_cast<Scalar>(radius));
    }

    /// Calls visit(point) for each point within the radius.
    template <class Visit>
    void forEachWithin(const Point3 &place, double radius, const Visit &visit) const
    {
        forEachIndexWithin(place, radius, [&](std::size_t i) { visit(points_[i]); });
    }

    /// Calls visit(index) for each of them.
    template <class Visit>
    void forEachIndexWithin(const Point3 &place, double radius, const Visit &visit) const
    {
        grid_.forEachWithin(place, static_cast<Scalar>(radius), [&](VertexId id) { visit(id); });
    }

private:
    static Box3 boundsOf(const std::vector<Point3> &points)
    {
        Box3 bounds;
        for (const Point3 &p : points)
            bounds.Add(p);
        return bounds;
    }

    const std::vector<Point3> &points_;
    PointGrid grid_;
};

} // namespace neuralmesh
