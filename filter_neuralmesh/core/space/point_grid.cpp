// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/point_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/space/box_tree.h"

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

PointGrid::Candidate nearerOf(const PointGrid::Candidate &best, const Point3 &query,
                              const PointGrid::Entry &entry)
{
    const Scalar d = (entry.position - query).SquaredNorm();
    const bool isNearer =
        d < best.squaredDistance || (d == best.squaredDistance && entry.id < best.id);
    return isNearer ? PointGrid::Candidate{d, entry.id} : best;
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
    if (pointsBeside_ > mostBeside)
        makeTree();
    else
        sortIntoCells();
}

void PointGrid::countInCells()
{
    starts_.assign(cells_.count() + 1, 0);
    std::size_t held = 0;
    double pairs = 0;
    for (const Entry &entry : entries_) {
        const std::uint32_t before = starts_[cellOf(entry.position)]++;
        held += before == 0 ? 1 : 0;
        pairs += before;
    }
    const auto count = static_cast<double>(entries_.size());
    pointsInCell_ = held > 0 ? count / static_cast<double>(held) : 0;
    pointsBeside_ = held > 0 ? 2 * pairs / count : 0;
}

void PointGrid::makeTree()
{
    starts_ = {};
    std::vector<Box3> places;
    places.reserve(entries_.size());
    for (const Entry &entry : entries_)
        places.emplace_back(entry.position, entry.position);
    tree_ = std::make_shared<const BoxTree>(std::move(places));
}

void PointGrid::forEachOfTree(const Point3 &query, Scalar radius, const TakeRun &take) const
{
    constexpr Scalar nowhere = -1;
    Scalar squaredReach = radius * radius * beyondRounding;
    tree_->forEachNear(query, squaredReach, [&](std::uint32_t i) {
        const Entry *entry = entries_.data() + i;
        if (squaredReach != nowhere && !take(entry, entry + 1))
            squaredReach = nowhere;
    });
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
        for (; first != end; ++first)
            best = nearerOf(best, query, *first);
        return true;
    });
}

VertexId PointGrid::nearestInTree(const Point3 &query, Candidate best) const
{
    tree_->forEachNear(query, best.squaredDistance,
                       [&](std::uint32_t i) { best = nearerOf(best, query, entries_[i]); });
    return best.id;
}

VertexId PointGrid::nearest(const Point3 &query, Candidate known) const
{
    if (isCrowded())
        return nearestInTree(query, known);
    improve(query, beyondRounding * std::sqrt(known.squaredDistance), known);
    return known.id;
}

VertexId PointGrid::nearest(const Point3 &query) const
{
    Candidate best{std::numeric_limits<Scalar>::infinity(), noVertex};
    if (entries_.empty())
        return noVertex;
    if (isCrowded())
        return nearestInTree(query, best);
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
