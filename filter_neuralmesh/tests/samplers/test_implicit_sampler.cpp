// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/implicit_sampler.h"

#include "tests/equal_area_patches.h"

namespace neuralmesh {
namespace {

const std::string sphere = "x*x + y*y + z*z - 0.5";
const std::string torus = "(sqrt(x*x + y*y) - 0.6)^2 + z*z - 0.09";

Box cube(double reach)
{
    return {{-reach, -reach, -reach}, {reach, reach, reach}};
}

ImplicitSampler surfaceOf(const std::string &text, const Box &box = cube(1))
{
    return {Expression("expr", text, "xyz"), box};
}

std::string refusal(const std::string &text, const Box &box = cube(1))
{
    try {
        surfaceOf(text, box);
    } catch (const InvalidInput &error) {
        return error.what();
    }
    return "accepted";
}

TEST(ImplicitSampler, is_uniform_by_area_on_a_sphere)
{
    test::expectUniform(surfaceOf(sphere), test::spherePatch);
}

TEST(ImplicitSampler, is_uniform_by_area_on_a_torus)
{
    test::expectUniform(surfaceOf(torus),
                        [](const vcg::Point3d &p) { return test::torusPatch(p, 0.6, 0.3); });
}

TEST(ImplicitSampler, is_uniform_where_the_surface_is_a_small_part_of_a_long_box)
{
    const Box box{{-40, -60, -3}, {30, 50, 5}};
    test::expectUniform(surfaceOf(sphere, box), test::spherePatch);
}

TEST(ImplicitSampler, is_uniform_where_the_function_is_steeper_on_one_side)
{
    test::expectUniform(surfaceOf("(x*x + y*y + z*z - 0.5) * exp(5*x)"), test::spherePatch);
}

TEST(ImplicitSampler, samples_both_sides_of_a_thin_wall_alike)
{
    // Two spheres 0.01 apart, a third of a cube of the grid.
    const ImplicitSampler sampler = surfaceOf("abs(sqrt(x*x + y*y + z*z) - 0.7) - 0.005");
    int outside = 0;
    for (const vcg::Point3d &p : test::drawWorld(sampler, 1, 100000))
        outside += p.Norm() > 0.7 ? 1 : 0;
    // Their areas are 0.705^2 : 0.695^2, and a binomial's five standard deviations are 0.008.
    EXPECT_NEAR(outside / 100000.0, 0.507, 0.008);
}

TEST(ImplicitSampler, samples_lie_on_the_surface)
{
    for (const vcg::Point3d &p : test::drawWorld(surfaceOf(sphere), 1, 10000))
        EXPECT_NEAR(p.Norm(), std::sqrt(0.5), 1e-8);
}

TEST(ImplicitSampler, the_frame_is_that_of_the_surface_not_of_the_box)
{
    const ImplicitSampler sampler = surfaceOf(sphere, cube(10));
    // 20,000 samples on a sphere leave caps of 1/20,000 of its area, 1e-4 of its radius high.
    EXPECT_NEAR(sampler.frame().diagonal(), 2 * std::sqrt(1.5), 2e-3);
    EXPECT_NEAR(toVcg(sampler.bounds()).Diag(), 1, 1e-9);
}

TEST(ImplicitSampler, leaves_out_poles_where_the_sign_changes_without_a_root)
{
    // Zero on the sphere, infinite on the plane x = 0.0123.
    for (const vcg::Point3d &p :
         test::drawWorld(surfaceOf("(x*x + y*y + z*z - 0.5) / (x - 0.0123)"), 1, 20000))
        ASSERT_NEAR(p.Norm(), std::sqrt(0.5), 1e-6);
}

TEST(ImplicitSampler, the_same_random_numbers_give_the_same_samples)
{
    EXPECT_EQ(test::drawWorld(surfaceOf(torus), 1, 1000),
              test::drawWorld(surfaceOf(torus), 1, 1000));
}

TEST(ImplicitSampler, says_what_does_not_parse_and_where)
{
    EXPECT_EQ(refusal("x*x + y*y + w"),
              "expr does not parse: Unexpected token \"w\" found at position 12.");
    EXPECT_EQ(refusal(""), "expr is empty.");
    EXPECT_EQ(refusal("(x + y"), "expr does not parse: Missing parenthesis at position 6.");
    EXPECT_EQ(refusal("x, y"), "expr must be one expression, not 2 separated by commas.");
    EXPECT_EQ(refusal("x *"), "expr does not parse: Unexpected end of expression at position 4.");
}

TEST(ImplicitSampler, refuses_boxes_without_a_surface)
{
    const std::string none =
        "No surface was found in the box: expr passes through zero nowhere that a grid of some 64 "
        "x 64 x 64 cubes shows. If the surface is smaller than a cube, make the box fit it.";
    EXPECT_EQ(refusal("x*x + y*y + z*z + 1"), none);
    EXPECT_EQ(refusal("0"), none);
    EXPECT_EQ(refusal(sphere, {{1, 1, 1}, {2, 2, 2}}), none);
    EXPECT_EQ(refusal("1 / (x - 0.01)"), none); // a pole
    EXPECT_EQ(refusal(sphere, {{-1, 1, -1}, {1, -1, 1}}),
              "The range of y is empty: its lower end must be below its upper end.");
    EXPECT_EQ(refusal(sphere, {{-1, -1, -1}, {1, 1, INFINITY}}),
              "The range of z has an end or a length that is not finite.");
    // A tube a million long: each cube of its box is wider than it.
    EXPECT_EQ(refusal("x*x + z*z - 0.3", {{-1e6, -1e6, -1e6}, {1e6, 1e6, 1e6}}), none);
}

TEST(ImplicitSampler, refuses_at_once_a_surface_that_next_to_no_line_meets)
{
    // Nearly zero in a fifth of the box, and zero around one place only.
    EXPECT_EQ(refusal("cos(60*x) + 1.02 - 3*exp(-600*(x*x + y*y + z*z))"),
              "The surface of expr is too small a part of the box to be sampled: make the box "
              "smaller.");
}

TEST(ImplicitSampler, can_be_cancelled_while_it_looks_for_the_surface)
{
    for (const int calls : {0, 5, 15}) { // among the cubes, and among the lines
        int left = calls;
        const auto stop = [&](double, const char *) { return left-- > 0; };
        EXPECT_THROW(
            ImplicitSampler(Expression("expr", sphere, "xyz"), {{-1, -1, -1}, {1, 1, 1}}, stop),
            Cancelled);
    }
}

TEST(ImplicitSampler, refuses_functions_that_are_not_finite_in_the_box_and_says_where)
{
    EXPECT_EQ(refusal("sqrt(x) - 0.1"), "expr is not finite at (-1, -1, -1), which is in the box.");
    EXPECT_EQ(refusal("x + y / (z - 1)"),
              "expr is not finite at (-1, -1, 1), which is in the box.");
}

TEST(ImplicitSampler, knows_a_plane)
{
    EXPECT_TRUE(surfaceOf("x + 0.3*y - 0.1").isFlat());
    EXPECT_FALSE(surfaceOf(sphere).isFlat());
}

} // namespace
} // namespace neuralmesh
