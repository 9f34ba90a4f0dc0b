// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/parametric_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "neuralmesh/sampler_errors.h"
#include "samplers/input_checks.h"

namespace neuralmesh {
namespace {

/// Cells along u and along v, each measured at 3 x 3 nodes: some 50 ms.
constexpr int cellsAlong = 128;
constexpr int nodesAlong = 2 * cellsAlong + 1;
/// Bound of a cell's density, in the largest of its nodes'.
constexpr double boundOfLargest = 1.5;
/// Step of the differences that stand for derivatives, as a share of the range: their error is
/// 1e-10 times the third derivative, their rounding 1e-11 of the values.
constexpr double differenceStep = 1e-5;
/// Places that are tried for one sample. On a smooth surface, two of three are kept.
constexpr int mostTries = 100000;
/// Places by which it is judged beforehand whether enough are kept, and the share that has to be:
/// of less, samples would take minutes.
constexpr int pilotPlaces = 20000;
constexpr double leastKept = 0.01;

InvalidInput tooSmall()
{
    return InvalidInput("Nearly all of the surface is in next to no part of the ranges of u and v, "
                        "as where x, y or z jump: it cannot be sampled.");
}

double between(Range range, double share)
{
    return range.low + (range.high - range.low) * share;
}

} // namespace

ParametricSampler::ParametricSampler(std::array<Expression, 3> coordinates, Range u, Range v,
                                     const Progress &progress)
    : coordinates_(std::move(coordinates)), u_(u), v_(v)
{
    requireRange('u', u);
    requireRange('v', v);
    measureCells(progress);
    requireKept();
}

vcg::Point3d ParametricSampler::place(double u, double v) const
{
    vcg::Point3d p;
    const double parameters[2] = {u, v};
    for (int axis = 0; axis < 3; ++axis) {
        const Expression &coordinate = coordinates_[static_cast<std::size_t>(axis)];
        p[axis] = coordinate.at(parameters);
        if (!std::isfinite(p[axis])) {
            char where[128];
            std::snprintf(where, sizeof where, " is not finite at u = %.6g, v = %.6g.", u, v);
            throw InvalidInput(coordinate.name() + where);
        }
    }
    return p;
}

double ParametricSampler::areaDensity(double u, double v) const
{
    // One-sided at the ends of the ranges, outside which the expressions need not be finite.
    const auto around = [](Range range, double at) {
        const double step = differenceStep * (range.high - range.low);
        return Range{std::max(at - step, range.low), std::min(at + step, range.high)};
    };
    const Range alongU = around(u_, u);
    const Range alongV = around(v_, v);
    const vcg::Point3d byU =
        (place(alongU.high, v) - place(alongU.low, v)) / (alongU.high - alongU.low);
    const vcg::Point3d byV =
        (place(u, alongV.high) - place(u, alongV.low)) / (alongV.high - alongV.low);
    return (byU ^ byV).Norm();
}

void ParametricSampler::measureCells(const Progress &progress)
{
    vcg::Box3d worldBounds;
    std::vector<vcg::Point3d> nodes;
    std::vector<double> densities;
    for (int j = 0; j < nodesAlong; ++j) {
        report(progress, static_cast<double>(j) / nodesAlong, "Measuring the surface");
        for (int i = 0; i < nodesAlong; ++i) {
            const double u = between(u_, i / (nodesAlong - 1.0));
            const double v = between(v_, j / (nodesAlong - 1.0));
            nodes.push_back(place(u, v));
            worldBounds.Add(nodes.back());
            densities.push_back(areaDensity(u, v));
        }
    }
    frame_ = frameOf(worldBounds);
    std::vector<Point3> points;
    for (const vcg::Point3d &node : nodes) {
        points.push_back(toUnit(frame_, node));
        bounds_.Add(points.back());
    }
    isFlat_ = neuralmesh::isFlat(points);
    for (int j = 0; j < cellsAlong; ++j)
        for (int i = 0; i < cellsAlong; ++i) {
            double largest = 0;
            for (int row = 2 * j; row <= 2 * j + 2; ++row)
                for (int column = 2 * i; column <= 2 * i + 2; ++column)
                    largest =
                        std::max(largest, densities[static_cast<std::size_t>(row) * nodesAlong +
                                                    static_cast<std::size_t>(column)]);
            mostDensity_.push_back(boundOfLargest * largest);
        }
    const double largest = *std::max_element(mostDensity_.begin(), mostDensity_.end());
    if (!(largest > 0) || !std::isfinite(largest))
        throw InvalidInput("The surface has no area that could be measured.");
    cells_ = AliasTable(mostDensity_);
}

/// Where an expression jumps, its cells count for far more than the area that is in them.
void ParametricSampler::requireKept() const
{
    Random random(0); // what is refused does not depend on the seed
    int kept = 0;
    for (int place = 0; place < pilotPlaces; ++place)
        kept += tryPlace(random) ? 1 : 0;
    if (kept < leastKept * pilotPlaces)
        throw tooSmall();
}

std::optional<Point> ParametricSampler::tryPlace(Random &random) const
{
    const std::size_t cell = cells_.draw(random);
    const std::size_t column = cell % cellsAlong;
    const std::size_t row = cell / cellsAlong;
    const double u = between(u_, (static_cast<double>(column) + random.unit()) / cellsAlong);
    const double v = between(v_, (static_cast<double>(row) + random.unit()) / cellsAlong);
    if (random.unit() * mostDensity_[cell] < areaDensity(u, v))
        return toPlain(place(u, v));
    return std::nullopt;
}

Point ParametricSampler::drawPoint(Random &random) const
{
    for (int tries = 0; tries < mostTries; ++tries)
        if (const std::optional<Point> point = tryPlace(random))
            return *point;
    throw tooSmall();
}

void ParametricSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.resize(count);
    for (Point &sample : samples)
        sample = frame_.toUnit(drawPoint(random));
}

} // namespace neuralmesh
