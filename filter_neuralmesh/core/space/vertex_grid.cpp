// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/vertex_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace neuralmesh {
VertexGrid::VertexGrid(const Box3 &bounds) : bounds_(bounds), cells_(bounds, 1)
{
    layOutCells(1);
}

VertexGrid::CellId VertexGrid::cellAt(const Cell &c)
{
    CellId &block = blocks_[blockAt(c)];
    if (block == noCell) {
        block = static_cast<CellId>(firstInCell_.size());
        firstInCell_.resize(firstInCell_.size() + cellsOfBlock, noVertex);
    }
    return block + placeInBlock(c);
}

void VertexGrid::link(VertexId id, CellId cell)
{
    Entry &entry = entries_[id];
    entry.cell = cell;
    entry.previous = noVertex;
    entry.next = firstInCell_[cell];
    if (entry.next != noVertex)
        entries_[entry.next].previous = id;
    firstInCell_[cell] = id;
}

void VertexGrid::unlink(VertexId id)
{
    const Entry &entry = entries_[id];
    if (entry.previous != noVertex)
        entries_[entry.previous].next = entry.next;
    else
        firstInCell_[entry.cell] = entry.next;
    if (entry.next != noVertex)
        entries_[entry.next].previous = entry.previous;
}

void VertexGrid::insert(VertexId id, const Point3 &position)
{
    assert(!contains(id));
    if (id >= entries_.size())
        entries_.resize(static_cast<std::size_t>(id) + 1);
    entries_[id].position = position;
    link(id, cellAt(cells_.at(position)));
    ++size_;
    regridIfNeeded();
}

void VertexGrid::move(VertexId id, const Point3 &position)
{
    assert(contains(id));
    Entry &entry = entries_[id];
    entry.position = position;
    const CellId cell = cellAt(cells_.at(position));
    if (cell == entry.cell)
        return;
    unlink(id);
    link(id, cell);
}

void VertexGrid::erase(VertexId id)
{
    assert(contains(id));
    unlink(id);
    entries_[id].cell = noCell;
    --size_;
}

void VertexGrid::regridIfNeeded()
{
    if (size_ < 2 * sizeAtRebuild_ + 8)
        return;
    sizeAtRebuild_ = size_;
    // Twice as many cells hold three fifths of the vertices each, where these lie on a surface.
    // Blocks, which are there whether they hold any or not, must stay few.
    for (double cells = cellsPerVertex;; cells *= 2) {
        layOutCells(static_cast<std::size_t>(cells * static_cast<double>(size_)));
        if (linkAll() <= mostInCell || blocks_.size() > size_)
            return;
    }
}

double VertexGrid::linkAll()
{
    std::size_t held = 0;
    for (VertexId id = 0; id < entries_.size(); ++id)
        if (entries_[id].cell != noCell) {
            link(id, cellAt(cells_.at(entries_[id].position)));
            held += entries_[id].next == noVertex ? 1 : 0;
        }
    return static_cast<double>(size_) / static_cast<double>(held);
}

void VertexGrid::layOutCells(std::size_t cellCount)
{
    cells_ = GridCells(bounds_, cellCount);
    const auto blocksAlong = [](int cells) {
        return static_cast<std::size_t>((cells + blockSide - 1) / blockSide);
    };
    blocksX_ = blocksAlong(cells_.x());
    blocksY_ = blocksAlong(cells_.y());
    blocks_.assign(blocksX_ * blocksY_ * blocksAlong(cells_.z()), noCell);
    firstInCell_.clear();
}

void VertexGrid::improve(const Cell &c, const Point3 &query, Candidate &best) const
{
    for (VertexId id = firstIn(c); id != noVertex; id = entries_[id].next) {
        const Scalar d = (entries_[id].position - query).SquaredNorm();
        if (d < best.squaredDistance || (d == best.squaredDistance && id < best.id))
            best = {d, id};
    }
}

