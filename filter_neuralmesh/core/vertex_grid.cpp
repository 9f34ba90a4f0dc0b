// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace neuralmesh {
namespace {

/// Cell of a coordinate, clamped into the grid. Clamping is monotone, so a range of coordinates
/// never misses the clamped cell of a point inside the range.
int clampedCell(Scalar coordinate, Scalar origin, Scalar cellsPerUnit, int cells)
{
    const Scalar place = (coordinate - origin) * cellsPerUnit;
    if (!(place > 0))
        return 0;
    return place < static_cast<Scalar>(cells) ? static_cast<int>(place) : cells - 1;
}

double cellsAlong(double extent, double cellSize)
{
    return std::max(1.0, std::ceil(extent / cellSize));
}

} // namespace

VertexGrid::VertexGrid(const Box3 &bounds) : bounds_(bounds)
{
    layOutCells(1);
}

VertexGrid::CellCoordinates VertexGrid::coordinates(const Point3 &position) const
{
    return {clampedCell(position.X(), bounds_.min.X(), cellsPerUnit_, cellsX_),
            clampedCell(position.Y(), bounds_.min.Y(), cellsPerUnit_, cellsY_),
            clampedCell(position.Z(), bounds_.min.Z(), cellsPerUnit_, cellsZ_)};
}

VertexGrid::CellId VertexGrid::cellAt(const CellCoordinates &c) const
{
    return static_cast<CellId>((static_cast<std::size_t>(c.z) * static_cast<std::size_t>(cellsY_) +
                                static_cast<std::size_t>(c.y)) *
                                   static_cast<std::size_t>(cellsX_) +
                               static_cast<std::size_t>(c.x));
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
    link(id, cellAt(coordinates(position)));
    ++size_;
    regridIfNeeded();
}

void VertexGrid::move(VertexId id, const Point3 &position)
{
    assert(contains(id));
    Entry &entry = entries_[id];
    entry.position = position;
    const CellId cell = cellAt(coordinates(position));
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
    layOutCells(static_cast<std::size_t>(cellsPerVertex * static_cast<double>(size_)));
    sizeAtRebuild_ = size_;
    for (VertexId id = 0; id < entries_.size(); ++id)
        if (entries_[id].cell != noCell)
            link(id, cellAt(coordinates(entries_[id].position)));
}

void VertexGrid::layOutCells(std::size_t cellCount)
{
    // The cell size at which about cellCount cubes fill the bounds, found by bisection because
    // thin bounds hold a single layer.
    const Point3 extent = bounds_.IsNull() ? Point3(0, 0, 0) : bounds_.Dim();
    const double widest = std::max({extent.X(), extent.Y(), extent.Z(), 1e-30});
    double low = widest / static_cast<double>(cellCount + 1);
    double high = widest;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        const double cells = cellsAlong(extent.X(), middle) * cellsAlong(extent.Y(), middle) *
                             cellsAlong(extent.Z(), middle);
        (cells > static_cast<double>(cellCount) ? low : high) = middle;
    }
    cellsPerUnit_ = 1 / high;
    cellsX_ = static_cast<int>(cellsAlong(extent.X(), high));
    cellsY_ = static_cast<int>(cellsAlong(extent.Y(), high));
    cellsZ_ = static_cast<int>(cellsAlong(extent.Z(), high));
    firstInCell_.assign(static_cast<std::size_t>(cellsX_) * static_cast<std::size_t>(cellsY_) *
                            static_cast<std::size_t>(cellsZ_),
                        noVertex);
}

void VertexGrid::improve(CellId cell, const Point3 &query, Candidate &best) const
{
    for (VertexId id = firstInCell_[cell]; id != noVertex; id = entries_[id].next) {
        const Scalar d = (entries_[id].position - query).SquaredNorm();
        if (d < best.squaredDistance || (d == best.squaredDistance && id < best.id))
            best = {d, id};
    }
}

VertexGrid::Candidate VertexGrid::anyNearby(const Point3 &query) const
{
    // Cubes of cells around the query, one layer further each time until one holds a vertex.
    Candidate best{std::numeric_limits<Scalar>::infinity(), noVertex};
    const CellCoordinates centre = coordinates(query);
    for (int reach = 0; best.id == noVertex; ++reach)
        for (int z = std::max(0, centre.z - reach); z <= std::min(cellsZ_ - 1, centre.z + reach);
             ++z)
            for (int y = std::max(0, centre.y - reach);
                 y <= std::min(cellsY_ - 1, centre.y + reach); ++y) {
                const bool inside =
                    std::abs(z - centre.z) < reach && std::abs(y - centre.y) < reach;
                const int step = inside ? std::max(1, 2 * reach) : 1;
                for (int x = centre.x - reach; x <= centre.x + reach; x += step)
                    if (x >= 0 && x < cellsX_)
                        improve(cellAt({x, y, z}), query, best);
            }
    return best;
}

VertexId VertexGrid::nearest(const Point3 &query, VertexId hint) const
{
    if (size_ == 0)
        return noVertex;
    Candidate best = contains(hint)
                         ? Candidate{(entries_[hint].position - query).SquaredNorm(), hint}
                         : anyNearby(query);
    const CellId own = cellAt(coordinates(query));
    improve(own, query, best);
    const Scalar radius = std::sqrt(best.squaredDistance);
    // The rounding of the root must not lose a vertex at exactly the best distance.
    const Scalar reach = radius * (1 + 4 * std::numeric_limits<Scalar>::epsilon());
    const CellCoordinates low = coordinates(query - Point3(reach, reach, reach));
    const CellCoordinates high = coordinates(query + Point3(reach, reach, reach));
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (const CellId cell = cellAt({x, y, z}); cell != own)
                    improve(cell, query, best);
    return best.id;
}

bool VertexGrid::countDown(CellId cell, const Point3 &query, Scalar squaredRadius, int &count) const
{
    for (VertexId id = firstInCell_[cell]; id != noVertex; id = entries_[id].next)
        if ((entries_[id].position - query).SquaredNorm() <= squaredRadius && --count <= 0)
            return true;
    return false;
}

bool VertexGrid::hasWithin(const Point3 &query, Scalar radius, int count) const
{
    const Scalar squaredRadius = radius * radius;
    const CellId own = cellAt(coordinates(query));
    if (countDown(own, query, squaredRadius, count))
        return true;
    const CellCoordinates low = coordinates(query - Point3(radius, radius, radius));
    const CellCoordinates high = coordinates(query + Point3(radius, radius, radius));
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x)
                if (const CellId cell = cellAt({x, y, z});
                    cell != own && countDown(cell, query, squaredRadius, count))
                    return true;
    return false;
}

} // namespace neuralmesh
