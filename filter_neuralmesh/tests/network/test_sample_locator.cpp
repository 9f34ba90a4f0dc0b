// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/sample_locator.h"

#include <gtest/gtest.h>

#include "core/mesh/enumeration.h"
#include "core/network/growing_network.h"
#include "neuralmesh/random.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// A torus so flat that its two sheets are closer than its vertices, shaken, so that no two
/// distances are the same.
void makeShakenTorus(NeuralMesh &mesh, Scalar shake)
{
    test::makeFlatTorus(mesh, 30, 10);
    Random random(5);
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        mesh.position(v) += Point3(random.unit(), random.unit(), random.unit()) * shake;
}

std::vector<Point3> samplesAround(const NeuralMesh &mesh, Scalar spread)
{
    Random random(6);
    std::vector<Point3> samples;
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        samples.push_back((mesh.position(a) + mesh.position(b) + mesh.position(c)) / 3 +
                          Point3(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5) *
                              spread);
    });
    return samples;
}

TEST(SampleLocator, answers_as_the_network_does)
{
    for (const Scalar shake : {0.0, 0.05, 0.5})
        for (const Scalar spread : {0.0, 0.3, 5.0}) {
            NeuralMesh mesh;
            makeShakenTorus(mesh, shake);
            Box3 bounds;
            for (const NeuralVertex &vertex : mesh.vert)
                bounds.Add(vertex.cP());
            const GrowingNetwork network(mesh, bounds, {});
            const SampleLocator locator = network.locator();
            VertexId hint = noVertex;
            for (const Point3 &sample : samplesAround(mesh, spread)) {
                const VertexId nearest = network.nearestVertex(sample);
                ASSERT_EQ(locator.nearestVertex(sample, hint), nearest) << shake << ' ' << spread;
                const StarProjection expected = network.project(nearest, sample);
                const StarProjection found = locator.project(nearest, sample);
                ASSERT_EQ(found.squaredDistance, expected.squaredDistance);
                ASSERT_EQ(found.corners[0], expected.corners[0]);
                hint = nearest;
            }
        }
}

TEST(SampleLocator, finds_the_nearest_vertex_from_any_hint)
{
    NeuralMesh mesh;
    makeShakenTorus(mesh, 0.05);
    Box3 bounds;
    for (const NeuralVertex &vertex : mesh.vert)
        bounds.Add(vertex.cP());
    const GrowingNetwork network(mesh, bounds, {});
    const SampleLocator locator = network.locator();
    const Point3 sample = mesh.position(0) * 1.01;
    for (VertexId hint = 0; hint < mesh.idBound(); ++hint)
        EXPECT_EQ(locator.nearestVertex(sample, hint), network.nearestVertex(sample)) << hint;
}

TEST(SampleLocator, looks_at_all_samples_whatever_the_number_of_threads)
{
    NeuralMesh mesh;
    makeShakenTorus(mesh, 0.05);
    std::vector<Point3> samples;
    while (samples.size() < 5 * SampleLocator::samplesOfChunk) {
        const std::vector<Point3> more = samplesAround(mesh, 0.3);
        samples.insert(samples.end(), more.begin(), more.end());
    }
    Box3 bounds;
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    for (const int threads : {1, 3}) {
        Workers workers(threads);
        const GrowingNetwork network(mesh, bounds, {}, &workers);
        const SampleLocator locator = network.locator();
        std::vector<VertexId> found(samples.size(), noVertex);
        locator.forEachNearest(workers, samples,
                               [&](std::size_t i, VertexId nearest) { found[i] = nearest; });
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_EQ(found[i], network.nearestVertex(samples[i]));
    }
}

} // namespace
} // namespace neuralmesh
