// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/outside_flood.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shape/grid_place.h"
#include "core/topology/closure_cost.h"

namespace neuralmesh {
namespace {

/// Points that lie deeper inside than this, in cells, may be of another surface than the field's.
constexpr double deep = 0.5;
/// But some are of its noise, which reaches as far to both sides: up to the depth beyond which so
/// many lie as far outside, for each of those inside.
constexpr double mostNoise = 0.2;

/// The least depth beyond which hardly any point is of noise; infinity where there is none.
double depthOfHidden(std::vector<double> depths)
{
    // The deepest first, and of equal ones those outside, so that no order of them counts.
    std::sort(depths.begin(), depths.end(), [](double a, double b) {
        return std::abs(a) != std::abs(b) ? std::abs(a) > std::abs(b) : a < b;
    });
    double least = std::numeric_limits<double>::infinity();
    double inside = 0;
    double outside = 0;
    for (const double depth : depths) {
        if (std::abs(depth) <= deep)
            break;
        (depth > 0 ? inside : outside) += 1;
        if (outside <= mostNoise * inside)
            least = std::abs(depth);
    }
    return least;
}

} // namespace

OutsideFlood::OutsideFlood(const Grid &inside, const std::vector<Point3> &points, double reach)
    : inside_(inside), points_(points), reach_(reach),
      steps_{inside.strideX(), -inside.strideX(), inside.strideY(), -inside.strideY(), 1, -1},
      states_(inside.size(), State::unseen), outside_(inside.size(), 0)
{
    markBorder();
    markCrust();
    flood();
    for (std::size_t i = 0; i < states_.size(); ++i)
        outside_[i] =
            (states_[i] == State::flooded && inside_[i] <= 0) || states_[i] == State::border;
    judgePockets();
}

/// Calls visit(node) for the inner nodes that a point's crust takes in.
template <class Visit>
void OutsideFlood::forEachAround(const Point3 &point, const Visit &visit) const
{
    const GridSize &cells = inside_.cells();
    const int lasts[3] = {cells.x - 1, cells.y - 1, cells.z - 1};
    const Point3 centre = point * inside_.resolution();
    int low[3];
    int high[3];
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::max(1, static_cast<int>(std::ceil(centre[axis] - reach_)));
        high[axis] = std::min(lasts[axis], static_cast<int>(std::floor(centre[axis] + reach_)));
    }
    for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
            for (int z = low[2]; z <= high[2]; ++z)
                if ((Point3(x, y, z) - centre).SquaredNorm() <= reach_ * reach_)
                    visit(inside_.index(x, y, z));
}

void OutsideFlood::markCrust()
{
    for (const Point3 &point : points_)
        forEachAround(point, [&](std::size_t node) { states_[node] = State::crust; });
}

/// The border is a way to everywhere.
void OutsideFlood::markBorder()
{
    const GridSize &cells = inside_.cells();
    states_.assign(states_.size(), State::border);
    forEachInnerRow(inside_, [&](std::size_t row) {
        std::fill_n(states_.begin() + static_cast<std::ptrdiff_t>(row) + 1, cells.z - 1,
                    State::unseen);
    });
}

void OutsideFlood::flood()
{
    const GridSize &cells = inside_.cells();
    const auto last = static_cast<std::size_t>(cells.z - 1);
    for (int x = 1; x < cells.x; ++x)
        for (int y = 1; y < cells.y; ++y) {
            const std::size_t row = inside_.index(x, y, 0);
            const bool isOutermost = x == 1 || x == cells.x - 1 || y == 1 || y == cells.y - 1;
            for (std::size_t z = 1; z <= last; z += isOutermost || last == 1 ? 1 : last - 1)
                nodes_.push_back(row + z);
        }
    while (!nodes_.empty()) {
        const std::size_t seed = nodes_.back();
        nodes_.pop_back();
        if (states_[seed] == State::unseen)
            floodSpan(seed);
    }
}

/// Floods along z as far as it goes; `nodes_` receives a node of each span beside it.
void OutsideFlood::floodSpan(std::size_t seed)
{
    std::size_t first = seed;
    while (states_[first - 1] == State::unseen)
        --first;
    std::size_t end = seed + 1;
    while (states_[end] == State::unseen)
        ++end;
    std::fill(states_.begin() + static_cast<std::ptrdiff_t>(first),
              states_.begin() + static_cast<std::ptrdiff_t>(end), State::flooded);
    for (const std::ptrdiff_t step : {steps_[0], steps_[1], steps_[2], steps_[3]})
        for (std::size_t i = first; i < end; ++i) {
            const std::size_t beside = i + static_cast<std::size_t>(step);
            if (states_[beside] == State::unseen &&
                (i == first || states_[beside - 1] != State::unseen))
                nodes_.push_back(beside);
        }
}

double OutsideFlood::doubledShare() const
{
    std::size_t faces = 0; // of the crust, to both sides
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (states_[i] == State::crust)
            for (const std::ptrdiff_t step : steps_)
                faces += states_[i + static_cast<std::size_t>(step)] != State::crust ? 1 : 0;
    return faces > 0 ? 2 * static_cast<double>(doubled_) / static_cast<double>(faces) : 0;
}

void OutsideFlood::judgePockets()
{
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (states_[i] == State::flooded && inside_[i] > 0)
            judgePocket(i);
}

/// Where its points are deep inside, by the field, a crust has a second surface beside the one that
/// the field has there: by node, points that are hidden less those that are not.
void OutsideFlood::findHidden()
{
    std::vector<double> depths;
    depths.reserve(points_.size());
    for (const Point3 &point : points_) {
        const double depth = cellsBeyondLevel(inside_, placeInGrid(inside_, point));
        depths.push_back(std::isnan(depth) ? 0 : depth); // of a field that is 0 all around
    }
    const double least = depthOfHidden(depths);
    hidden_.assign(states_.size(), 0);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const int vote = depths[i] >= least ? 1 : -1;
        forEachAround(points_[i], [&](std::size_t node) { hidden_[node] += vote; });
    }
}

/// Faces between the pocket and the crust around points that the field explains.
std::size_t OutsideFlood::countExplained(const std::vector<std::size_t> &pocket)
{
    if (hidden_.empty())
        findHidden();
    std::size_t explained = 0;
    for (const std::size_t i : pocket)
        for (const std::ptrdiff_t step : steps_) {
            const std::size_t j = i + static_cast<std::size_t>(step);
            explained += states_[j] == State::crust && hidden_[j] <= 0 ? 1 : 0;
        }
    return explained;
}

void OutsideFlood::judgePocket(std::size_t seed)
{
    nodes_.assign(1, seed);
    states_[seed] = State::judged;
    std::size_t membrane = 0;
    std::size_t sheet = 0;
    for (std::size_t next = 0; next < nodes_.size(); ++next)
        for (const std::ptrdiff_t step : steps_) {
            const std::size_t j = nodes_[next] + static_cast<std::size_t>(step);
            if (states_[j] == State::crust) {
                ++sheet;
            } else if (states_[j] == State::flooded && inside_[j] > 0) {
                states_[j] = State::judged;
                nodes_.push_back(j);
            } else if (states_[j] != State::judged) {
                ++membrane;
            }
        }
    // A blob on a flat sheet has a membrane that is larger than what it stands on.
    const auto isLarge = [&] {
        return static_cast<double>(membrane) > largeDisc * static_cast<double>(sheet);
    };
    if (!isLarge())
        sheet = countExplained(nodes_);
    if (!isLarge())
        return;
    doubled_ += sheet;
    for (const std::size_t i : nodes_)
        outside_[i] = 1;
}

} // namespace neuralmesh
