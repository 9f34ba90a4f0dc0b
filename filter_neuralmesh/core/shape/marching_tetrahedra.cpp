// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/marching_tetrahedra.h"

#include <algorithm>
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
    Marching(const Grid &f, float level) : f_(f), level_(level)
    {
        for (Slice &slice : slices_)
            slice.vertices.assign(static_cast<std::size_t>(f.strideX()) * 8, noVertex);
        for (unsigned c = 0; c < 8; ++c)
            steps_[c] = static_cast<std::ptrdiff_t>(c & 1U) * f.strideX() +
                        static_cast<std::ptrdiff_t>((c >> 1U) & 1U) * f.strideY() +
                        static_cast<std::ptrdiff_t>(c >> 2U);
    }

    TriangleSoup run(const std::vector<std::uint32_t> &cells)
    {
        for (const std::uint32_t node : cells)
            marchCell(node);
        return std::move(soup_);
    }

private:
    /// Vertices on edges whose lower corner has a certain x.
    struct Slice {
        std::vector<VertexId> vertices; ///< by place in the slice and direction
        std::vector<std::size_t> used;

        void clear()
        {
            for (const std::size_t i : used)
                vertices[i] = noVertex;
            used.clear();
        }
    };

    void marchCell(std::uint32_t node)
    {
        bool hasInside = false;
        bool hasOutside = false;
        const float *corner = f_.data() + node;
        for (unsigned c = 0; c < 8; ++c) {
            values_[c] = corner[steps_[c]] - level_;
            (values_[c] > 0 ? hasInside : hasOutside) = true;
        }
        if (!hasInside || !hasOutside)
            return;
        const auto i = static_cast<std::ptrdiff_t>(node);
        place_ = static_cast<std::size_t>(i % f_.strideX());
        enterSlice(static_cast<int>(i / f_.strideX()));
        cell_ = {x_, static_cast<int>(i % f_.strideX() / f_.strideY()),
                 static_cast<int>(i % f_.strideY())};
        for (const Tetrahedron &tetrahedron : tetrahedra)
            marchTetrahedron(tetrahedron.corners);
    }

    /// What lies on the far side of a slice of cells is the near side of the next.
    void enterSlice(int x)
    {
        for (; x_ < x && !(slices_[0].used.empty() && slices_[1].used.empty()); ++x_) {
            slices_[0].clear();
            std::swap(slices_[0], slices_[1]);
        }
        x_ = x;
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
        Slice &slice = slices_[low & 1U];
        const std::size_t i =
            (place_ + static_cast<std::size_t>(steps_[low & ~1U])) * 8 + direction;
        VertexId &vertex = slice.vertices[i];
        if (vertex == noVertex) {
            slice.used.push_back(i);
            vertex = static_cast<VertexId>(soup_.points.size());
            const double share =
                static_cast<double>(values_[a]) /
                (static_cast<double>(values_[a]) - static_cast<double>(values_[b]));
            soup_.points.push_back((corner(a) * (1 - share) + corner(b) * share) / f_.resolution());
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
    float level_;
    std::array<std::ptrdiff_t, 8> steps_{}; ///< from a cell's lowest node to its corners
    TriangleSoup soup_;
    std::array<int, 3> cell_{};
    std::size_t place_ = 0; ///< of the cell's lowest node in its slice
    std::array<float, 8> values_{};
    int x_ = 0;                     ///< of the cell
    std::array<Slice, 2> slices_{}; ///< the near, the far side of the cell
};

} // namespace

std::vector<std::uint32_t> cellsBetween(const Grid &f, float low, float high)
{
    const GridSize &size = f.cells();
    const std::ptrdiff_t sx = f.strideX();
    const std::ptrdiff_t sy = f.strideY();
    std::vector<std::uint32_t> cells;
    std::vector<float> least(static_cast<std::size_t>(size.z) + 1);
    std::vector<float> most(least.size());
    for (int x = 0; x < size.x; ++x)
        for (int y = 0; y < size.y; ++y) {
            const std::size_t row = f.index(x, y, 0);
            const float *v = f.data() + row;
            for (int z = 0; z <= size.z; ++z) {
                const auto i = static_cast<std::size_t>(z);
                least[i] = std::min(std::min(v[z], v[z + sy]), std::min(v[z + sx], v[z + sx + sy]));
                most[i] = std::max(std::max(v[z], v[z + sy]), std::max(v[z + sx], v[z + sx + sy]));
            }
            for (std::size_t z = 0; z + 1 < least.size(); ++z)
                if (std::min(least[z], least[z + 1]) <= high &&
                    std::max(most[z], most[z + 1]) > low)
                    cells.push_back(static_cast<std::uint32_t>(row + z));
        }
    return cells;
}

TriangleSoup marchTetrahedra(const Grid &f, float level, const std::vector<std::uint32_t> &cells)
{
    return Marching(f, level).run(cells);
}

} // namespace neuralmesh
