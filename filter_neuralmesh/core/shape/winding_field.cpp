// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/winding_field.h"

#include <algorithm>

#include "core/shape/two_sides.h"
#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// V-cycles of each solution: what it leaves, the next round corrects.
constexpr int cyclesPerSolution = 1;

/// Points that the first grid takes: several for each of its cells that a surface passes.
constexpr std::size_t pointsOfFirstGrid = 4000;

/// Halvings of the grid over which the level of the points is spread, and the weight of what is
/// known further away, in points.
constexpr int levelHalvings = 2;
constexpr float weightOfFurther = 0.05F;
constexpr int levelSmoothings = 2;

} // namespace

WindingField::WindingField(const std::vector<Point3> &points, const GridSize &cells,
                           Workers &workers)
    : workers_(workers), points_(points), step_((points.size() - 1) / pointsOfFirstGrid + 1),
      solver_(cells, workers), field_(cells)
{
    locate();
    leanToThinnestAxis();
}

void WindingField::locate()
{
    source_ = Grid(field_.cells());
    change_ = Grid(field_.cells());
    places_.clear();
    around_ = {{field_.cells().x, field_.cells().y, field_.cells().z}, {0, 0, 0}};
    for (std::size_t i = 0; i < points_.size(); i += step_) {
        places_.push_back(placeInGrid(field_, points_[i]));
        for (int axis = 0; axis < 3; ++axis) {
            const int cell = static_cast<int>(points_[i][axis] * field_.resolution());
            around_.low[axis] = std::min(around_.low[axis], cell);
            around_.high[axis] = std::max(around_.high[axis], cell + 1);
        }
    }
}

/// Starts from the normals of a flat sheet. Its two sides are alike, and descent alone would choose
/// one here and the other there; a closed surface forgets them.
void WindingField::leanToThinnestAxis()
{
    const PrincipalAxes frame = principalAxes(points_);
    const Vector axis(static_cast<float>(frame.axes(0, 0)), static_cast<float>(frame.axes(1, 0)),
                      static_cast<float>(frame.axes(2, 0)));
    std::vector<std::uint32_t> nodes;
    for (const GridPlace &place : places_)
        nodes.push_back(place.node);
    std::sort(nodes.begin(), nodes.end());
    const auto cells = std::unique(nodes.begin(), nodes.end()) - nodes.begin();
    const float area = static_cast<float>(cells) / static_cast<float>(places_.size());
    normals_.assign(places_.size(), axis * area);
}

void WindingField::refine()
{
    field_ = doubled(field_);
    solver_ = PoissonMultigrid(field_.cells(), workers_);
    const std::size_t formerStep = step_;
    step_ = (step_ - 1) / 4 + 1; // as many for an area in squares of a cell
    locate();
    const std::vector<Vector> former = std::move(normals_);
    double sum = 0;
    for (const Vector &normal : former)
        sum += static_cast<double>(normal.Norm());
    // Areas are in squares of a cell, and the points share them.
    const double share =
        4 * static_cast<double>(former.size()) / static_cast<double>(places_.size());
    const auto usual = static_cast<float>(share * sum / static_cast<double>(former.size()));
    normals_.clear();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const std::size_t point = i * step_;
        if (point % formerStep == 0)
            normals_.push_back(former[point / formerStep] * static_cast<float>(share));
        else
            normals_.push_back(gradientAt(field_, places_[i]).Normalize() * -usual);
    }
}

template <class Visit> void WindingField::forEachPlace(const Visit &visit)
{
    constexpr std::size_t placesOfChunk = 4000;
    workers_.forEachChunk(places_.size(), placesOfChunk,
                          [&](std::size_t first, std::size_t end, int) {
                              for (std::size_t i = first; i < end; ++i)
                                  visit(i);
                          });
}

/// The inner nodes up to so many cells from the cells of points.
NodeBox WindingField::nodesAround(int distance) const
{
    NodeBox box = innerNodes(field_);
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::max(box.low[axis], around_.low[axis] - distance);
        box.high[axis] = std::min(box.high[axis], around_.high[axis] + distance);
    }
    return box;
}

