// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes of the input's points, averaged onto the vertices of a result.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "neuralmesh/geometry.h"
#include "neuralmesh/progress.h"

namespace neuralmesh {

/// What a point has: red, green, blue and alpha, and quality, each in units of its own.
using AttributeValues = std::array<double, 5>;

/// Each point counts for the vertex nearest to it, the less the further off it is, so that points
/// far from the surface colour nothing. A vertex that is nearest to none takes the mean of its
/// neighbours.
class AttributeTransfer {
public:
    /// More points than this add nothing that can be seen.
    static constexpr std::size_t pointsPerVertex = 64;

    /// The mesh is one that was reconstructed. It is not needed any more afterwards.
    explicit AttributeTransfer(const Mesh &mesh);
    ~AttributeTransfer();
    AttributeTransfer(AttributeTransfer &&) noexcept;

    /// A point in the mesh's coordinates. Fast where it is near the last one.
    void add(const Point &point, const AttributeValues &values);

    /// Every stride-th of the points, with its values. Throws Cancelled; where time is up, fewer
    /// are looked at.
    void addPoints(const std::vector<Point> &points, const std::vector<AttributeValues> &values,
                   std::size_t stride, const Progress &progress = {});

    /// `count` places uniform by area on the faces of a mesh with an area, with values between
    /// those of their corners, of which there is one for each position. The same at every run.
    /// Throws Cancelled; where time is up, fewer are looked at.
    void addSurface(const Mesh &mesh, const std::vector<AttributeValues> &values, std::size_t count,
                    const Progress &progress = {});

    /// Values of the vertices, in order. Needs at least one point.
    std::vector<AttributeValues> average() const;

private:
    class Vertices;
    std::unique_ptr<Vertices> vertices_;
};

} // namespace neuralmesh
