// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/marching_tetrahedra.h"

#include <array>
#include <cstddef>

namespace neuralmesh {
namespace {

/// Corners of a cell are numbered by bits: 1 for x, 2 for y, 4 for z. Every tetrahedron goes from
/// corner 0 to corner 7 along three axes, in one of six orders.
struct Tetrahedron {
    std::array<unsigned, 4> corners; ///< of positive volume
};
constexpr Tetrahedron tetrahedra[6] = {{{0, 1, 3, 7}}, {{0, 3, 2, 7}}, {{0, 2, 6, 7}},
                                       {{0, 6, 4, 7}}, {{0, 4, 5, 7}}, {{0, 5, 1, 7}}};

/// Even permutations of a tetrahedron's corners that bring a corner, or two, to the front.
constexpr unsigned alone[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
constexpr unsigned paired[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                   {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};

class Marching {
public:
    explicit Marching(const Grid &f) : f_(f)
    {
        const auto nodes = static_cast<std::size_t>(f.nodesPerAxis());
        for (auto &slice : onSlices_)
            slice.assign(nodes * nodes * 8, noVertex);
    }

    TriangleSoup run()
    {
        const int cells = f_.cells();
        for (int x = 0; x < cells; ++x) {
            for (int y = 0; y < cells; ++y)
                for (int z = 0; z < cells; ++z)
                    marchCell(x, y, z);
            // What lies on the far side of these cells is the near side of the next.
            onSlices_[0].swap(onSlices_[1]);
            onSlices_[1].assign(onSlices_[1].size(), noVertex);
        }
        return std::move(soup_);
    }

private:
    void marchCell(int x, int y, int z)
    {
        bool hasInside = false;
        bool hasOutside = false;
        for (unsigned c = 0; c < 8; ++c) {
            values_[c] = f_.at(x + static_cast<int>(c & 1U), y + static_cast<int>((c >> 1U) & 1U),
                               z + static_cast<int>(c >> 2U));
            (values_[c] > 0 ? hasInside : hasOutside) = true;
        }
        if (!hasInside || !hasOutside)
            return;
        cell_ = {x, y, z};
        for (const Tetrahedron &tetrahedron : tetrahedra)
            marchTetrahedron(tetrahedron.corners);
    }

    void marchTetrahedron(const std::array<unsigned, 4> &corners)
    {
        unsigned insideCount = 0;
        std::array<bool, 4> isInside{};
        for (unsigned i = 0; i < 4; ++i) {
            isInside[i] = values_[corners[i]] > 0;
            insideCount += isInside[i] ? 1 : 0;
        }
        const auto edge = [&](const unsigned(&order)[4], unsigned a, unsigned b) {
            return vertexOn(corners[order[a]], corners[order[b]]);
        };
        if (insideCount == 1 || insideCount == 3) {
            for (const auto &order : alone)
                if (isInside[order[0]] == (insideCount == 1)) {
                    const Corners t{edge(order, 0, 1), edge(order, 0, 2), edge(order, 0, 3)};
                    soup_.faces.push_back(insideCount == 1 ? t : Corners{t[0], t[2], t[1]});
                    return;
                }
        } else if (insideCount == 2) {
            for (const auto &order : paired)
                if (isInside[order[0]] && isInside[order[1]]) {
                    const VertexId quad[4] = {edge(order, 0, 2), edge(order, 0, 3),
                                              edge(order, 1, 3), edge(order, 1, 2)};
                    soup_.faces.push_back({quad[0], quad[1], quad[2]});
                    soup_.faces.push_back({quad[0], quad[2], quad[3]});
                    return;
                }
        }
    }

    /// The vertex on the edge between two corners of the cell, of which one's bits are among the
    /// other's: the lower corner and the direction name it.
    VertexId vertexOn(unsigned a, unsigned b)
    {
        const unsigned low = a & b;
        const unsigned direction = a ^ b;
        const auto nodes = static_cast<std::size_t>(f_.nodesPerAxis());
        const auto y = static_cast<std::size_t>(cell_[1]) + ((low >> 1U) & 1U);
        const auto z = static_cast<std::size_t>(cell_[2]) + (low >> 2U);
        VertexId &vertex = onSlices_[low & 1U][(y * nodes + z) * 8 + direction];
        if (vertex == noVertex) {
            vertex = static_cast<VertexId>(soup_.points.size());
            const double share =
                static_cast<double>(values_[a]) /
                (static_cast<double>(values_[a]) - static_cast<double>(values_[b]));
            soup_.points.push_back((corner(a) * (1 - share) + corner(b) * share) / f_.cells());
        }
        return vertex;
    }

    Point3 corner(unsigned c) const
    {
        return {cell_[0] + static_cast<double>(c & 1U),
                cell_[1] + static_cast<double>((c >> 1U) & 1U),
                cell_[2] + static_cast<double>(c >> 2U)};
    }

    const Grid &f_;
    TriangleSoup soup_;
    std::array<int, 3> cell_{};
    std::array<float, 8> values_{};
    /// Vertices on edges whose lower corner lies on the near, the far slice of the cells.
    std::array<std::vector<VertexId>, 2> onSlices_;
};

} // namespace

TriangleSoup marchTetrahedra(const Grid &f)
{
    return Marching(f).run();
}

} // namespace neuralmesh
