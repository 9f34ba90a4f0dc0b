// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/marching_tetrahedra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/manifold_mesh.h"
#include "core/mesh/mesh_checks.h"
#include "core/shape/grid_filters.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

const Point3 centre(0.5, 0.5, 0.5);
const GridSize usual = test::cube(32);

Grid sphere(const GridSize &cells, double radius, const Point3 &middle)
{
    return test::sampled(cells, [&](const Point3 &p) { return radius - (p - middle).Norm(); });
}

TriangleSoup march(const Grid &f, float level = 0)
{
    return marchTetrahedra(f, level, cellsBetween(f, level, level));
}

TopologyFigures march(const Grid &f, NeuralMesh &mesh)
{
    const TriangleSoup soup = march(f);
    makeManifold(mesh, soup.points, soup.faces);
    validate(mesh);
    return measureTopology(mesh);
}

TEST(MarchingTetrahedra, makes_a_sphere_that_faces_outwards)
{
    constexpr double radius = 0.3;
    NeuralMesh mesh;
    const TopologyFigures figures = march(sphere(usual, radius, centre), mesh);
    EXPECT_EQ(figures.components, 1);
    EXPECT_EQ(figures.genus, 0);
    // An edge of a tetrahedron is at most √3 cells long; linear interpolation along it misses the
    // sphere by an eighth of its square over the radius.
    constexpr double bound = 3.0 / (32 * 32) / (8 * radius);
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        EXPECT_NEAR((mesh.position(v) - centre).Norm(), radius, 1.1 * bound);
    const double volume = 4 * M_PI / 3 * std::pow(radius, 3);
    // Each face lies inside by as much again.
    EXPECT_NEAR(signedVolume(mesh), volume, 2 * bound * 4 * M_PI * radius * radius);
}

TEST(MarchingTetrahedra, makes_the_same_sphere_in_a_box_that_is_no_cube)
{
    constexpr double radius = 0.15;
    const Point3 middle(0.5, 0.25, 0.75);
    for (const GridSize &cells : {GridSize{32, 16, 32}, GridSize{24, 16, 32}}) {
        NeuralMesh mesh;
        const Point3 inBox = cells.x == 24 ? Point3(0.375, 0.25, 0.5) : middle;
        const TopologyFigures figures = march(sphere(cells, radius, inBox), mesh);
        EXPECT_EQ(figures.components, 1);
        EXPECT_EQ(figures.genus, 0);
        constexpr double bound = 3.0 / (32 * 32) / (8 * radius); // as above
        for (VertexId v = 0; v < mesh.idBound(); ++v)
            EXPECT_NEAR((mesh.position(v) - inBox).Norm(), radius, 1.1 * bound);
        EXPECT_GT(signedVolume(mesh), 0);
    }
}

TEST(MarchingTetrahedra, keeps_the_handle_of_a_torus)
{
    const Grid torus = test::sampled(usual, [](const Point3 &p) {
        const Point3 q = p - centre;
        return 0.1 - std::hypot(std::hypot(q.X(), q.Y()) - 0.25, q.Z());
    });
    NeuralMesh mesh;
    const TopologyFigures figures = march(torus, mesh);
    EXPECT_EQ(figures.components, 1);
    EXPECT_EQ(figures.genus, 1);
    EXPECT_GT(signedVolume(mesh), 0);
}

TEST(MarchingTetrahedra, keeps_parts_apart_and_cavities_inside_out)
{
    NeuralMesh mesh;
    const Grid apart = test::sampled(usual, [](const Point3 &p) {
        return 0.15 -
               std::min((p - Point3(0.3, 0.5, 0.5)).Norm(), (p - Point3(0.7, 0.5, 0.5)).Norm());
    });
    EXPECT_EQ(march(apart, mesh).components, 2);

    const Grid shell = test::sampled(
        usual, [](const Point3 &p) { return 0.08 - std::abs((p - centre).Norm() - 0.3); });
    EXPECT_EQ(march(shell, mesh).components, 2);
    // The cavity's surface faces into it.
    const double volume = 4 * M_PI / 3 * (std::pow(0.38, 3) - std::pow(0.22, 3));
    EXPECT_NEAR(signedVolume(mesh), volume, 0.02 * volume);
}

TEST(MarchingTetrahedra, makes_nothing_of_a_field_without_an_inside)
{
    EXPECT_TRUE(march(Grid(test::cube(8), -1)).faces.empty());
    EXPECT_TRUE(march(Grid(test::cube(8), 0)).faces.empty());
}

TEST(MarchingTetrahedra, makes_the_same_of_the_cells_of_many_levels_as_of_those_of_one)
{
    const Grid f = sphere(usual, 0.3, centre);
    const std::vector<std::uint32_t> cells = cellsBetween(f, -0.05F, 0.05F);
    EXPECT_LT(cells.size(), 32U * 32 * 32 / 2) << "All cells are taken, so that none is chosen.";
    for (const float level : {-0.05F, 0.0F, 0.05F}) {
        const TriangleSoup one = march(f, level);
        const TriangleSoup many = marchTetrahedra(f, level, cells);
        EXPECT_FALSE(one.faces.empty());
        EXPECT_EQ(many.faces, one.faces) << level;
        EXPECT_EQ(many.points, one.points) << level;
    }
}

TEST(MarchingTetrahedra, makes_a_closed_manifold_of_any_field)
{
    // Noise, the same smoothed, and small whole numbers, of which many are exactly 0.
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const GridSize cells{6, 8, 10};
        Grid f = test::noise(cells, seed, 1);
        if (seed % 3 == 0)
            for (std::size_t i = 0; i < f.size(); ++i)
                f[i] = std::round(1.5F * f[i]);
        if (seed % 3 == 1)
            smooth(alone, f, NodeSpans(f.cells()), 1);
        test::forEachNode(f, [&](int x, int y, int z) {
            if (!test::isInner(f, x, y, z))
                f.at(x, y, z) = -1;
        });
        NeuralMesh mesh;
        EXPECT_NO_THROW(march(f, mesh)) << "seed " << seed;
        EXPECT_GT(signedVolume(mesh), 0) << "seed " << seed;
    }
}

} // namespace
} // namespace neuralmesh
