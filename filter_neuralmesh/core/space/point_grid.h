// SPDX-License-Identifier: GPL-3.0-or-later
// A nearest-neighbour index of points that stay where they are.
//
// A uniform grid, as of vertices that move (vertex_grid.h), but made at once by a counting sort:
// the points of a row of cells follow each other in memory, so that a search reads a few runs of
// them where lists would be a cache line a point. To make it anew costs less than a search for each
// point. Where points crowd, as around a laser scanner that sees far, or at the centre of heavy
// tails, one size of cells fits none of them: there a tree takes the place of the cells.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/space/grid_cells.h"

namespace neuralmesh {

class BoxTree;

class PointGrid {
public:
    struct Entry {
        Point3 position;
        VertexId id;
    };

    struct Candidate {
        Scalar squaredDistance;
        VertexId id;
    };

    /// Of points whose ids are their places in the list. Most of them should lie within the bounds;
    /// others cost time, but no exactness.
    PointGrid(const Box3 &bounds, const std::vector<Point3> &points);
    /// Of points by any ids.
    PointGrid(const Box3 &bounds, std::vector<Entry> entries);

    /// The mean over all cells that hold any.
    double pointsInCell() const { return pointsInCell_; }
    /// Whether they crowd in cells, and a tree has them.
    bool isCrowded() const { return tree_ != nullptr; }

    /// The point nearest to the query, the lowest id of several at the same distance, or noVertex
    /// where there is none.
    VertexId nearest(const Point3 &query) const;

    /// The same where a point is known that may be it, with its squared distance.
    VertexId nearest(const Point3 &query, Candidate known) const;

    /// Whether at least `count` points lie within the radius, the border included.
    bool hasWithin(const Point3 &query, Scalar radius, int count = 1) const;

    /// Squared distance of the nearest point that is not left out by isLeftOut(id); that of the
    /// radius where none is within.
    template <class IsLeftOut>
    Scalar squaredClearance(const Point3 &query, Scalar radius, const IsLeftOut &isLeftOut) const
    {
        Scalar least = radius * radius;
        forEachRun(query, radius, [&](const Entry *first, const Entry *end) {
            for (; first != end; ++first)
                if (const Scalar d = (first->position - query).SquaredNorm();
                    d < least && !isLeftOut(first->id))
                    least = d;
            return true;
        });
        return least;
    }

    /// Calls visit(id) for each point within the radius, the border included.
    template <class Visit>
    void forEachWithin(const Point3 &query, Scalar radius, const Visit &visit) const
    {
        const Scalar squaredRadius = radius * radius;
        forEachRun(query, radius, [&](const Entry *first, const Entry *end) {
            for (; first != end; ++first)
                if ((first->position - query).SquaredNorm() <= squaredRadius)
                    visit(first->id);
            return true;
        });
    }

private:
    /// Cells for each point, unless those that hold any then hold more than the latter in the mean;
    /// but never more than the last for each point, which take twice the memory of the point.
    static constexpr std::size_t cellsPerPoint = 2;
    static constexpr double mostInCell = 4;
    static constexpr std::size_t mostCellsPerPoint = 16;
    /// Points crowd where so many others share the cell of one, in the mean over all.
    static constexpr double mostBeside = 30;

    void sortIntoCells();
    /// Counts the points of each cell, and sets their means.
    void countInCells();
    void makeTree();
    std::size_t cellOf(const Point3 &place) const { return placeOf(cells_.at(place)); }
    std::size_t placeOf(const GridCells::Cell &c) const
    {
        return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(cells_.y()) +
                static_cast<std::size_t>(c.y)) *
                   static_cast<std::size_t>(cells_.x()) +
               static_cast<std::size_t>(c.x);
    }

    /// Calls take(first, end) for runs of entries among which are all those within the radius,
    /// until it returns false.
    template <class Take>
    void forEachRun(const Point3 &query, Scalar radius, const Take &take) const
    {
        if (isCrowded())
            return forEachOfTree(query, radius, std::ref(take));
        const GridCells::Cell low = cells_.at(query - Point3(radius, radius, radius));
        const GridCells::Cell high = cells_.at(query + Point3(radius, radius, radius));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) {
                const std::size_t row = placeOf({0, y, z});
                const Entry *first =
                    entries_.data() + starts_[row + static_cast<std::size_t>(low.x)];
                const Entry *end =
                    entries_.data() + starts_[row + static_cast<std::size_t>(high.x) + 1];
                if (first != end && !take(first, end))
                    return;
            }
    }

    /// The same, each entry a run of its own.
    using TakeRun = std::function<bool(const Entry *first, const Entry *end)>;
    void forEachOfTree(const Point3 &query, Scalar radius, const TakeRun &take) const;

    VertexId nearestInTree(const Point3 &query, Candidate best) const;
    void improve(const Point3 &query, Scalar radius, Candidate &best) const;

    GridCells cells_;
    double pointsInCell_ = 0;
    double pointsBeside_ = 0;             ///< one in its cell, in the mean over all
    std::vector<Entry> entries_;          ///< row by row
    std::vector<std::uint32_t> starts_;   ///< of each cell's entries; one more, for their end
    std::shared_ptr<const BoxTree> tree_; ///< of the entries, where they crowd
};

} // namespace neuralmesh
