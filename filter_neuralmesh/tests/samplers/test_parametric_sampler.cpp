// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/surfaces/parametric_sampler.h"

#include "neuralmesh/errors.h"
#include "tests/equal_area_patches.h"

namespace neuralmesh {
namespace {

using Texts = std::array<std::string, 3>;

constexpr Range fullTurn{0, 2 * M_PI};
constexpr Range halfTurn{0, M_PI};
const Texts sphere{"cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)"};
const Texts torus{"(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)"};

ParametricSampler surfaceOf(const Texts &texts, Range u = fullTurn, Range v = fullTurn)
{
    return {{Expression("x", texts[0], "uv"), Expression("y", texts[1], "uv"),
             Expression("z", texts[2], "uv")},
            u,
            v};
}

std::string refusal(const Texts &texts, Range u = fullTurn, Range v = fullTurn)
{
    try {
        surfaceOf(texts, u, v);
    } catch (const InvalidInput &error) {
        return error.what();
    }
    return "accepted";
}

TEST(ParametricSampler, is_uniform_by_area_on_a_sphere_with_poles)
{
    test::expectUniform(surfaceOf(sphere, fullTurn, halfTurn), test::spherePatch);
}

TEST(ParametricSampler, is_uniform_by_area_on_a_torus)
{
    test::expectUniform(surfaceOf(torus),
                        [](const vcg::Point3d &p) { return test::torusPatch(p, 2, 1); });
}

TEST(ParametricSampler, is_uniform_by_area_however_unevenly_the_parameters_run)
{
    // u^8 crowds the meridians at u = 0 by a factor of up to 8 and leaves none of them out.
    const Texts crowded{"cos(2*_pi*u^8)*sin(v)", "sin(2*_pi*u^8)*sin(v)", "cos(v)"};
    test::expectUniform(surfaceOf(crowded, {0, 1}, halfTurn), test::spherePatch);
}

TEST(ParametricSampler, samples_lie_on_the_surface_in_its_bounds)
{
    const ParametricSampler sampler = surfaceOf(torus);
    Box3 grown = toVcg(sampler.bounds());
    grown.Offset(1e-3); // the nodes of the grid miss the very ends
    for (const vcg::Point3d &p : test::drawWorld(sampler, 1, 10000)) {
        EXPECT_NEAR(std::hypot(std::hypot(p.X(), p.Y()) - 2, p.Z()), 1, 1e-12);
        EXPECT_TRUE(grown.IsIn(toUnit(sampler.frame(), p)));
    }
    EXPECT_NEAR(sampler.frame().diagonal(), std::sqrt(6 * 6 + 6 * 6 + 2 * 2), 1e-3);
}

TEST(ParametricSampler, says_which_expression_does_not_parse_and_where)
{
    EXPECT_EQ(refusal({"u", "u*(v", "0"}), "y does not parse: Missing parenthesis at position 4.");
    EXPECT_EQ(refusal({"u", "v", ""}), "z is empty.");
    EXPECT_EQ(refusal({"x", "v", "0"}),
              "x does not parse: Unexpected token \"x\" found at position 0.");
}

TEST(ParametricSampler, can_be_cancelled_while_it_measures_the_surface)
{
    const auto stop = [](double, const char *) { return false; };
    const auto measure = [&] {
        std::array<Expression, 3> plane{Expression("x", "u", "uv"), Expression("y", "v", "uv"),
                                        Expression("z", "0", "uv")};
        const ParametricSampler sampler(std::move(plane), {0, 1}, {0, 1}, stop);
    };
    EXPECT_THROW(measure(), Cancelled);
}

TEST(ParametricSampler, refuses_what_is_no_surface)
{
    EXPECT_EQ(refusal({"1/u", "v", "0"}), "x is not finite at u = 0, v = 0.");
    EXPECT_EQ(refusal(torus, {1, 1}),
              "The range of u is empty: its lower end must be below its upper end.");
    EXPECT_EQ(refusal(torus, fullTurn, {0, std::nan("")}),
              "The range of v has an end or a length that is not finite.");
    // A step as high as it is wide, where differences are 100,000 times those around it: the cells
    // with the step are drawn, and hardly a place in them is kept.
    EXPECT_EQ(
        refusal({"u", "v", "u < 0.5 ? 0 : 1"}, {0, 1}, {0, 1}),
        "Nearly all of the surface is in next to no part of the ranges of u and v, as where x, "
        "y or z jump: it cannot be sampled.");
    EXPECT_EQ(refusal({"1", "2", "3"}),
              "All points lie in one place: there is no surface to reconstruct.");
    EXPECT_EQ(refusal({"u", "u", "2*u"}),
              "All points lie on a line: there is no surface to reconstruct.");
    EXPECT_EQ(refusal({"cos(u)", "sin(u)", "u"}),
              "The surface has no area that could be measured."); // a helix
}

} // namespace
} // namespace neuralmesh
