// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/unsupported_edges.h"

#include <gtest/gtest.h>

#include "core/mesh/edge_lengths.h"
#include "core/mesh/face_table.h"
#include "core/mesh/mesh_checks.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// The target space known by samples on the vertices and on the middles of the short edges.
SampleSupport supportAtVertices(const NeuralMesh &mesh)
{
    std::vector<Point3> samples;
    Box3 bounds;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        samples.push_back(mesh.position(v));
        bounds.Add(mesh.position(v));
        for (const VertexId u : mesh.ring(v))
            if ((mesh.position(v) - mesh.position(u)).Norm() < 3)
                samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    }
    return SampleSupport(bounds, samples);
}

/// Two posts, `gap` apart and `height` levels high, wrapped by one tube of eight vertices a level,
/// seen from above. The two long sides of the tube are the web.
///
///         3 4 ============ 5
///       2                    6
///         1 0 ============ 7
void makePostsWithWeb(NeuralMesh &mesh, VertexId height, Scalar gap)
{
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    const Scalar loop[8][2] = {{1, -0.5}, {0, -0.5},  {-0.7, 0},      {0, 0.5},
                               {1, 0.5},  {gap, 0.5}, {gap + 1.7, 0}, {gap, -0.5}};
    for (VertexId level = 0; level < height; ++level)
        for (const auto &[x, y] : loop)
            points.emplace_back(x, y, static_cast<Scalar>(level));
    const auto at = [](VertexId level, VertexId place) { return level * 8 + place % 8; };
    for (VertexId level = 0; level + 1 < height; ++level)
        for (VertexId place = 0; place < 8; ++place) {
            faces.push_back({{at(level, place), at(level, place + 1), at(level + 1, place)}});
            faces.push_back(
                {{at(level, place + 1), at(level + 1, place + 1), at(level + 1, place)}});
        }
    for (VertexId place = 1; place + 1 < 8; ++place) {
        faces.push_back({{at(0, 0), at(0, place + 1), at(0, place)}});
        faces.push_back({{at(height - 1, 0), at(height - 1, place), at(height - 1, place + 1)}});
    }
    test::makeMesh(mesh, points, faces);
}

TEST(UnsupportedEdges, a_web_retracts_to_its_last_edge)
{
    // Of the 2 x 9 long edges around the loop and the diagonals between them, a tube that still
    // holds both posts together needs no more than a few at one end.
    NeuralMesh mesh;
    makePostsWithWeb(mesh, 9, 12);
    validate(mesh);
    const auto countLong = [&] {
        int count = 0;
        for (VertexId v = 0; v < mesh.idBound(); ++v)
            for (const VertexId u : mesh.ring(v))
                count += v < u && (mesh.position(v) - mesh.position(u)).Norm() > 6 ? 1 : 0;
        return count;
    };
    const int before = countLong();
    EXPECT_GT(retractWebs(mesh, supportAtVertices(mesh)), 0);
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).genus, 0);
    EXPECT_LE(countLong(), before / 3) << "of " << before;
}

TEST(UnsupportedEdges, a_regular_mesh_stays_as_it_is)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 30, 12);
    EXPECT_EQ(retractWebs(mesh, supportAtVertices(mesh)), 0);
}

TEST(UnsupportedEdges, an_edge_is_supported_by_a_sample_near_its_middle)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh); // edge 0-2 is sqrt(2) long, its middle (0.5, 0.5, 0)
    Box3 bounds;
    bounds.Add({-1, -1, -1});
    bounds.Add({1, 1, 1});
    EXPECT_TRUE(isSupported(mesh, SampleSupport(bounds, {{0.5, 0.5, 0.4}}), 0, 2));
    EXPECT_FALSE(isSupported(mesh, SampleSupport(bounds, {{0.5, 0.5, 0.5}}), 0, 2));
    const Scalar widening = 1.3;
    EXPECT_TRUE(isSupported(mesh, SampleSupport(bounds, {{0.5, 0.5, 0.5}}, widening), 0, 2));
    EXPECT_FALSE(isSupported(mesh, SampleSupport(bounds, {{0.5, 0.5, 0.6}}, widening), 0, 2));
}

TEST(UnsupportedEdges, an_edge_across_the_gap_is_overlong_and_one_along_a_post_is_not)
{
    NeuralMesh mesh;
    makePostsWithWeb(mesh, 9, 12);
    EXPECT_TRUE(isOverlong(mesh, 4 * 8 + 4, 4 * 8 + 5)); // 11 long, its ends' spacing is about 1
    EXPECT_FALSE(isOverlong(mesh, 4 * 8 + 4, 5 * 8 + 4));
}

TEST(UnsupportedEdges, spacing_is_that_of_the_three_shortest_edges)
{
    NeuralMesh mesh;
    test::makeOctahedron(mesh);
    mesh.position(2) = {0, 100, 0}; // one of the four neighbours of 0
    EXPECT_NEAR(localSpacing(mesh, 0), std::sqrt(2.0), 1e-12);
}

TEST(UnsupportedEdges, the_unsupported_share_is_that_of_the_area_without_samples)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 40, 20);
    std::vector<Point3> samples;
    Box3 bounds;
    const FaceTable faces(mesh);
    for (FaceId face = 0; face < faces.size(); ++face) {
        const Corners &c = faces.corners(face);
        const Point3 centre = (mesh.position(c[0]) + mesh.position(c[1]) + mesh.position(c[2])) / 3;
        bounds.Add(centre);
        if (centre.X() > 0)
            samples.push_back(centre);
    }
    // Of the 40 sections round the axis, the two at the border may count for either side.
    EXPECT_NEAR(unsupportedShare(mesh, SampleSupport(bounds, samples)), 0.5, 0.05);
}

} // namespace
} // namespace neuralmesh
