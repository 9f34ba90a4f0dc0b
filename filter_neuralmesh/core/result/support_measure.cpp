// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/result/support_measure.h"

#include <algorithm>

#include "core/mesh/enumeration.h"
#include "core/mesh/triangle.h"
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

/// Samples of a surface within two of their spacings of one of them: 4 π and itself.
constexpr int samplesNearby = 13;

/// Where samples are sparse, a place may be as far from them as twice their spacing there.
bool isFarFromAll(const SampleSupport &support, const Point3 &place, double far)
{
    if (support.hasWithin(place, far))
        return false;
    const Point3 &nearest = support.nearest(place);
    return support.hasWithin(nearest, (nearest - place).Norm(), samplesNearby);
}

double unsupportedShareOfArea(const NeuralMesh &mesh, const SampleSupport &support, double far)
{
    double all = 0;
    double unsupported = 0;
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        const Triangle t{mesh.position(a), mesh.position(b), mesh.position(c)};
        const double faceArea = area(t);
        all += faceArea;
        if (isFarFromAll(support, (t.a + t.b + t.c) / 3, far))
            unsupported += faceArea;
    });
    return all > 0 ? unsupported / all : 0;
}

} // namespace

SupportFigures supportOf(const GrowingNetwork &network, const SampleDistances &distances,
                         std::size_t points)
{
    const double far =
        meanEdgeLength(network.mesh()) * wideningForFewPoints(points, network.vertexCount());
    const auto near = std::count_if(distances.squared.begin(), distances.squared.end(),
                                    [&](Scalar squared) { return squared <= far * far; });
    Box3 bounds;
    for (const Point3 &sample : distances.samples)
        bounds.Add(sample);
    const SampleSupport support(bounds, distances.samples, 1, network.workers().watch());
    return {static_cast<double>(near) / static_cast<double>(distances.samples.size()),
            unsupportedShareOfArea(network.mesh(), support, far)};
}

} // namespace neuralmesh
