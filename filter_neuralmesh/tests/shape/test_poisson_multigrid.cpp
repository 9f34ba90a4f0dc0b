// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/poisson_multigrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/shape/grid_filters.h"
#include "core/shape/grid_place.h"
#include "tests/points_for_tests.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

using Held = std::vector<unsigned char>;

const GridSize cube = test::cube(32);

/// Product of sines with `waves` half-waves along x and one along y and z: an eigenvector of the
/// seven-point Laplacian with zero border, so that its solution is known without discretisation
/// error.
Grid sines(const GridSize &cells, int waves)
{
    Grid u(cells);
    test::forEachNode(u, [&](int x, int y, int z) {
        if (test::isInner(u, x, y, z))
            u.at(x, y, z) =
                static_cast<float>(std::sin(M_PI * waves * x / cells.x) *
                                   std::sin(M_PI * y / cells.y) * std::sin(M_PI * z / cells.z));
    });
    return u;
}

/// Of -Δ, for the product of sines.
double eigenvalue(const GridSize &cells, int waves)
{
    return 6 - 2 * (std::cos(M_PI * waves / cells.x) + std::cos(M_PI / cells.y) +
                    std::cos(M_PI / cells.z));
}

Grid scaled(Grid grid, double factor)
{
    for (std::size_t i = 0; i < grid.size(); ++i)
        grid[i] = static_cast<float>(static_cast<double>(grid[i]) * factor);
    return grid;
}

