// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/surface_sampler.h"

#include "neuralmesh/errors.h"
#include "tests/equal_area_patches.h"

namespace neuralmesh {
namespace {

using Points = test::WorldPoints;
using Faces = std::vector<Corners>;

/// A regular tetrahedron of four faces of the same area.
const Points corners{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
const Faces sides{{{0, 1, 2}}, {{0, 3, 1}}, {{0, 2, 3}}, {{1, 3, 2}}};

/// The same surface from faces of very different size: each side is divided at a point of its own,
/// and there are faces without area, which are never to be drawn.
void divide(Points &points, Faces &faces)
{
    points = corners;
    const double shares[4][3] = {
        {0.8, 0.1, 0.1}, {0.3, 0.3, 0.4}, {0.01, 0.01, 0.98}, {0.05, 0.9, 0.05}};
    for (std::size_t side = 0; side < 4; ++side) {
        const Corners &f = sides[side];
        const auto middle = static_cast<VertexId>(points.size());
        points.push_back(corners[f[0]] * shares[side][0] + corners[f[1]] * shares[side][1] +
                         corners[f[2]] * shares[side][2]);
        for (std::size_t c = 0; c < 3; ++c)
            faces.push_back({{f[c], f[(c + 1) % 3], middle}});
    }
    faces.push_back({{0, 0, 1}});
    faces.push_back({{2, 1, 2}});
}

/// Each side's triangle cut into 16 by lines parallel to its edges.
int tetrahedronPatch(const vcg::Point3d &p)
{
    // The weights of the corners, of which the one opposite to p's side is the least: 0.
    std::array<double, 4> w;
    for (std::size_t i = 0; i < 4; ++i)
        w[i] = 0.25 * (1 + p * corners[i]);
    const auto side = std::min_element(w.begin(), w.end()) - w.begin();
    std::array<int, 3> strip{};
    std::size_t at = 0;
    for (std::size_t i = 0; i < 4; ++i)
        if (static_cast<std::ptrdiff_t>(i) != side)
            strip[at++] = std::min(3, std::max(0, static_cast<int>(4 * w[i])));
    // In strip k of the first there are 7 - 2k triangles, upright ones and others in turns.
    const int first[4] = {0, 7, 12, 15};
    const bool isUpright = strip[0] + strip[1] + strip[2] == 3;
    return 16 * static_cast<int>(side) + first[strip[0]] + 2 * strip[1] + (isUpright ? 0 : 1);
}

std::string refusal(const Points &points, const Faces &faces,
                    const std::vector<double> &density = {})
{
    try {
        const SurfaceSampler sampler(points, faces, density);
    } catch (const InvalidInput &error) {
        return error.what();
    }
    return "accepted";
}

TEST(SurfaceSampler, is_uniform_by_area_whatever_the_size_of_the_faces)
{
    Points points;
    Faces faces;
    divide(points, faces);
    test::expectUniform(SurfaceSampler(points, faces), tetrahedronPatch);
}

TEST(SurfaceSampler, follows_a_density_that_is_linear_on_each_face)
{
    // Density 1 at corner 0, 0 at the others: on the three sides around it, the weight of corner 0
    // has density 6 w (1 - w), so its mean is 1/2, and that of its square 0.3.
    const SurfaceSampler sampler(corners, sides, {1, 0, 0, 0});
    const int count = 100000;
    double sum = 0;
    double squares = 0;
    double other = 0;
    for (const vcg::Point3d &p : test::drawWorld(sampler, 1, count)) {
        const double weight = 0.25 * (1 + p * corners[0]);
        sum += weight / count;
        squares += weight * weight / count;
        other += 0.25 * (1 + p * corners[1]) / count;
    }
    // Five standard deviations of the means: sqrt(0.05 / 1e5) = 0.0007 and less.
    EXPECT_NEAR(sum, 0.5, 0.0035);
    EXPECT_NEAR(squares, 0.3, 0.0045);
    EXPECT_NEAR(other, 0.5 / 3, 0.0035);
}

TEST(SurfaceSampler, points_without_faces_do_not_widen_the_frame)
{
    Points points = corners;
    points.emplace_back(100, 100, 100);
    EXPECT_NEAR(SurfaceSampler(points, sides).frame().diagonal(), std::sqrt(12), 1e-12);
}

TEST(SurfaceSampler, has_more_points_than_any_network_asks_for)
{
    EXPECT_EQ(SurfaceSampler(corners, sides).countDistinctPoints(1000000), 1000000U);
}

TEST(SurfaceSampler, refuses_what_has_no_area)
{
    EXPECT_EQ(refusal(corners, {}), "There are no faces to sample.");
    EXPECT_EQ(refusal(corners, {{{0, 0, 1}}, {{2, 3, 2}}}),
              "All faces are without area: there is no surface to sample.");
    EXPECT_TRUE(SurfaceSampler(corners, {{{0, 1, 2}}, {{0, 1, 2}}}).isFlat());
    EXPECT_FALSE(SurfaceSampler(corners, sides).isFlat());
    EXPECT_EQ(refusal(corners, {{{0, 1, 2}}}, {0, 0, 0, 1}),
              "No face has both an area and a density above 0.");
    Points broken = corners;
    broken[2].Y() = std::nan("");
    EXPECT_EQ(refusal(broken, sides), "1 of 4 points have coordinates that are NaN or infinite "
                                      "(the first is point 2). Remove them and try again.");
}

} // namespace
} // namespace neuralmesh
