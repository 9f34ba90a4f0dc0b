// SPDX-License-Identifier: GPL-3.0-or-later
// The dynamic nearest-neighbour index of step 2: a uniform grid that follows moving vertices.
//
// The paper uses an octree. A grid serves better here because the network spreads its vertices
// evenly over the target, so one cell size fits all, and moving within a cell costs a store. A
// surface passes few of the cells: they are made block by block, where there are vertices, so that
// they can be as small as the vertices are dense.
#pragma once

#include <cstdint>
#include <vector>

#include "core/space/grid_cells.h"

namespace neuralmesh {

class VertexGrid {
public:
    /// Cells for each vertex at the time of a rebuild, unless cells then hold more vertices, in the
    /// mean of those that hold any, than the latter; findWinner in bench/bench_steps.cpp times it.
    static constexpr double cellsPerVertex = 4;
    static constexpr double mostInCell = 4;

    /// Points may lie outside the bounds: they go to the outermost cells, where they cost time
    /// but no exactness.
    explicit VertexGrid(const Box3 &bounds);

    void insert(VertexId id, const Point3 &position);
    void move(VertexId id, const Point3 &position);
    void erase(VertexId id);

    bool contains(VertexId id) const { return id < entries_.size() && entries_[id].cell != noCell; }
    std::size_t size() const { return size_; }

    /// The vertex nearest to the query, the lowest id of several at the same distance, or noVertex
    /// in an empty grid. A hint, any vertex that may be near, saves time and changes nothing.
    VertexId nearest(const Point3 &query, VertexId hint = noVertex) const;

    /// Calls visit(id) for each vertex within the radius, the border included.
    template <class Visit>
    void forEachWithin(const Point3 &query, Scalar radius, const Visit &visit) const
    {
        const Cell low = cells_.at(query - Point3(radius, radius, radius));
        const Cell high = cells_.at(query + Point3(radius, radius, radius));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    for (VertexId id = firstIn({x, y, z}); id != noVertex; id = entries_[id].next)
                        if ((entries_[id].position - query).SquaredNorm() <= radius * radius)
                            visit(id);
    }

private:
    using Cell = GridCells::Cell;
    using CellId = std::uint32_t;
    static constexpr CellId noCell = 0xffffffffU;

    /// A vertex in the doubly linked list of its cell. Holds its position so that a search reads
    /// one cache line a vertex.
    struct Entry {
        Point3 position;
        VertexId next = noVertex;
        VertexId previous = noVertex;
        CellId cell = noCell;
    };

    struct Candidate {
        Scalar squaredDistance;
        VertexId id;
    };

    class Shells;

    /// Blocks are cubes of so many cells along each axis.
    static constexpr int blockSide = 4;
    static constexpr std::size_t cellsOfBlock = 64;

    std::size_t blockAt(const Cell &c) const
    {
        const auto of = [](int cell) { return static_cast<std::size_t>(cell / blockSide); };
        return (of(c.z) * blocksY_ + of(c.y)) * blocksX_ + of(c.x);
    }

    static CellId placeInBlock(const Cell &c)
    {
        constexpr int mask = blockSide - 1;
        return static_cast<CellId>(((c.z & mask) * blockSide + (c.y & mask)) * blockSide +
                                   (c.x & mask));
    }

    /// The first vertex of a cell, or noVertex.
    VertexId firstIn(const Cell &c) const
    {
        const CellId block = blocks_[blockAt(c)];
        return block == noCell ? noVertex : firstInCell_[block + placeInBlock(c)];
    }

    /// The cell, made where it is not there.
    CellId cellAt(const Cell &c);
    void link(VertexId id, CellId cell);
    void unlink(VertexId id);
    void regridIfNeeded();
    void layOutCells(std::size_t cellCount);
    /// Links all vertices; returns how many of them there are for each cell that holds any.
    double linkAll();
    void improve(const Cell &c, const Point3 &query, Candidate &best) const;

    Box3 bounds_;
    GridCells cells_;
    std::size_t blocksX_ = 1, blocksY_ = 1;
    std::vector<CellId> blocks_; ///< the first cell of each block, or noCell
    std::vector<VertexId> firstInCell_;
    std::vector<Entry> entries_;
    std::size_t size_ = 0;
    std::size_t sizeAtRebuild_ = 0;
};

} // namespace neuralmesh