/// The cells, each with its least distance from the query, in cubes of growing size around it:
/// until a cube is further than the best that was found.
class VertexGrid::Shells {
public:
    Shells(const VertexGrid &grid, const Point3 &query)
        : grid_(grid), query_(query), centre_(grid.cells_.at(query)),
          x_(grid.cells_, query.X() - grid.cells_.origin().X(), centre_.x, grid.cells_.x()),
          y_(grid.cells_, query.Y() - grid.cells_.origin().Y(), centre_.y, grid.cells_.y()),
          z_(grid.cells_, query.Z() - grid.cells_.origin().Z(), centre_.z, grid.cells_.z())
    {
    }

    void search(Candidate &best) const
    {
        grid_.improve(centre_, query_, best);
        for (int reach = 1;; ++reach) {
            const Scalar least =
                std::min({x_.leastAt(reach), y_.leastAt(reach), z_.leastAt(reach)});
            if (least > best.squaredDistance || std::isinf(least))
                return;
            searchShell(reach, best);
        }
    }

private:
    /// One axis of the grid.
    class Axis {
    public:
        Axis(const GridCells &grid, Scalar offset, int centre, int cells)
            : fromLower_(offset - static_cast<Scalar>(centre) / grid.cellsPerUnit()),
              cellSize_(1 / grid.cellsPerUnit()), lowest_(-centre), highest_(cells - 1 - centre),
              slack_(rounding * std::max(static_cast<Scalar>(cells) * cellSize_, std::abs(offset)))
        {
        }

        int lowest() const { return lowest_; }
        int highest() const { return highest_; }

        /// Of cells so many further: the least squared distance from the query along the axis.
        Scalar squaredDistance(int step) const
        {
            if (step == 0)
                return 0;
            const Scalar d = step > 0 ? static_cast<Scalar>(step) * cellSize_ - fromLower_
                                      : fromLower_ - static_cast<Scalar>(step + 1) * cellSize_;
            return d > slack_ ? (d - slack_) * (d - slack_) : 0;
        }

        /// Of cells so many further to either side; infinite where there are none.
        Scalar leastAt(int reach) const
        {
            constexpr Scalar none = std::numeric_limits<Scalar>::infinity();
            return std::min(reach <= highest_ ? squaredDistance(reach) : none,
                            -reach >= lowest_ ? squaredDistance(-reach) : none);
        }

    private:
        /// The rounding of coordinates must not lose a vertex at the border of its cell.
        static constexpr Scalar rounding = 16 * std::numeric_limits<Scalar>::epsilon();

        Scalar fromLower_; ///< of the query's own cell
        Scalar cellSize_;
        int lowest_, highest_; ///< steps within the grid
        Scalar slack_;
    };

    void searchShell(int reach, Candidate &best) const
    {
        for (int z = std::max(-reach, z_.lowest()); z <= std::min(reach, z_.highest()); ++z) {
            const Scalar ofZ = z_.squaredDistance(z);
            if (ofZ > best.squaredDistance)
                continue;
            for (int y = std::max(-reach, y_.lowest()); y <= std::min(reach, y_.highest()); ++y) {
                const Scalar ofRow = ofZ + y_.squaredDistance(y);
                if (ofRow > best.squaredDistance)
                    continue;
                const bool isFace = std::abs(z) == reach || std::abs(y) == reach;
                searchRow(y, z, reach, isFace ? 1 : 2 * reach, ofRow, best);
            }
        }
    }

    void searchRow(int y, int z, int reach, int stride, Scalar ofRow, Candidate &best) const
    {
        for (int x = -reach; x <= reach; x += stride)
            if (x >= x_.lowest() && x <= x_.highest() &&
                ofRow + x_.squaredDistance(x) <= best.squaredDistance)
                grid_.improve({centre_.x + x, centre_.y + y, centre_.z + z}, query_, best);
    }

    const VertexGrid &grid_;
    const Point3 &query_;
    const Cell centre_;
    const Axis x_, y_, z_;
};

VertexId VertexGrid::nearest(const Point3 &query, VertexId hint) const
{
    if (size_ == 0)
        return noVertex;
    Candidate best{std::numeric_limits<Scalar>::infinity(), noVertex};
    if (contains(hint))
        best = {(entries_[hint].position - query).SquaredNorm(), hint};
    Shells(*this, query).search(best);
    return best.id;
}

} // namespace neuralmesh
