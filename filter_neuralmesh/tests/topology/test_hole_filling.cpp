// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/hole_filling.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/mesh/manifold_mesh.h"
#include "core/mesh/mesh_checks.h"

namespace neuralmesh::test {
namespace {

/// An open tube of `around` by `along` vertices, with a radius of 1 and that length.
void makeTube(NeuralMesh &mesh, int around, int along, double length)
{
    std::vector<Point3> points;
    std::vector<Corners> faces;
    const auto id = [&](int i, int j) { return static_cast<VertexId>(j * around + i % around); };
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * M_PI * i / around;
            points.emplace_back(std::cos(angle), std::sin(angle), length * j / (along - 1));
        }
    for (int j = 0; j + 1 < along; ++j)
        for (int i = 0; i < around; ++i) {
            faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
            faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
        }
    makeManifold(mesh, points, faces, Boundaries::allowed);
}

TEST(HoleFilling, closes_a_tube_at_both_ends)
{
    NeuralMesh mesh;
    makeTube(mesh, 24, 10, 3);
    ASSERT_EQ(measureTopology(mesh).boundaryLoops, 2);
    EXPECT_EQ(fillHoles(mesh), 2);
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.boundaryLoops, 0);
    EXPECT_EQ(topology.genus, 0);
    EXPECT_EQ(topology.vertices, 240); // no vertex comes
    // Flat discs: the volume of a prism of 24 sides.
    EXPECT_NEAR(signedVolume(mesh), 3 * 12 * std::sin(2 * M_PI / 24), 1e-9);
}

TEST(HoleFilling, closes_a_boundary_that_is_too_long_for_the_optimum)
{
    NeuralMesh mesh;
    makeTube(mesh, 700, 4, 0.1);
    EXPECT_EQ(fillHoles(mesh), 2);
    validate(mesh);
    EXPECT_EQ(measureTopology(mesh).boundaryLoops, 0);
    EXPECT_NEAR(signedVolume(mesh), M_PI * 0.1, 1e-3);
}

TEST(HoleFilling, leaves_holes_that_are_too_wide)
{
    NeuralMesh mesh;
    makeTube(mesh, 24, 10, 3);
    EXPECT_EQ(fillHolesUpTo(mesh, 3), 0); // each disc has an area of 3.1
    EXPECT_EQ(fillHolesUpTo(mesh, 3.2), 2);
}

TEST(HoleFilling, takes_the_outline_of_a_small_sheet_for_no_hole)
{
    NeuralMesh mesh;
    makeManifold(mesh, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                 {{{0, 1, 4}}, {{1, 2, 4}}, {{2, 3, 4}}, {{3, 0, 4}}}, Boundaries::allowed);
    EXPECT_EQ(fillHolesUpTo(mesh, 100), 0);
}

} // namespace
} // namespace neuralmesh::test
