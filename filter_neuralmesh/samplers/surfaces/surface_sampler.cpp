// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/surface_sampler.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/triangle.h"
#include "neuralmesh/sampler_errors.h"
#include "samplers/input_checks.h"

namespace neuralmesh {
namespace {

using Weights = std::array<double, 3>;

/// Uniform in the triangle (Turk 1990).
Weights drawUniform(Random &random)
{
    const double root = std::sqrt(random.unit());
    const double share = random.unit();
    return {1 - root, root * (1 - share), root * share};
}

/// In proportion to a density that is linear on the triangle. That is a mixture of three, each
/// nothing but its corner's weight, which has the law of two of the four gaps that three uniform
/// numbers leave.
Weights drawLinear(const Weights &density, Random &random)
{
    double place = random.unit() * (density[0] + density[1] + density[2]);
    std::size_t corner = 0;
    while (corner < 2 && place >= density[corner])
        place -= density[corner++];
    std::array<double, 3> cuts{random.unit(), random.unit(), random.unit()};
    std::sort(cuts.begin(), cuts.end());
    Weights weights;
    weights[corner] = cuts[1];
    weights[(corner + 1) % 3] = cuts[2] - cuts[1];
    weights[(corner + 2) % 3] = 1 - cuts[2];
    return weights;
}

} // namespace

SurfaceSampler::SurfaceSampler(const std::vector<Point> &world, const std::vector<Corners> &faces,
                               const std::vector<double> &density)
    : density_(densityShares(density, world.size()))
{
    requireFinite(world);
    vcg::Box3d worldBounds;
    for (const Corners &face : faces)
        for (const VertexId v : face)
            worldBounds.Add(toVcg(world[v]));
    if (faces.empty())
        throw InvalidInput("There are no faces to sample.");
    frame_ = frameOf(worldBounds);
    for (const Point &p : world)
        points_.push_back(toVcg(frame_.toUnit(p)));

    std::vector<double> weights;
    std::vector<Point3> corners;
    for (const Corners &face : faces) {
        double weight = area({points_[face[0]], points_[face[1]], points_[face[2]]});
        if (!density_.empty())
            weight *= density_[face[0]] / 3 + density_[face[1]] / 3 + density_[face[2]] / 3;
        if (!(weight > 0))
            continue;
        faces_.push_back(face);
        weights.push_back(weight);
        for (const VertexId v : face) {
            bounds_.Add(points_[v]);
            corners.push_back(points_[v]);
        }
    }
    if (faces_.empty() && !density_.empty())
        throw InvalidDensity(InvalidDensity::Problem::noFace);
    if (faces_.empty())
        throw InvalidInput("All faces are without area: there is no surface to sample.");
    isFlat_ = neuralmesh::isFlat(corners);
    table_ = AliasTable(weights);
}

void SurfaceSampler::draw(Random &random, std::size_t count, std::vector<Point> &samples) const
{
    samples.resize(count);
    for (Point &sample : samples) {
        const Corners &face = faces_[table_.draw(random)];
        const Weights w =
            density_.empty()
                ? drawUniform(random)
                : drawLinear({density_[face[0]], density_[face[1]], density_[face[2]]}, random);
        sample =
            toPlain(points_[face[0]] * w[0] + points_[face[1]] * w[1] + points_[face[2]] * w[2]);
    }
}

} // namespace neuralmesh
