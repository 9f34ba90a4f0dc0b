// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/implicit_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "neuralmesh/sampler_errors.h"
#include "samplers/input_checks.h"
#include "samplers/surfaces/root_finding.h"

namespace neuralmesh {
namespace {

/// Least steps in which a line crosses a cube, in cubes.
constexpr double stepOfCube = 0.25;
/// Roots are found to this share of a cube.
constexpr double rootTolerance = 1e-7;

/// Samples that tell where the surface is, and the lines that are drawn for them at the most.
constexpr std::size_t pilotSamples = 20000;
constexpr std::size_t pilotLines = 500000;
/// Share of the lines that have to meet the surface: of fewer, samples would take minutes. In a box
/// that fits, a third do.
constexpr double leastHit = 1e-3;
/// Lines between two calls of the progress callback.
constexpr std::size_t linesPerReport = 1000;
/// Drawing gives up after so many times the lines that it took for the pilot samples.
constexpr double mostLines = 1000;

struct Line {
    vcg::Point3d origin, direction;
};

/// A line that is as likely as any other that meets the cube: it enters at a point that is uniform
/// on the cube's sides, with a direction whose density is the cosine to the side's normal.
Line randomLineThrough(const vcg::Point3d &lowest, double size, Random &random)
{
    double a, b;
    do { // a point of the unit disc: the shadow of the direction on the side
        a = 2 * random.unit() - 1;
        b = 2 * random.unit() - 1;
    } while (a * a + b * b > 1);
    const double inwards = std::sqrt(1 - a * a - b * b);
    const auto side = static_cast<int>(random.below(6));
    const bool isFar = side >= 3;
    const int axis = side % 3;
    Line line{lowest, {}};
    line.origin[axis] += isFar ? size : 0;
    line.origin[(axis + 1) % 3] += size * random.unit();
    line.origin[(axis + 2) % 3] += size * random.unit();
    line.direction[axis] = isFar ? -inwards : inwards;
    line.direction[(axis + 1) % 3] = a;
    line.direction[(axis + 2) % 3] = b;
    return line;
}

struct Stretch {
    double from, to;
};

/// What of a line from its origin on lies in the box; empty where `from` is not below `to`.
Stretch clip(const Line &line, const vcg::Box3d &box)
{
    Stretch stretch{0, std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min[axis] - line.origin[axis];
        const double high = box.max[axis] - line.origin[axis];
        if (line.direction[axis] == 0) {
            if (low > 0 || high < 0)
                return {0, 0};
            continue;
        }
        const double a = low / line.direction[axis];
        const double b = high / line.direction[axis];
        stretch.from = std::max(stretch.from, std::min(a, b));
        stretch.to = std::min(stretch.to, std::max(a, b));
    }
    return stretch;
}

InvalidInput tooSmall(const Expression &function)
{
    return InvalidInput("The surface of " + function.name() +
                        " is too small a part of the box to be sampled: make the box smaller.");
}

} // namespace

ImplicitSampler::ImplicitSampler(Expression function, const Box &box, const Progress &progress)
    : function_(std::move(function))
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        requireRange("xyz" [axis], { box.min[axis], box.max[axis] });
    cells_ = findSurfaceCells(function_, toVcg(box), progress);
    const std::vector<vcg::Point3d> pilot = drawPilot(progress);
    vcg::Box3d worldBounds;
    for (const vcg::Point3d &p : pilot)
        worldBounds.Add(p);
    frame_ = frameOf(worldBounds);
    std::vector<Point3> points;
    for (const vcg::Point3d &p : pilot) {
        points.push_back(toUnit(frame_, p));
        bounds_.Add(points.back());
    }
    isFlat_ = neuralmesh::isFlat(points);
}

std::vector<vcg::Point3d> ImplicitSampler::drawPilot(const Progress &progress)
{
    Random random(0); // where the surface is does not depend on the seed
    std::vector<vcg::Point3d> points;
    std::size_t lines = 0;
    for (; points.size() < pilotSamples && lines < pilotLines; ++lines) {
        if (lines % linesPerReport == 0)
            report(progress, static_cast<double>(lines) / static_cast<double>(pilotLines),
                   "Looking for the surface");
        intersectRandomLine(random, points);
    }
    if (points.empty())
        throw noSurface(function_);
    if (static_cast<double>(points.size()) < leastHit * static_cast<double>(lines))
        throw tooSmall(function_);
    linesPerSample_ = static_cast<double>(lines) / static_cast<double>(points.size());
    return points;
}

void ImplicitSampler::intersectRandomLine(Random &random, std::vector<vcg::Point3d> &points) const
{
    const SurfaceCell &cell =
        cells_.cells[static_cast<std::size_t>(random.below(cells_.cells.size()))];
    const Line line = randomLineThrough(cell.lowest, cells_.size, random);
    vcg::Box3d cube(cell.lowest, cell.lowest + vcg::Point3d(cells_.size, cells_.size, cells_.size));
    cube.Intersect(cells_.box); // the last ones reach over it
    const Stretch stretch = clip(line, cube);
    const auto value = [&](double t) { return function_.at(line.origin + line.direction * t); };
    if (!(stretch.from < stretch.to))
        return;
    Bracket bracket{0, stretch.from, 0, value(stretch.from)};
    while (bracket.b < stretch.to) {
        // Further where the function is far from zero.
        const double step = std::max(stepOfCube * cells_.size, std::abs(bracket.high) / cell.slope);
        bracket = {bracket.b, std::min(bracket.b + step, stretch.to), bracket.high, 0};
        bracket.high = value(bracket.b);
        if ((bracket.low < 0) == (bracket.high < 0))
            continue;
        const double root = findRoot(value, bracket, rootTolerance * cells_.size);
        // At a pole, the sign changes where there is no root.
        if (std::abs(value(root)) <= std::max(std::abs(bracket.low), std::abs(bracket.high)))
            points.push_back(line.origin + line.direction * root);
    }
}

void ImplicitSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.clear();
    samples.reserve(count);
    std::vector<vcg::Point3d> points;
    double lines = mostLines * linesPerSample_ * static_cast<double>(count + 1);
    while (samples.size() < count) {
        if (lines-- < 0)
            throw tooSmall(function_);
        points.clear();
        intersectRandomLine(random, points);
        for (const vcg::Point3d &point : points)
            if (samples.size() < count)
                samples.push_back(frame_.toUnit(toPlain(point)));
    }
}

} // namespace neuralmesh
