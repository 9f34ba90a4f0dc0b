// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace neuralmesh {
namespace {

/// A search goes so much further than a distance, so that rounding loses none at the border.
constexpr Scalar beyondRounding = 1 + 1e-9;

std::vector<PointGrid::Entry> entriesOf(const std::vector<Point3> &points)
{
    std::vector<PointGrid::Entry> entries;
    entries.reserve(points.size());
    for (const Point3 &point : points)
        entries.push_back({point, static_cast<VertexId>(entries.size())});
    return entries;
}

} // namespace

PointGrid::PointGrid(const Box3 &bounds, const std::vector<Point3> &points)
    : PointGrid(bounds, entriesOf(points))
{
}

PointGrid::PointGrid(const Box3 &bounds, std::vector<Entry> entries)
    : cells_(bounds, 1), entries_(std::move(entries))
{
    // Twice as many cells hold three fifths of the points each, where these lie on a surface.
    for (std::size_t perPoint = cellsPerPoint; perPoint <= mostCellsPerPoint; perPoint *= 2) {
        cells_ = GridCells(bounds, perPoint * std::max<std::size_t>(entries_.size(), 1));
        countInCells();
        if (pointsInCell_ <= mostInCell)
            break;
    }
    sortIntoCells();
}

void PointGrid::countInCells()
{
    starts_.assign(cells_.count() + 1, 0);
    std::size_t held = 0;
    for (const Entry &entry : entries_)
        held += starts_[cellOf(entry.position)]++ == 0 ? 1 : 0;
    pointsInCell_ = held > 0 ? static_cast<double>(entries_.size()) / static_cast<double>(held) : 0;
}

/// By the counts that are there. Points of a cell keep their order.
void PointGrid::sortIntoCells()
{
    std::uint32_t before = 0;
    for (std::uint32_t &start : starts_)
        before += std::exchange(start, before);
    std::vector<Entry> sorted(entries_.size());
    for (const Entry &entry : entries_)
        sorted[starts_[cellOf(entry.position)]++] = entry;
    // Each start is that of the next cell by now.
    std::move_backward(starts_.begin(), starts_.end() - 1, starts_.end());
    starts_.front() = 0;
    entries_ = std::move(sorted);
}

void PointGrid::improve(const Point3 &query, Scalar radius, Candidate &best) const
{
    forEachRun(query, radius, [&](const Entry *first, const Entry *end) {
        for (; first != end; ++first) {
            const Scalar d = (first->position - query).SquaredNorm();
            if (d < best.squaredDistance || (d == best.squaredDistance && first->id < best.id))
                best = {d, first->id};
        }
        return true;
    });
}

VertexId PointGrid::nearest(const Point3 &query, Candidate known) const
{
    improve(query, beyondRounding * std::sqrt(known.squaredDistance), known);
    return known.id;
}

VertexId PointGrid::nearest(const Point3 &query) const
{
    Candidate best{std::numeric_limits<Scalar>::infinity(), noVertex};
    if (entries_.empty())
        return noVertex;
    // Cubes around the query that double until one holds a point; no other is nearer than the ball
    // through that.
    Scalar radius = 1 / cells_.cellsPerUnit();
    while (best.id == noVertex && std::isfinite(radius)) {
        improve(query, radius, best);
        radius *= 2;
    }
    return nearest(query, best);
}

bool PointGrid::hasWithin(const Point3 &query, Scalar radius, int count) const
{
    const Scalar squaredRadius = radius * radius;
    forEachRun(query, radius, [&](const Entry *first, const Entry *end) {
        for (; first != end; ++first)
            if ((first->position - query).SquaredNorm() <= squaredRadius && --count <= 0)
                return false;
        return true;
    });
    return count <= 0;
}

} // namespace neuralmesh
