// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/outside_flood.h"

#include <algorithm>
#include <cmath>

#include "core/topology/closure_cost.h"

namespace neuralmesh {
OutsideFlood::OutsideFlood(const Grid &inside, const std::vector<Point3> &points, double reach)
    : inside_(inside),
      steps_{inside.strideX(), -inside.strideX(), inside.strideY(), -inside.strideY(), 1, -1},
      states_(inside.size(), State::unseen), outside_(inside.size(), 0)
{
    markBorder();
    markCrust(points, reach);
    flood();
    for (std::size_t i = 0; i < states_.size(); ++i)
        outside_[i] =
            (states_[i] == State::flooded && inside_[i] <= 0) || states_[i] == State::border;
    judgePockets();
}

void OutsideFlood::markCrust(const std::vector<Point3> &points, double reach)
{
    const GridSize &cells = inside_.cells();
    const int lasts[3] = {cells.x - 1, cells.y - 1, cells.z - 1};
    for (const Point3 &point : points) {
        const Point3 centre = point * inside_.resolution();
        int low[3];
        int high[3];
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::max(1, static_cast<int>(std::ceil(centre[axis] - reach)));
            high[axis] = std::min(lasts[axis], static_cast<int>(std::floor(centre[axis] + reach)));
        }
        for (int x = low[0]; x <= high[0]; ++x)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int z = low[2]; z <= high[2]; ++z)
                    if ((Point3(x, y, z) - centre).SquaredNorm() <= reach * reach)
                        states_[inside_.index(x, y, z)] = State::crust;
    }
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
    if (static_cast<double>(membrane) <= largeDisc * static_cast<double>(sheet))
        return;
    doubled_ += sheet;
    for (const std::size_t i : nodes_)
        outside_[i] = 1;
}

} // namespace neuralmesh