double largestDifference(const Grid &a, const Grid &b)
{
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest =
            std::max(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    return largest;
}

double distance(const Grid &a, const Grid &b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::pow(static_cast<double>(a[i]) - static_cast<double>(b[i]), 2);
    return std::sqrt(sum);
}

/// -Δu - f at the inner nodes that are not held, the largest.
double largestResidual(const Grid &u, const Grid &f, const Held &held)
{
    double largest = 0;
    test::forEachNode(u, [&](int x, int y, int z) {
        if (!test::isInner(u, x, y, z) || held[u.index(x, y, z)] != 0)
            return;
        const float r = 6 * u.at(x, y, z) - u.at(x - 1, y, z) - u.at(x + 1, y, z) -
                        u.at(x, y - 1, z) - u.at(x, y + 1, z) - u.at(x, y, z - 1) -
                        u.at(x, y, z + 1) - f.at(x, y, z);
        largest = std::max(largest, static_cast<double>(std::abs(r)));
    });
    return largest;
}

TEST(PoissonMultigrid, solves_for_a_product_of_sines)
{
    for (const GridSize &cells : {test::cube(4), test::cube(8), cube, GridSize{32, 16, 24}})
        for (const int waves : {1, 3}) {
            const Grid solution = sines(cells, waves);
            Grid u(cells);
            PoissonMultigrid(cells, alone).solve(u, scaled(solution, eigenvalue(cells, waves)), 12);
            // Single precision: the smallest eigenvalue, 3 π² / cells², lifts rounding errors.
            EXPECT_LT(largestDifference(u, solution), 1e-4)
                << cells.x << ' ' << cells.y << ' ' << cells.z << ", waves " << waves;
        }
}

TEST(PoissonMultigrid, leaves_at_most_a_fifth_of_the_error_a_cycle)
{
    for (const GridSize &cells : {cube, GridSize{32, 16, 24}}) {
        const PoissonMultigrid solver(cells, alone);
        const Grid f = test::noise(cells, 1, 1);
        Grid solution(cells);
        solver.solve(solution, f, 30);
        Grid u = test::noise(cells, 2, 1);
        double before = distance(u, solution);
        for (int cycle = 0; cycle < 4; ++cycle) {
            solver.solve(u, f, 1);
            const double after = distance(u, solution);
            EXPECT_LT(after, 0.2 * before) << "cycle " << cycle << ", " << cells.y;
            before = after;
        }
    }
}

TEST(PoissonMultigrid, holds_a_wall_at_zero)
{
    // A wall across the middle: to both sides of it, the solution is that of a box of its own.
    const Grid waves = sines(cube, 2);
    Grid solution = waves;
    Held held(waves.size(), 0);
    test::forEachNode(waves, [&](int x, int y, int z) {
        solution.at(x, y, z) = std::abs(waves.at(x, y, z));
        held[waves.index(x, y, z)] = x == cube.x / 2 ? 1 : 0;
    });
    const Grid f = scaled(solution, eigenvalue(cube, 2));
    PoissonMultigrid solver(cube, alone);
    solver.hold(held);
    Grid u(cube);
    solver.solve(u, f, 12);
    EXPECT_LT(largestDifference(u, solution), 1e-4);
    PoissonMultigrid(cube, alone).solve(u, f, 12);
    EXPECT_GT(largestDifference(u, solution), 0.1) << "The wall is not what makes the difference.";
}

TEST(PoissonMultigrid, converges_beside_a_wall_between_the_planes_of_the_coarser_grid)
{
    // A coarser grid that does not feel the wall corrects across it, by more than the error.
    const Grid f(cube, 1);
    Held held(f.size(), 0);
    test::forEachNode(
        f, [&](int x, int y, int z) { held[f.index(x, y, z)] = x == cube.x / 2 + 1 ? 1 : 0; });
    PoissonMultigrid solver(cube, alone);
    solver.hold(held);
    Grid u(cube);
    solver.solve(u, f, 30);
    EXPECT_LT(largestResidual(u, f, held), 1e-3);
}

TEST(PoissonMultigrid, converges_around_nodes_that_coarse_grids_do_not_see)
{
    // Half of these nodes have odd coordinates, so that no coarser grid holds them.
    Random random(3);
    const Grid f = test::noise(cube, 4, 1);
    Held held(f.size(), 0);
    for (unsigned char &isHeld : held)
        isHeld = random.unit() < 0.02 ? 1 : 0;
    PoissonMultigrid solver(cube, alone);
    solver.hold(held);
    Grid u(cube);
    solver.solve(u, f, 30);
    EXPECT_LT(largestResidual(u, f, held), 1e-4);
    for (std::size_t i = 0; i < held.size(); ++i)
        if (held[i] != 0) {
            EXPECT_EQ(u[i], 0) << i;
        }
}

/// Sources as those of a winding field, on a grid that is worked on around them alone: the
/// divergence of a sphere's normals, smoothed twice.
struct SphereOfSources {
    static constexpr int smoothings = 2;

    SphereOfSources() : f(fineCube)
    {
        const test::WorldPoints directions = test::spherePoints(20000, 1);
        std::vector<std::uint32_t> cells;
        for (const Point3 &direction : directions) {
            const GridPlace place = placeInGrid(f, Point3(0.5, 0.5, 0.5) + direction * radius);
            cells.push_back(place.node);
            const double area = 4 * M_PI * std::pow(radius * fineCube.x, 2) / 20000;
            splatDivergence(f, place, vcg::Point3f::Construct(direction * area));
        }
        std::sort(cells.begin(), cells.end());
        nodes = NodeSpans(fineCube, cells, smoothings + reachOfDivergence);
        smooth(alone, f, NodeSpans(fineCube), smoothings);
    }

    static constexpr double radius = 0.3;
    static constexpr GridSize fineCube{64, 64, 64};
    Grid f;
    NodeSpans nodes;
};

TEST(PoissonMultigrid, spans_around_places_hold_all_that_their_smoothed_sources_reach)
{
    const SphereOfSources sphere;
    const Held isIn = test::marked(sphere.nodes, sphere.fineCube);
    for (std::size_t i = 0; i < isIn.size(); ++i)
        if (isIn[i] == 0) {
            ASSERT_EQ(sphere.f[i], 0) << i;
        }
    EXPECT_LT(sphere.nodes.size(), sphere.f.size() / 3);
}

TEST(PoissonMultigrid, around_sources_alone_is_nearly_as_exact_as_everywhere)
{
    const SphereOfSources sphere;
    Grid everywhere(sphere.fineCube);
    PoissonMultigrid solver(sphere.fineCube, alone);
    solver.solve(everywhere, sphere.f, 12);
    Grid around(sphere.fineCube);
    solver.workAround(sphere.nodes);
    solver.solve(around, sphere.f, 12);
    const Held isIn = test::marked(sphere.nodes, sphere.fineCube);
    double near = 0;
    double far = 0;
    for (std::size_t i = 0; i < isIn.size(); ++i) {
        double &largest = isIn[i] != 0 ? near : far;
        largest = std::max(largest, static_cast<double>(std::abs(around[i] - everywhere[i])));
    }
    // 0.028 and, just beyond the nodes, 0.051; 0.012 and 0.034 around these nodes and one more.
    EXPECT_LT(near, 0.04);
    EXPECT_LT(far, 0.07);
}

} // namespace
} // namespace neuralmesh
