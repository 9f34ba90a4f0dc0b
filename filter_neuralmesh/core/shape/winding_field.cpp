// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/winding_field.h"

#include <algorithm>
#include <unordered_set>

#include "core/shape/grid_filters.h"
#include "core/space/point_statistics.h"

namespace neuralmesh {
namespace {

/// V-cycles of each solution: what one leaves, the next round corrects.
constexpr int cyclesPerSolution = 2;

/// Halvings of the grid over which the level of the points is spread, and the weight of what is
/// known further away, in points.
constexpr int levelHalvings = 2;
constexpr float weightOfFurther = 0.05F;

void splat(Grid &grid, const TrilinearWeights &w, float value)
{
    for (std::size_t i = 0; i < 8; ++i)
        grid[w.nodes[i]] += w.weights[i] * value;
}

} // namespace

WindingField::WindingField(const std::vector<Point3> &points, int cells)
    : points_(points), solver_(cells), field_(cells)
{
    locate();
    leanToThinnestAxis();
}

void WindingField::locate()
{
    for (Grid *grid : {&source_, &change_, &x_, &y_, &z_})
        *grid = Grid(field_.cells());
    places_.clear();
    places_.reserve(points_.size());
    for (const Point3 &p : points_)
        places_.push_back(trilinearWeights(field_, p));
}

/// A sheet has two sides that are alike, and descent alone would choose one here and the other
/// there. So all normals start in one direction, as long as the area that each point stands for; a
/// closed surface forgets it.
void WindingField::leanToThinnestAxis()
{
    std::unordered_set<std::uint32_t> cells;
    for (const TrilinearWeights &place : places_)
        cells.insert(place.nodes[0]);
    const PrincipalAxes frame = principalAxes(points_);
    const float length = static_cast<float>(cells.size()) / static_cast<float>(points_.size());
    const Vector lean(static_cast<float>(frame.axes(0, 0)), static_cast<float>(frame.axes(1, 0)),
                      static_cast<float>(frame.axes(2, 0)));
    normals_.assign(points_.size(), lean * length);
}

void WindingField::refine()
{
    field_ = doubled(field_);
    solver_ = PoissonMultigrid(field_.cells());
    locate();
    for (Vector &normal : normals_)
        normal *= 4; // areas are in squares of a cell
}

void WindingField::improve(int smoothings)
{
    setSource(normals_, smoothings);
    solver_.solve(field_, source_, cyclesPerSolution);
    descend(smoothings);
    turnNormals();
}

/// source_ := the divergence of the normals, spread.
void WindingField::setSource(const std::vector<Vector> &normals, int smoothings)
{
    for (Grid *grid : {&x_, &y_, &z_})
        grid->fill(0);
    for (std::size_t i = 0; i < places_.size(); ++i) {
        splat(x_, places_[i], normals[i].X());
        splat(y_, places_[i], normals[i].Y());
        splat(z_, places_[i], normals[i].Z());
    }
    const int last = source_.cells();
    const std::ptrdiff_t sx = source_.strideX();
    const std::ptrdiff_t sy = source_.strideY();
    for (int x = 1; x < last; ++x)
        for (int y = 1; y < last; ++y) {
            const std::size_t row = source_.index(x, y, 0);
            const float *vx = x_.data() + row;
            const float *vy = y_.data() + row;
            const float *vz = z_.data() + row;
            float *s = source_.data() + row;
            for (int z = 1; z < last; ++z)
                s[z] = 0.5F *
                       (vx[z + sx] - vx[z - sx] + vy[z + sy] - vy[z - sy] + vz[z + 1] - vz[z - 1]);
        }
    smooth(source_, smoothings);
}

/// From normals to values at the points leads a linear map A: spread the divergence, solve,
/// interpolate. The descent runs along its adjoint, step by step in reverse, of the residual.
void WindingField::descend(int smoothings)
{
    source_.fill(0);
    for (const TrilinearWeights &place : places_)
        splat(source_, place, 0.5F - interpolate(field_, place));
    change_.fill(0);
    solver_.solve(change_, source_, cyclesPerSolution);
    smooth(change_, smoothings);
    descent_.clear();
    for (const TrilinearWeights &place : places_)
        descent_.push_back(gradientAt(change_, place) * -1);

    setSource(descent_, smoothings);
    change_.fill(0);
    solver_.solve(change_, source_, cyclesPerSolution);
    double along = 0;
    double squared = 0;
    for (const TrilinearWeights &place : places_) {
        const auto value = static_cast<double>(interpolate(change_, place));
        along += value * (0.5 - static_cast<double>(interpolate(field_, place)));
        squared += value * value;
    }
    const float step = squared > 0 ? static_cast<float>(along / squared) : 0;
    for (std::size_t i = 0; i < field_.size(); ++i)
        field_[i] += step * change_[i];
    for (std::size_t i = 0; i < normals_.size(); ++i)
        normals_[i] += descent_[i] * step;
}

/// Half-way, since normals that follow the gradient all the way swing from round to round.
void WindingField::turnNormals()
{
    for (std::size_t i = 0; i < normals_.size(); ++i) {
        const float length = normals_[i].Norm();
        const Vector direction = gradientAt(field_, places_[i]).Normalize() * -1;
        normals_[i] = (Vector(normals_[i]).Normalize() + direction).Normalize() * length;
    }
}

WindingField::Vector WindingField::gradientAt(const Grid &grid, const TrilinearWeights &place) const
{
    Vector gradient(0, 0, 0);
    const std::ptrdiff_t sx = grid.strideX();
    const std::ptrdiff_t sy = grid.strideY();
    for (std::size_t i = 0; i < 8; ++i) {
        const float *v = grid.data() + place.nodes[i];
        gradient += Vector(v[sx] - v[-sx], v[sy] - v[-sy], v[1] - v[-1]) * (place.weights[i] / 2);
    }
    return gradient;
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
    for (const TrilinearWeights &place : places_) {
        splat(sums[0], place, interpolate(field_, place));
        splat(counts[0], place, 1);
    }
    constexpr int smoothings = 2;
    smooth(sums[0], smoothings);
    smooth(counts[0], smoothings);
    for (int i = 0; i < levelHalvings; ++i) {
        sums.push_back(halvedSums(sums.back()));
        counts.push_back(halvedSums(counts.back()));
    }
    Grid level(sums.back().cells(), 0.5F);
    for (std::size_t i = sums.size(); i-- > 0;) {
        if (level.cells() != sums[i].cells())
            level = doubled(level);
        for (std::size_t node = 0; node < level.size(); ++node)
            level[node] = (sums[i][node] + weightOfFurther * level[node]) /
                          (counts[i][node] + weightOfFurther);
    }
    return level;
}

} // namespace neuralmesh
