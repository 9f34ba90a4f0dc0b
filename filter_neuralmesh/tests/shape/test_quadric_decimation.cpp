// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/quadric_decimation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/enumeration.h"
#include "core/mesh/manifold_mesh.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "core/shape/marching_tetrahedra.h"
#include "tests/meshes_for_tests.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

const Point3 centre(0.5, 0.5, 0.5);

/// The level set {f > 0}: 32 cells, so some thousand vertices, with the slivers that marching
/// tetrahedra make.
template <class Function> void makeLevelSet(NeuralMesh &mesh, const Function &f)
{
    const Grid grid = test::sampled(test::cube(32), f);
    const TriangleSoup soup = marchTetrahedra(grid, 0, cellsBetween(grid, 0, 0));
    makeManifold(mesh, soup.points, soup.faces);
}

/// Calls visit(a, b, c) with the corners' positions of each face.
template <class Visit> void forEachTriangle(const NeuralMesh &mesh, const Visit &visit)
{
    forEachFace(mesh, [&](VertexId a, VertexId b, VertexId c) {
        visit(mesh.position(a), mesh.position(b), mesh.position(c));
    });
}

TEST(QuadricDecimation, leaves_the_vertices_asked_for_and_the_handle)
{
    NeuralMesh mesh;
    makeLevelSet(mesh, [](const Point3 &p) {
        const Point3 q = p - centre;
        return 0.1 - std::hypot(std::hypot(q.X(), q.Y()) - 0.25, q.Z());
    });
    for (const int vertices : {1000, 200, 50}) {
        decimate(mesh, vertices);
        validate(mesh);
        const TopologyFigures figures = measureTopology(mesh);
        EXPECT_EQ(figures.vertices, vertices);
        EXPECT_EQ(mesh.idBound(), static_cast<VertexId>(vertices));
        EXPECT_EQ(figures.components, 1);
        EXPECT_EQ(figures.genus, 1);
    }
}

TEST(QuadricDecimation, stops_where_no_edge_may_collapse)
{
    // The least closed mesh of genus 0 has four vertices, that of genus 1 seven.
    NeuralMesh mesh;
    makeLevelSet(mesh, [](const Point3 &p) { return 0.3 - (p - centre).Norm(); });
    decimate(mesh, 1);
    validate(mesh);
    EXPECT_EQ(mesh.vn, 4);

    test::makeTorus(mesh, 12, 12);
    decimate(mesh, 1);
    validate(mesh);
    EXPECT_GE(mesh.vn, 7);
    EXPECT_LE(mesh.vn, 20); // 14: more where a collapse would turn a face
    EXPECT_EQ(measureTopology(mesh).genus, 1);
}

TEST(QuadricDecimation, stays_near_a_sphere_and_turns_no_face)
{
    constexpr double radius = 0.3;
    constexpr int vertices = 200;
    NeuralMesh mesh;
    makeLevelSet(mesh, [](const Point3 &p) { return radius - (p - centre).Norm(); });
    decimate(mesh, vertices);
    ASSERT_EQ(mesh.vn, vertices);
    // Of 2 × 200 equal triangles on a sphere of radius r, an edge is r √(8π / (√3 400)) long; the
    // middle of a face lies a sixth of its square over r below the sphere. Vertices that were the
    // middles of edges lie below it too, and faces are not equal: 5.4 times that.
    constexpr double sagitta = radius * 8 * M_PI / (1.732 * 2 * vertices) / 6;
    double deepest = 0;
    double leastCosine = 1;
    forEachTriangle(mesh, [&](const Point3 &a, const Point3 &b, const Point3 &c) {
        const Point3 middle = (a + b + c) / 3 - centre;
        deepest = std::max(deepest, std::abs(middle.Norm() - radius));
        leastCosine =
            std::min(leastCosine, ((b - a) ^ (c - a)).Normalize() * (middle / middle.Norm()));
    });
    EXPECT_LT(deepest, 6 * sagitta);
    EXPECT_GT(leastCosine, 0.85); // 0.91
}

TEST(QuadricDecimation, spreads_vertices_evenly_where_the_surface_is_flat)
{
    NeuralMesh mesh;
    makeLevelSet(mesh, [](const Point3 &p) {
        const Point3 q = p - centre;
        return 0.3 - std::max({std::abs(q.X()), std::abs(q.Y()), std::abs(q.Z())});
    });
    decimate(mesh, 300);
    ASSERT_EQ(mesh.vn, 300);
    double longest = 0;
    forEachTriangle(mesh, [&](const Point3 &a, const Point3 &b, const Point3 &c) {
        longest = std::max({longest, (a - b).Norm(), (b - c).Norm(), (c - a).Norm()});
    });
    // Six sides of 0.6 shared out to 596 equal triangles have edges of 0.09; the longest, along a
    // side's rim, is 0.44. By the quadric error alone it is 0.71.
    EXPECT_LT(longest, 0.5);
}

TEST(QuadricDecimation, keeps_the_place_of_a_boundary)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 20);
    decimate(mesh, 40);
    ASSERT_EQ(mesh.vn, 40);
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 1);
    double area = 0;
    forEachTriangle(mesh, [&](const Point3 &a, const Point3 &b, const Point3 &c) {
        area += ((b - a) ^ (c - a)).Norm() / 2;
    });
    EXPECT_DOUBLE_EQ(area, 400);
}

} // namespace
} // namespace neuralmesh
