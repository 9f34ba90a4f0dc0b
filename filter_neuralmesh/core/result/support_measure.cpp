// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/support_measure.h"

#include <vector>

#include "core/mesh/enumeration.h"
#include "core/mesh/triangle.h"
#include "core/space/morton_order.h"
#include "core/space/plain_points.h"
#include "core/space/point_spacing.h"
#include "core/topology/sample_support.h"

namespace neuralmesh {
namespace {

double meanEdgeLength(const NeuralMesh &mesh)
{
    double sum = 0;
    int edges = 0;
    forEachEdge(mesh, [&](VertexId v, VertexId u) {
        sum += (mesh.position(v) - mesh.position(u)).Norm();
        ++edges;
    });
    return edges > 0 ? sum / edges : 0;
}

double unsupportedShareOfArea(const NeuralMesh &mesh, const SampleSupport &support, double far)
{
    double all = 0;
    double unsupported = 0;
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        const Triangle t{mesh.position(a), mesh.position(b), mesh.position(c)};
        const double faceArea = area(t);
        all += faceArea;
        if (!support.hasWithin((t.a + t.b + t.c) / 3, far))
            unsupported += faceArea;
    });
    return all > 0 ? unsupported / all : 0;
}

} // namespace

SupportFigures measureSupport(const GrowingNetwork &network, const Sampler &sampler, Random &random,
                              std::size_t samplesPerVertex)
{
    std::vector<Point> drawn;
    sampler.draw(random, samplesPerVertex * static_cast<std::size_t>(network.vertexCount()), drawn);
    std::vector<Point3> samples;
    MortonOrder(sampler.bounds()).sort(drawn, samples);
    const double far = meanEdgeLength(network.mesh()) *
                       wideningForFewPoints(sampler.pointCount(), network.vertexCount());
    std::size_t near = 0;
    VertexId nearest = noVertex;
    for (const Point3 &sample : samples) {
        nearest = network.nearestVertex(sample, nearest);
        near += network.projectExactly(nearest, sample).squaredDistance <= far * far ? 1 : 0;
    }
    const SampleSupport support(toVcg(sampler.bounds()), samples);
    return {static_cast<double>(near) / static_cast<double>(samples.size()),
            unsupportedShareOfArea(network.mesh(), support, far)};
}

} // namespace neuralmesh
