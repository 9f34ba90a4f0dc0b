// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/samplers.h"

#include <algorithm>

#include "neuralmesh/errors.h"
#include "samplers/files/point_file_sampler.h"
#include "samplers/points/point_cloud_sampler.h"
#include "samplers/surfaces/implicit_sampler.h"
#include "samplers/surfaces/parametric_sampler.h"
#include "samplers/surfaces/surface_sampler.h"

namespace neuralmesh {
namespace {

void requireVertices(const Mesh &mesh)
{
    for (const Corners &face : mesh.triangles)
        if (*std::max_element(face.begin(), face.end()) >= mesh.positions.size())
            throw InvalidInput("A triangle names a vertex that is not there.");
}

Expression expressionOf(const Formula &formula, const char *variables)
{
    return {formula.name, formula.text, variables};
}

} // namespace

std::unique_ptr<Sampler> pointCloudSampler(std::vector<Point> points,
                                           const std::vector<double> &density)
{
    return std::make_unique<PointCloudSampler>(std::move(points), density);
}

std::unique_ptr<Sampler> pointFileSampler(const std::string &path, const Progress &progress)
{
    return std::make_unique<PointFileSampler>(path, progress);
}

std::unique_ptr<Sampler> surfaceSampler(const Mesh &mesh, const std::vector<double> &density)
{
    requireVertices(mesh);
    return std::make_unique<SurfaceSampler>(mesh.positions, mesh.triangles, density);
}

std::unique_ptr<Sampler> implicitSurfaceSampler(const Formula &function, const Box &box,
                                                const Progress &progress)
{
    return std::make_unique<ImplicitSampler>(expressionOf(function, "xyz"), box, progress);
}

std::unique_ptr<Sampler> parametricSurfaceSampler(const std::array<Formula, 3> &coordinates,
                                                  Range u, Range v, const Progress &progress)
{
    // The first of several that do not parse is named: initialisers in braces come in order.
    std::array<Expression, 3> expressions{expressionOf(coordinates[0], "uv"),
                                          expressionOf(coordinates[1], "uv"),
                                          expressionOf(coordinates[2], "uv")};
    return std::make_unique<ParametricSampler>(std::move(expressions), u, v, progress);
}

} // namespace neuralmesh
