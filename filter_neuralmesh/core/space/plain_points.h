// SPDX-License-Identifier: GPL-3.0-or-later
// Between the plain points of the public headers and VCG's, which have arithmetic. Costs nothing:
// both are three doubles.
#pragma once

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/geometry.h"
#include "neuralmesh/unit_frame.h"

namespace neuralmesh {

inline Point3 toVcg(const Point &p)
{
    return {p[0], p[1], p[2]};
}

inline std::vector<Point3> toVcg(const std::vector<Point> &points)
{
    std::vector<Point3> converted;
    converted.reserve(points.size());
    for (const Point &p : points)
        converted.push_back(toVcg(p));
    return converted;
}

inline Box3 toVcg(const Box &box)
{
    return {toVcg(box.min), toVcg(box.max)};
}

inline Point toPlain(const Point3 &p)
{
    return {p.X(), p.Y(), p.Z()};
}

inline Box toPlain(const Box3 &box)
{
    return {toPlain(box.min), toPlain(box.max)};
}

inline Point3 toUnit(const UnitFrame &frame, const Point3 &world)
{
    return toVcg(frame.toUnit(toPlain(world)));
}

inline Point3 toWorld(const UnitFrame &frame, const Point3 &unit)
{
    return toVcg(frame.toWorld(toPlain(unit)));
}

inline Box3 toWorld(const UnitFrame &frame, const Box3 &unit)
{
    return {toWorld(frame, unit.min), toWorld(frame, unit.max)};
}

} // namespace neuralmesh
