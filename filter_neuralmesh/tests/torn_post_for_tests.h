// SPDX-License-Identifier: GPL-3.0-or-later
// A post that a coarse network tore: two halves, each closed, and a strand that joins them.
#pragma once

#include <cmath>
#include <vector>

#include "core/mesh/ring_surgery.h"
#include "core/topology/sample_support.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh::test {

/// Of the post, which has radius 1.
constexpr VertexId sides = 8;
/// Vertices of a half.
constexpr VertexId perPart = 3 * sides + 2;

/// One half of a torn post: three levels of a prism, closed at both ends by fans. `sign` is 1 for
/// the upper and -1 for the lower half.
///
///      _______   z = 2.5
///     |       |
///     |_______|  z = 0.5, the stump
///      _______
///     |       |  z = -0.5, the other stump
///     |_______|  z = -2.5
inline void addHalf(std::vector<Point3> &points, std::vector<Triangle> &faces, int sign)
{
    const auto first = static_cast<VertexId>(points.size());
    for (int level = 1; level <= 3; ++level)
        for (VertexId k = 0; k < sides; ++k) {
            const Scalar angle = 2 * M_PI * k / sides;
            points.emplace_back(std::cos(angle), std::sin(angle), sign * (level - 0.5));
        }
    points.emplace_back(0, 0, 0.5 * sign);
    points.emplace_back(0, 0, 2.5 * sign);
    const auto at = [&](VertexId level, VertexId k) { return first + level * sides + k % sides; };
    const auto add = [&](VertexId a, VertexId b, VertexId c) {
        faces.push_back(sign > 0 ? Triangle{a, b, c} : Triangle{a, c, b});
    };
    for (VertexId k = 0; k < sides; ++k) {
        for (VertexId level = 0; level < 2; ++level) {
            add(at(level, k), at(level, k + 1), at(level + 1, k + 1));
            add(at(level, k), at(level + 1, k + 1), at(level + 1, k));
        }
        add(first + 3 * sides, at(0, k + 1), at(0, k));
        add(first + 3 * sides + 1, at(2, k), at(2, k + 1));
    }
}

/// A face of the mesh that has these corners, as a rim.
inline std::vector<VertexId> rimOf(VertexId a, VertexId b, VertexId c)
{
    return {a, b, c};
}

/// The torn post, its halves joined by a strand of triangular section far up and down its wall.
inline void makeTornPost(NeuralMesh &mesh)
{
    std::vector<Point3> points;
    std::vector<Triangle> faces;
    addHalf(points, faces, 1);
    addHalf(points, faces, -1);
    makeMesh(mesh, points, faces);
    const VertexId up = sides;
    const VertexId down = perPart + sides;
    bridgeDiscs(mesh, rimOf(up, up + 1, up + sides + 1), rimOf(down, down + sides + 1, down + 1),
                {{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 1}, {0, 1}});
}

/// All over the whole post, the missing part of its wall included; or without that, on both stumps.
inline std::vector<Point3> samplesOfPost(bool withWall)
{
    std::vector<Point3> samples;
    constexpr int around = 48;
    for (int i = 0; i < around; ++i) {
        const Scalar angle = 2 * M_PI * i / around;
        for (int z = -25; z <= 25; ++z)
            if (withWall || std::abs(z) >= 5)
                samples.emplace_back(std::cos(angle), std::sin(angle), z / 10.0);
        for (int r = 0; r < 10; ++r)
            for (const Scalar z : withWall ? std::vector<Scalar>{-2.5, 2.5}
                                           : std::vector<Scalar>{-2.5, -0.5, 0.5, 2.5})
                samples.emplace_back(r / 10.0 * std::cos(angle), r / 10.0 * std::sin(angle), z);
    }
    return samples;
}

inline SampleSupport supportOfPost(bool withWall)
{
    const std::vector<Point3> samples = samplesOfPost(withWall);
    Box3 bounds;
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    return SampleSupport(bounds, samples);
}

} // namespace neuralmesh::test
