// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/hole_filling.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/loop_triangulation.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/triangle.h"

namespace neuralmesh {
namespace {

/// Corners of the longest loop that is triangulated as a whole, which takes their number cubed.
constexpr std::size_t longestLoop = 300;

constexpr double impossible = std::numeric_limits<double>::infinity();

class HoleFilling {
public:
    /// `rim` runs with the hole to its left.
    HoleFilling(const NeuralMesh &mesh, const std::vector<VertexId> &rim) : mesh_(mesh), rim_(rim)
    {
    }

    /// Empty where there is none.
    std::vector<LoopTriangle> triangles()
    {
        std::vector<int> corners(rim_.size());
        std::iota(corners.begin(), corners.end(), 0);
        while (corners.size() > longestLoop)
            if (!cutShortestCorner(corners))
                return {};
        const LoopTriangulation inner =
            triangulateLoop(static_cast<int>(corners.size()), [&](int i, int j, int k) {
                return weight(corners[static_cast<std::size_t>(i)],
                              corners[static_cast<std::size_t>(j)],
                              corners[static_cast<std::size_t>(k)]);
            });
        if (inner.triangles.empty())
            return {};
        for (const LoopTriangle &t : inner.triangles)
            cut_.push_back({corners[static_cast<std::size_t>(t[0])],
                            corners[static_cast<std::size_t>(t[1])],
                            corners[static_cast<std::size_t>(t[2])]});
        return std::move(cut_);
    }

private:
    VertexId at(int place) const { return rim_[static_cast<std::size_t>(place)]; }

    bool areAdjacent(int i, int j) const
    {
        const int size = static_cast<int>(rim_.size());
        return (i + 1) % size == j || (j + 1) % size == i;
    }

    /// Whether the diagonal is an edge of the mesh already.
    bool isTaken(int i, int j) const
    {
        return !areAdjacent(i, j) && mesh_.ring(at(i)).contains(at(j));
    }

    double weight(int i, int j, int k) const
    {
        if (isTaken(i, j) || isTaken(j, k) || isTaken(k, i))
            return impossible;
        return area(Triangle{mesh_.position(at(i)), mesh_.position(at(j)), mesh_.position(at(k))});
    }

    /// Cuts off the corner whose neighbours are nearest to each other.
    bool cutShortestCorner(std::vector<int> &corners)
    {
        const std::size_t size = corners.size();
        double shortest = impossible;
        std::size_t best = size;
        for (std::size_t i = 0; i < size; ++i) {
            const int before = corners[(i + size - 1) % size];
            const int after = corners[(i + 1) % size];
            const double length =
                (mesh_.position(at(before)) - mesh_.position(at(after))).SquaredNorm();
            if (length < shortest && !isTaken(before, after)) {
                shortest = length;
                best = i;
            }
        }
        if (best == size)
            return false;
        LoopTriangle corner{corners[(best + size - 1) % size], corners[best],
                            corners[(best + 1) % size]};
        std::sort(corner.begin(), corner.end());
        cut_.push_back(corner);
        corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(best));
        return true;
    }

    const NeuralMesh &mesh_;
    const std::vector<VertexId> &rim_;
    std::vector<LoopTriangle> cut_;
};

/// Fills the boundaries whose filling `isHole(loop, area)`.
template <class IsHole> int fillThose(NeuralMesh &mesh, const IsHole &isHole)
{
    int filled = 0;
    for (std::vector<VertexId> &loop : boundaryLoops(mesh)) {
        std::reverse(loop.begin(), loop.end()); // the hole to its left
        const std::vector<LoopTriangle> triangles = HoleFilling(mesh, loop).triangles();
        double filling = 0;
        for (const LoopTriangle &t : triangles)
            filling += area(Triangle{mesh.position(loop[static_cast<std::size_t>(t[0])]),
                                     mesh.position(loop[static_cast<std::size_t>(t[1])]),
                                     mesh.position(loop[static_cast<std::size_t>(t[2])])});
        if (triangles.empty() || !isHole(loop.front(), filling))
            continue;
        refillDisc(mesh, loop, {}, triangles);
        ++filled;
    }
    return filled;
}

/// By vertex, the area of its component.
std::vector<double> areasOfComponents(const NeuralMesh &mesh)
{
    const std::vector<int> label = labelComponents(mesh);
    std::vector<double> sums(label.size(), 0);
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        sums[static_cast<std::size_t>(label[a])] +=
            area(Triangle{mesh.position(a), mesh.position(b), mesh.position(c)});
    });
    std::vector<double> ofVertex(label.size(), 0);
    for (std::size_t v = 0; v < label.size(); ++v)
        if (label[v] >= 0)
            ofVertex[v] = sums[static_cast<std::size_t>(label[v])];
    return ofVertex;
}

/// Of the component's area, at the most, that the filling of a hole in it may have.
constexpr double mostOfComponent = 1.0 / 3;

} // namespace

int fillHoles(NeuralMesh &mesh)
{
    return fillThose(mesh, [](VertexId, double) { return true; });
}

int fillHolesUpTo(NeuralMesh &mesh, double largestArea)
{
    const std::vector<double> componentArea = areasOfComponents(mesh);
    return fillThose(mesh, [&](VertexId v, double filling) {
        return filling <= largestArea && filling < mostOfComponent * componentArea[v];
    });
}

} // namespace neuralmesh
