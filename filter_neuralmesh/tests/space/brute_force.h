// SPDX-License-Identifier: GPL-3.0-or-later
// What indices of points are compared with.
#pragma once

#include <map>

#include "core/mesh/neural_mesh.h"
#include "neuralmesh/random.h"

namespace neuralmesh {

using Positions = std::map<VertexId, Point3>;

/// Every point looked at, ties to the lowest id.
inline VertexId nearestByBruteForce(const Positions &positions, const Point3 &query)
{
    VertexId best = noVertex;
    Scalar least = 0;
    for (const auto &[id, position] : positions) {
        const Scalar d = (position - query).SquaredNorm();
        if (best == noVertex || d < least) {
            best = id;
            least = d;
        }
    }
    return best;
}

inline int countWithin(const Positions &positions, const Point3 &query, Scalar radius)
{
    int count = 0;
    for (const auto &[id, position] : positions)
        count += (position - query).SquaredNorm() <= radius * radius ? 1 : 0;
    return count;
}

inline Box3 box(const Point3 &low, const Point3 &high)
{
    Box3 b;
    b.Add(low);
    b.Add(high);
    return b;
}

/// Points in and around the box, a part of them on a coarse lattice so that ties occur.
inline Point3 randomPoint(Random &random, const Box3 &bounds)
{
    Point3 p;
    const bool onLattice = random.below(4) == 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double along = onLattice ? static_cast<double>(random.below(9)) / 8 : random.unit();
        p[axis] = bounds.min[axis] + (1.4 * along - 0.2) * bounds.Dim()[axis];
    }
    return p;
}

} // namespace neuralmesh
