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
constexpr std::size_t levelHalvings = 2;
constexpr float weightOfFurther = 0.05F;
constexpr int levelSmoothings = 2;

/// Nodes that are relaxed beyond those that sources reach. Without, errors of what is interpolated
/// around them part thin walls: a plate gets forty holes.
constexpr int margin = 2;

void sortUnique(std::vector<std::uint32_t> &numbers)
{
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

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
    for (std::size_t i = 0; i < points_.size(); i += step_)
        places_.push_back(placeInGrid(field_, points_[i]));
    cells_.clear();
    for (const GridPlace &place : places_)
        cells_.push_back(place.node);
    sortUnique(cells_);
    near_ = NodeSpans(field_.cells());
    smoothings_ = 0;
}

/// Starts from the normals of a flat sheet. Its two sides are alike, and descent alone would choose
/// one here and the other there; a closed surface forgets them.
void WindingField::leanToThinnestAxis()
{
    const PrincipalAxes frame = principalAxes(points_);
    const Vector axis(static_cast<float>(frame.axes(0, 0)), static_cast<float>(frame.axes(1, 0)),
                      static_cast<float>(frame.axes(2, 0)));
    const float area = static_cast<float>(cells_.size()) / static_cast<float>(places_.size());
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

/// Where there are sources that are smoothed so many times.
void WindingField::findNear(int smoothings)
{
    if (smoothings == smoothings_)
        return;
    smoothings_ = smoothings;
    fill(workers_, source_, near_, 0);
    near_ = NodeSpans(field_.cells(), cells_, smoothings + reachOfDivergence + margin);
    solver_.workAround(near_);
}

void WindingField::improve(int smoothings)
{
    findNear(smoothings);
    fill(workers_, source_, near_, 0);
    for (std::size_t i = 0; i < places_.size(); ++i)
        splatDivergence(source_, places_[i], normals_[i]);
    smooth(workers_, source_, near_, smoothings);
    solver_.solve(field_, source_, cyclesPerSolution);
    descend(smoothings);
    turnNormals();
}

/// From normals to values at the points leads a linear map A: spread the divergence, solve,
/// interpolate. The descent runs along its adjoint, step by step in reverse, of the residual.
void WindingField::descend(int smoothings)
{
    fill(workers_, source_, near_, 0);
    for (const GridPlace &place : places_)
        splat(source_, place, 0.5F - interpolate(field_, place));
    change_.fill(0);
    solver_.solve(change_, source_, cyclesPerSolution);
    smooth(workers_, change_, near_, smoothings);
    descent_.resize(places_.size());
    forEachPlace([&](std::size_t i) { descent_[i] = gradientAt(change_, places_[i]) * -1; });

    fill(workers_, source_, near_, 0);
    for (std::size_t i = 0; i < places_.size(); ++i)
        splatDivergence(source_, places_[i], descent_[i]);
    smooth(workers_, source_, near_, smoothings);
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
    takeInBorders(isOutside);
}

/// What is held ends abruptly, across a hole far from all points: there, the field is as little
/// smooth as at sources.
void WindingField::takeInBorders(const std::vector<unsigned char> &isHeld)
{
    const auto sx = static_cast<std::size_t>(field_.strideX());
    const auto sy = static_cast<std::size_t>(field_.strideY());
    const std::size_t known = cells_.size();
    const NodeSpans far = near_.complement();
    for (int x = 1; x < field_.cells().x; ++x)
        for (int y = 1; y < field_.cells().y; ++y)
            far.forEachInRow(x, y, [&](int low, int end) {
                const std::size_t first = field_.index(x, y, low);
                const std::size_t last = field_.index(x, y, end);
                for (std::size_t i = first; i < last; ++i)
                    if (isHeld[i] != isHeld[i + sx] || isHeld[i] != isHeld[i + sy] ||
                        isHeld[i] != isHeld[i + 1])
                        cells_.push_back(static_cast<std::uint32_t>(i));
            });
    if (cells_.size() == known)
        return;
    sortUnique(cells_);
    smoothings_ = 0;
}

Grid WindingField::levelOfPoints()
{
    // Of the points around a node, their values and their number. Both are 0 far from all points,
    // and the level that coarser grids know stays.
    fill(workers_, source_, near_, 0);
    fill(workers_, change_, near_, 0);
    for (const GridPlace &place : places_) {
        splat(source_, place, interpolate(field_, place));
        splat(change_, place, 1);
    }
    smooth(workers_, source_, near_, levelSmoothings);
    smooth(workers_, change_, near_, levelSmoothings);
    std::vector<Grid> sums{halvedSums(source_, near_)};
    std::vector<Grid> counts{halvedSums(change_, near_)};
    while (sums.size() < levelHalvings) {
        sums.push_back(halvedSums(sums.back()));
        counts.push_back(halvedSums(counts.back()));
    }
    Grid level(sums.back().cells(), 0.5F);
    const auto improveAt = [&](std::size_t node, const Grid &sum, const Grid &count) {
        level[node] = (sum[node] + weightOfFurther * level[node]) / (count[node] + weightOfFurther);
    };
    while (!sums.empty()) {
        for (std::size_t node = 0; node < level.size(); ++node)
            improveAt(node, sums.back(), counts.back());
        level = doubled(level);
        sums.pop_back();
        counts.pop_back();
    }
    near_.forEach(workers_, [&](int x, int y, int low, int end) {
        for (int z = low; z < end; ++z)
            improveAt(level.index(x, y, z), source_, change_);
    });
    return level;
}

} // namespace neuralmesh
