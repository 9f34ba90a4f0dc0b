// SPDX-License-Identifier: GPL-3.0-or-later
// Points on shapes of known topology, and functions on grids, that the tests of shapes share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/shape/grid.h"
#include "core/shape/node_spans.h"
#include "neuralmesh/random.h"

namespace neuralmesh::test {

using Points = std::vector<Point3>;

/// Of the unit cube.
inline GridSize cube(int cells)
{
    return {cells, cells, cells};
}

/// Calls visit(x, y, z) for each node.
template <class Visit> void forEachNode(const Grid &grid, const Visit &visit)
{
    for (int x = 0; x <= grid.cells().x; ++x)
        for (int y = 0; y <= grid.cells().y; ++y)
            for (int z = 0; z <= grid.cells().z; ++z)
                visit(x, y, z);
}

/// Whether so many nodes or more lie between this one and the border.
inline bool isInner(const Grid &grid, int x, int y, int z, int margin = 1)
{
    const GridSize &cells = grid.cells();
    return std::min({x, y, z, cells.x - x, cells.y - y, cells.z - z}) >= margin;
}

/// The function's values at the nodes, by their places in the grid's box.
template <class Function> Grid sampled(const GridSize &cells, const Function &function)
{
    Grid grid(cells);
    forEachNode(grid, [&](int x, int y, int z) {
        grid.at(x, y, z) = static_cast<float>(function(Point3(x, y, z) / cells.resolution()));
    });
    return grid;
}

/// Uniform in [-1, 1] at the nodes so far from the border or more.
inline Grid noise(const GridSize &cells, std::uint64_t seed, int margin = 0)
{
    Random random(seed);
    Grid grid(cells);
    forEachNode(grid, [&](int x, int y, int z) {
        if (isInner(grid, x, y, z, margin))
            grid.at(x, y, z) = static_cast<float>(2 * random.unit() - 1);
    });
    return grid;
}

/// By node, 1 for those of the spans and 0 for the others.
inline std::vector<unsigned char> marked(const NodeSpans &nodes, const GridSize &cells)
{
    const Grid grid(cells);
    std::vector<unsigned char> isIn(grid.size(), 0);
    for (int x = 0; x <= cells.x; ++x)
        for (int y = 0; y <= cells.y; ++y)
            nodes.forEachInRow(x, y, [&](int low, int end) {
                for (int z = low; z < end; ++z)
                    ++isIn[grid.index(x, y, z)];
            });
    return isIn;
}

/// Of the values at all nodes, in double precision.
inline double dot(const Grid &a, const Grid &b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
}

/// A standard normal number (Box and Muller).
inline double normalNumber(Random &random)
{
    return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(2 * M_PI * random.unit());
}

inline Points withNoise(Points points, double deviation, std::uint64_t seed)
{
    Random random(seed);
    for (Point3 &p : points)
        p += Point3(normalNumber(random), normalNumber(random), normalNumber(random)) * deviation;
    return points;
}

inline Points moved(Points points, double scale, const Point3 &offset)
{
    for (Point3 &p : points)
        p = p * scale + offset;
    return points;
}

inline Points together(Points points, const Points &others)
{
    points.insert(points.end(), others.begin(), others.end());
    return points;
}

/// Uniform on the torus of these radii around the z axis.
inline Points torusPoints(std::size_t count, double major, double minor, std::uint64_t seed)
{
    Random random(seed);
    Points points;
    while (points.size() < count) {
        const double a = 2 * M_PI * random.unit();
        const double b = 2 * M_PI * random.unit();
        const double r = major + minor * std::cos(b);
        if (random.unit() * (major + minor) < r)
            points.emplace_back(r * std::cos(a), r * std::sin(a), minor * std::sin(b));
    }
    return points;
}

/// The points up to a distance from a segment.
struct Capsule {
    Point3 start, end;
    double radius;

    Point3 nearestOnSegment(const Point3 &p) const
    {
        const Point3 along = end - start;
        const double t = (p - start).dot(along) / along.dot(along);
        return start + along * std::clamp(t, 0.0, 1.0);
    }
    /// Negative inside.
    double distance(const Point3 &p) const { return (p - nearestOnSegment(p)).Norm() - radius; }
};

/// On the border of a union of capsules: uniform in a layer around it, then moved onto it.
inline Points capsulePoints(std::size_t count, const std::vector<Capsule> &capsules,
                            std::uint64_t seed)
{
    constexpr double layer = 0.02;
    Box3 box;
    for (const Capsule &capsule : capsules)
        for (const Point3 &end : {capsule.start, capsule.end}) {
            const double reach = capsule.radius + layer;
            box.Add(end + Point3(reach, reach, reach));
            box.Add(end - Point3(reach, reach, reach));
        }
    Random random(seed);
    Points points;
    while (points.size() < count) {
        const Point3 p(box.min[0] + random.unit() * box.DimX(),
                       box.min[1] + random.unit() * box.DimY(),
                       box.min[2] + random.unit() * box.DimZ());
        const auto nearest = std::min_element(
            capsules.begin(), capsules.end(),
            [&](const Capsule &a, const Capsule &b) { return a.distance(p) < b.distance(p); });
        if (std::abs(nearest->distance(p)) > layer)
            continue;
        const Point3 axis = nearest->nearestOnSegment(p);
        const Point3 moved = axis + (p - axis).Normalize() * nearest->radius;
        const bool isCovered = std::any_of(capsules.begin(), capsules.end(), [&](const Capsule &c) {
            return &c != &*nearest && c.distance(moved) < 0;
        });
        if (!isCovered)
            points.push_back(moved);
    }
    return points;
}

/// Uniform on the border of a union of axis-aligned cubes of a lattice: the solid cubes are those
/// for which isSolid(x, y, z), each index in [0, size).
template <class IsSolid>
Points latticePoints(std::size_t count, int size, const IsSolid &isSolid, std::uint64_t seed)
{
    struct Side {
        int cube[3];
        int axis, direction;
    };
    const auto solid = [&](int x, int y, int z) {
        return std::min({x, y, z}) >= 0 && std::max({x, y, z}) < size && isSolid(x, y, z);
    };
    std::vector<Side> sides;
    for (int x = 0; x < size; ++x)
        for (int y = 0; y < size; ++y)
            for (int z = 0; z < size; ++z)
                for (int axis = 0; axis < 3; ++axis)
                    for (const int d : {-1, 1})
                        if (solid(x, y, z) &&
                            !solid(x + (axis == 0 ? d : 0), y + (axis == 1 ? d : 0),
                                   z + (axis == 2 ? d : 0)))
                            sides.push_back({{x, y, z}, axis, d});
    Random random(seed);
    Points points;
    while (points.size() < count) {
        const Side &side = sides[random.below(sides.size())];
        Point3 p(side.cube[0] + random.unit(), side.cube[1] + random.unit(),
                 side.cube[2] + random.unit());
        p[side.axis] = side.cube[side.axis] + (side.direction > 0 ? 1 : 0);
        points.push_back(p / size);
    }
    return points;
}

/// Over the unit square, at heights height(x, y, random).
template <class Height> Points pointsOverSquare(int count, std::uint64_t seed, Height height)
{
    Random random(seed);
    Points points;
    for (int i = 0; i < count; ++i) {
        const double x = random.unit();
        const double y = random.unit();
        points.emplace_back(x, y, height(x, y, random));
    }
    return points;
}

} // namespace neuralmesh::test
