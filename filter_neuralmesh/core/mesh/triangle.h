// SPDX-License-Identifier: GPL-3.0-or-later
// Shape of a single triangle.
#pragma once

#include <algorithm>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

struct Triangle {
    const Point3 &a;
    const Point3 &b;
    const Point3 &c;
};

/// Zero where the triangle has no area.
inline Point3 unitNormal(const Triangle &t)
{
    return ((t.b - t.a) ^ (t.c - t.a)).Normalize();
}

inline Scalar area(const Triangle &t)
{
    return ((t.b - t.a) ^ (t.c - t.a)).Norm() / 2;
}

inline Scalar cosineAt(const Point3 &corner, const Point3 &left, const Point3 &right)
{
    return (left - corner).Normalize() * (right - corner).Normalize();
}

/// Near 1 where the triangle is a sliver, 0.5 where it is equilateral.
inline Scalar cosineOfSmallestAngle(const Triangle &t)
{
    return std::max({cosineAt(t.a, t.b, t.c), cosineAt(t.b, t.c, t.a), cosineAt(t.c, t.a, t.b)});
}

} // namespace neuralmesh
