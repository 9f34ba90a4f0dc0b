// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/outside_flood.h"

#include <algorithm>
#include <cmath>

namespace neuralmesh {
namespace {

/// Area of a membrane, in areas of the sheet that it closes, from which the pocket behind it is
/// outside. Doubling the sheet costs its area, and the membrane, which no sample supports, its own:
/// a disc that closes half a sphere is half as large as the sheet, a blob on a flat sheet larger
/// than it.
constexpr double largeMembrane = 0.7;

} // namespace

OutsideFlood::OutsideFlood(const Grid &inside, const std::vector<Point3> &points, double reach)
    : inside_(inside),
      steps_{inside.strideX(), -inside.strideX(), inside.strideY(), -inside.strideY(), 1, -1},
      states_(inside.size(), State::unseen), outside_(inside.size(), 0)
{
    markCrust(points, reach);
    flood();
    for (std::size_t i = 0; i < states_.size(); ++i)
        outside_[i] = states_[i] == State::flooded && inside_[i] <= 0 ? 1 : 0;
    judgePockets();
}

void OutsideFlood::markCrust(const std::vector<Point3> &points, double reach)
{
    const int cells = inside_.cells();
    for (const Point3 &point : points) {
        const Point3 centre = point * cells;
        int low[3];
        int high[3];
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::max(1, static_cast<int>(std::ceil(centre[axis] - reach)));
            high[axis] = std::min(cells - 1, static_cast<int>(std::floor(centre[axis] + reach)));
        }
        for (int x = low[0]; x <= high[0]; ++x)
            for (int y = low[1]; y <= high[1]; ++y)
                for (int z = low[2]; z <= high[2]; ++z)
                    if ((Point3(x, y, z) - centre).SquaredNorm() <= reach * reach)
                        states_[inside_.index(x, y, z)] = State::crust;
    }
}

bool OutsideFlood::isInner(std::size_t node) const
{
    const auto nodes = static_cast<std::size_t>(inside_.nodesPerAxis());
    const std::size_t last = nodes - 1;
    const std::size_t x = node / nodes / nodes;
    const std::size_t y = node / nodes % nodes;
    const std::size_t z = node % nodes;
    return x > 0 && x < last && y > 0 && y < last && z > 0 && z < last;
}

/// The border is a way to everywhere, and flooded from the start.
void OutsideFlood::flood()
{
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (!isInner(i))
            states_[i] = State::flooded;
    const int last = inside_.cells();
    nodes_.clear();
    const auto enter = [&](std::size_t i) {
        if (states_[i] == State::unseen) {
            states_[i] = State::flooded;
            nodes_.push_back(i);
        }
    };
    for (int a = 1; a < last; ++a)
        for (int b = 1; b < last; ++b)
            for (const int side : {1, last - 1}) {
                enter(inside_.index(side, a, b));
                enter(inside_.index(a, side, b));
                enter(inside_.index(a, b, side));
            }
    while (!nodes_.empty()) {
        const std::size_t i = nodes_.back();
        nodes_.pop_back();
        for (const std::ptrdiff_t step : steps_)
            enter(i + static_cast<std::size_t>(step));
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
        if (states_[i] == State::flooded && inside_[i] > 0 && isInner(i))
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
            } else if (states_[j] == State::flooded) {
                if (inside_[j] > 0 && isInner(j)) {
                    states_[j] = State::judged;
                    nodes_.push_back(j);
                } else {
                    ++membrane;
                }
            }
        }
    if (static_cast<double>(membrane) <= largeMembrane * static_cast<double>(sheet))
        return;
    doubled_ += sheet;
    for (const std::size_t i : nodes_)
        outside_[i] = 1;
}

} // namespace neuralmesh