void WindingField::improve(int smoothings)
{
    source_.fill(0);
    for (std::size_t i = 0; i < places_.size(); ++i)
        splatDivergence(source_, places_[i], normals_[i]);
    smooth(workers_, source_, nodesAround(smoothings + 1), smoothings);
    solver_.solve(field_, source_, cyclesPerSolution);
    descend(smoothings);
    turnNormals();
}

/// From normals to values at the points leads a linear map A: spread the divergence, solve,
/// interpolate. The descent runs along its adjoint, step by step in reverse, of the residual.
void WindingField::descend(int smoothings)
{
    source_.fill(0);
    for (const GridPlace &place : places_)
        splat(source_, place, 0.5F - interpolate(field_, place));
    change_.fill(0);
    solver_.solve(change_, source_, cyclesPerSolution);
    smooth(workers_, change_, nodesAround(smoothings + 1), smoothings);
    descent_.resize(places_.size());
    forEachPlace([&](std::size_t i) { descent_[i] = gradientAt(change_, places_[i]) * -1; });

    source_.fill(0);
    for (std::size_t i = 0; i < places_.size(); ++i)
        splatDivergence(source_, places_[i], descent_[i]);
    smooth(workers_, source_, nodesAround(smoothings + 1), smoothings);
    change_.fill(0);
    solver_.solve(change_, source_, cyclesPerSolution);
    double along = 0;
    double squared = 0;
    for (const GridPlace &place : places_) {
        const auto value = static_cast<double>(interpolate(change_, place));
        along += value * (0.5 - static_cast<double>(interpolate(field_, place)));
        squared += value * value;
    }
    const float step = squared > 0 ? static_cast<float>(along / squared) : 0;
    for (std::size_t i = 0; i < field_.size(); ++i)
        field_[i] += step * change_[i];
    for (std::size_t i = 0; i < places_.size(); ++i)
        normals_[i] += descent_[i] * step;
}

/// Half-way, since normals that follow the gradient all the way swing from round to round.
void WindingField::turnNormals()
{
    forEachPlace([&](std::size_t i) {
        Vector &normal = normals_[i];
        const float length = normal.Norm();
        const Vector direction = gradientAt(field_, places_[i]).Normalize() * -1;
        normal = (Vector(normal).Normalize() + direction).Normalize() * length;
    });
}

void WindingField::turnInnerSides(double radius, double leastThickness)
{
    std::vector<Point3> taking;
    for (std::size_t i = 0; i < points_.size(); i += step_)
        taking.push_back(points_[i]);
    const InnerSides sides(taking, normals_, radius, leastThickness);
    std::vector<unsigned char> isInner(taking.size());
    forEachPlace([&](std::size_t i) { isInner[i] = sides.hasPoint(i) ? 1 : 0; });
    for (std::size_t i = 0; i < normals_.size(); ++i)
        if (isInner[i] != 0)
            normals_[i] *= -1;
}

void WindingField::goBack(const State &state)
{
    field_ = state.field;
    normals_ = state.normals;
}

void WindingField::holdOutside(const std::vector<unsigned char> &isOutside)
{
    solver_.hold(isOutside);
    for (std::size_t i = 0; i < field_.size(); ++i)
        if (isOutside[i] != 0)
            field_[i] = 0;
}

Grid WindingField::levelOfPoints() const
{
    std::vector<Grid> sums{Grid(field_.cells())};
    std::vector<Grid> counts{Grid(field_.cells())};
    for (const GridPlace &place : places_) {
        splat(sums[0], place, interpolate(field_, place));
        splat(counts[0], place, 1);
    }
    smooth(workers_, sums[0], nodesAround(levelSmoothings + 1), levelSmoothings);
    smooth(workers_, counts[0], nodesAround(levelSmoothings + 1), levelSmoothings);
    for (int i = 0; i < levelHalvings; ++i) {
        sums.push_back(halvedSums(sums.back()));
        counts.push_back(halvedSums(counts.back()));
    }
    Grid level(sums.back().cells(), 0.5F);
    for (std::size_t i = sums.size(); i-- > 0;) {
        if (level.size() != sums[i].size())
            level = doubled(level);
        for (std::size_t node = 0; node < level.size(); ++node)
            level[node] = (sums[i][node] + weightOfFurther * level[node]) /
                          (counts[i][node] + weightOfFurther);
    }
    return level;
}

} // namespace neuralmesh
