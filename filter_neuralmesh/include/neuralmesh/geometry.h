// SPDX-License-Identifier: GPL-3.0-or-later
// Points, boxes and meshes as everyone has them: arrays of numbers, no library's types.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace neuralmesh {

/// x, y and z.
using Point = std::array<double, 3>;

/// A box along the axes, its faces included.
struct Box {
    Point min;
    Point max;
};

/// An interval, its ends included.
struct Range {
    double low;
    double high;
};

/// Place of a vertex among the vertices of its mesh.
using VertexId = std::uint32_t;

/// Corners of a face, counter-clockwise seen from outside.
using Corners = std::array<VertexId, 3>;

/// A triangle mesh.
struct Mesh {
    std::vector<Point> positions;
    std::vector<Corners> triangles;
};

} // namespace neuralmesh
