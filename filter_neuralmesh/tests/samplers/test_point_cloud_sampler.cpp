// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/point_cloud_sampler.h"

#include <gtest/gtest.h>

#include <map>

#include "neuralmesh/errors.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

using Points = test::WorldPoints;

std::string refusal(const Points &points)
{
    try {
        const PointCloudSampler sampler(points);
    } catch (const InvalidInput &error) {
        return error.what();
    }
    return "accepted";
}

const Points tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

TEST(PointCloudSampler, draws_every_point_with_the_same_probability)
{
    const PointCloudSampler sampler(tetrahedron);
    std::map<int, int> counts;
    for (const vcg::Point3d &world : test::drawWorld(sampler, 1, 100000))
        ++counts[static_cast<int>(std::lround(world.X() + 2 * world.Y() + 3 * world.Z()))];
    ASSERT_EQ(counts.size(), 4U);
    // Five standard deviations of a binomial(100000, 1/4): 685.
    for (const auto &[point, count] : counts)
        EXPECT_NEAR(count, 25000, 685);
}

/// How often each of the points was drawn from so many strata, by its index.
std::vector<int> timesDrawn(const PointCloudSampler &sampler, const Points &points,
                            std::size_t strata)
{
    Random random(3);
    std::vector<Point> drawn;
    sampler.drawStratified(random, {strata, 0, strata}, drawn);
    std::map<vcg::Point3d, int> times;
    for (const Point &sample : drawn)
        ++times[toVcg(sample)];
    std::vector<int> counts;
    for (const vcg::Point3d &p : points)
        counts.push_back(times[toUnit(sampler.frame(), p)]);
    return counts;
}

TEST(PointCloudSampler, draws_each_point_once_of_as_many_strata_as_points)
{
    const Points points = test::spherePoints(1000, 1);
    const PointCloudSampler sampler(points);
    for (const int times : timesDrawn(sampler, points, 1000))
        EXPECT_EQ(times, 1);
    // Of more, each about as often; of fewer, once or, where it lies in two strata, twice.
    for (const int times : timesDrawn(sampler, points, 2500))
        EXPECT_NEAR(times, 2.5, 1.5);
    for (const int times : timesDrawn(sampler, points, 300))
        EXPECT_LE(times, 2);
}

TEST(PointCloudSampler, points_at_one_place_are_one)
{
    const Points points = test::spherePoints(1000, 1);
    Points repeated = points;
    repeated.insert(repeated.end(), 700, points[3]);
    repeated.insert(repeated.begin(), points[5]);
    const PointCloudSampler sampler(repeated);
    EXPECT_EQ(sampler.pointCount(), 1000U);
    EXPECT_EQ(sampler.outliers().count, 0U);
    for (const int times : timesDrawn(sampler, points, 1000))
        EXPECT_EQ(times, 1);
}

TEST(PointCloudSampler, sparse_points_are_drawn_more_often_where_the_density_varies)
{
    // 60,000 points at x < 1, and a sixteenth as dense up to 5. The spacing is four times as wide
    // there: each is drawn 4^(2/3) times as often.
    Points points;
    Random random(1);
    for (int i = 0; i < 60000; ++i)
        points.emplace_back(random.unit(), random.unit(), 0);
    for (int i = 0; i < 15000; ++i)
        points.emplace_back(1 + 4 * random.unit(), random.unit(), 0);
    const PointCloudSampler sampler(points);
    std::vector<Point> drawn;
    const auto shareOfSparse = [&] {
        double sparse = 0;
        for (const Point &p : drawn)
            sparse += sampler.frame().toWorld(p)[0] > 1 ? 1 : 0;
        return sparse / static_cast<double>(drawn.size());
    };
    sampler.drawStratified(random, {20000, 0, 20000}, drawn);
    const double sparse = 15000 * std::pow(4, 2.0 / 3);
    EXPECT_NEAR(shareOfSparse(), sparse / (sparse + 60000), 0.02);
    // Independent samples are by equation 1: errors are those of all points alike.
    sampler.draw(random, 20000, drawn);
    EXPECT_NEAR(shareOfSparse(), 0.2, 0.02);
}

TEST(PointCloudSampler, every_point_of_a_stratum_is_as_likely)
{
    const PointCloudSampler sampler(tetrahedron);
    Random random(1);
    std::vector<Point> drawn;
    std::map<vcg::Point3d, int> counts;
    for (int i = 0; i < 30000; ++i) {
        sampler.drawStratified(random, {3, 0, 3}, drawn);
        for (const Point &sample : drawn)
            ++counts[toVcg(sample)];
    }
    ASSERT_EQ(counts.size(), 4U);
    // Five standard deviations of a binomial(90000, 1/4): 650. Strata make it less.
    for (const auto &[point, count] : counts)
        EXPECT_NEAR(count, 22500, 650);
}

TEST(PointCloudSampler, strata_cover_the_surface_more_evenly_than_independent_samples)
{
    const PointCloudSampler sampler(test::spherePoints(20000, 1));
    Random random(1);
    const auto variance = [&](bool isStratified) {
        // Samples in one of the sphere's octants, of 400.
        double sum = 0;
        double squares = 0;
        std::vector<Point> drawn;
        for (int i = 0; i < 200; ++i) {
            if (isStratified)
                sampler.drawStratified(random, {400, 0, 400}, drawn);
            else
                sampler.draw(random, 400, drawn);
            double inOctant = 0;
            for (const Point &p : drawn)
                inOctant += p[0] > 0 && p[1] > 0 && p[2] > 0 ? 1 : 0;
            sum += inOctant;
            squares += inOctant * inOctant;
        }
        return squares / 200 - sum * sum / 40000;
    };
    // Of independent ones 400 * 1/8 * 7/8 = 44; of strata, those at the octant's rim vary alone.
    EXPECT_LT(variance(true), 0.2 * variance(false));
}

TEST(PointCloudSampler, strata_in_parts_are_those_of_the_whole)
{
    const PointCloudSampler sampler(test::spherePoints(500, 1));
    Random random(7);
    std::vector<Point> whole;
    sampler.drawStratified(random, {100, 0, 100}, whole);
    Random again(7);
    std::vector<Point> first;
    std::vector<Point> second;
    sampler.drawStratified(again, {100, 0, 64}, first);
    sampler.drawStratified(again, {100, 64, 100}, second);
    first.insert(first.end(), second.begin(), second.end());
    EXPECT_EQ(first, whole);
}

TEST(PointCloudSampler, strata_have_the_same_share_of_the_density)
{
    const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const PointCloudSampler sampler(points, {1, 2, 3, 4, 0});
    const std::vector<int> times = timesDrawn(sampler, points, 1000);
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(times[static_cast<std::size_t>(i)], 100 * (i + 1), 2);
    EXPECT_EQ(times[4], 0);
}

TEST(PointCloudSampler, the_unit_frame_is_centred_with_unit_diagonal)
{
    Points far = tetrahedron;
    for (vcg::Point3d &p : far)
        p = p * 1000.0 + vcg::Point3d(500000, 4500000, 100);
    const PointCloudSampler sampler(far);
    EXPECT_NEAR(toVcg(sampler.bounds()).Diag(), 1, 1e-9);
    EXPECT_NEAR(toVcg(sampler.bounds()).Center().Norm(), 0, 1e-9);
    EXPECT_NEAR(sampler.frame().diagonal(), 1000 * std::sqrt(3.0), 1e-6);
}

TEST(PointCloudSampler, counts_distinct_points_up_to_what_is_asked)
{
    Points twice = test::spherePoints(50, 1);
    twice.insert(twice.end(), twice.begin(), twice.begin() + 50);
    const PointCloudSampler sampler(twice);
    EXPECT_EQ(sampler.countDistinctPoints(1000), 50U);
    EXPECT_EQ(sampler.countDistinctPoints(20), 20U);
}

TEST(PointCloudSampler, refuses_what_cannot_carry_a_closed_surface)
{
    EXPECT_EQ(refusal(tetrahedron), "accepted");
    EXPECT_NE(refusal({}).find("no points"), std::string::npos);
    EXPECT_NE(refusal(Points(9, {1, 2, 3})).find("in one place"), std::string::npos);
    EXPECT_NE(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}).find("Only 3 distinct"),
              std::string::npos);
}

TEST(PointCloudSampler, refuses_lines_and_knows_planes_in_any_direction_and_place)
{
    for (const vcg::Point3d offset : {vcg::Point3d(0, 0, 0), vcg::Point3d(5e5, 4.5e6, 100)}) {
        Points line, plane;
        Random random(3);
        for (int i = 0; i < 200; ++i) {
            const double a = random.unit();
            const double b = random.unit();
            line.push_back(offset + vcg::Point3d(3, -1, 2) * a);
            plane.push_back(offset + vcg::Point3d(3, -1, 2) * a + vcg::Point3d(1, 1, 0) * b);
        }
        EXPECT_NE(refusal(line).find("on a line"), std::string::npos);
        EXPECT_TRUE(PointCloudSampler(plane).isFlat());
        plane.push_back(offset + vcg::Point3d(0, 0, 0.01));
        EXPECT_FALSE(PointCloudSampler(plane).isFlat());
    }
}

TEST(PointCloudSampler, says_how_many_coordinates_are_not_finite_and_where_the_first_is)
{
    Points broken = test::spherePoints(20, 1);
    broken[7].X() = std::nan("");
    broken[11].Z() = -INFINITY;
    const std::string sentence = refusal(broken);
    EXPECT_NE(sentence.find("2 of 20"), std::string::npos);
    EXPECT_NE(sentence.find("point 7"), std::string::npos);
}

TEST(PointCloudSampler, draws_points_in_proportion_to_a_density)
{
    const PointCloudSampler sampler({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}},
                                    {0.1, 0.2, 0.3, 0.4, 0});
    std::map<int, int> counts;
    for (const vcg::Point3d &world : test::drawWorld(sampler, 1, 100000))
        ++counts[static_cast<int>(std::lround(world.X() + 2 * world.Y() + 3 * world.Z()))];
    ASSERT_EQ(counts.size(), 4U); // the last point is never drawn
    // Five standard deviations of a binomial: at most 775.
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(counts[i], 10000 * (i + 1), 775) << i;
}

TEST(PointCloudSampler, points_of_density_0_are_as_if_they_were_not_there)
{
    const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}};
    const PointCloudSampler sampler(points, {1, 1, 1, 1, 0});
    EXPECT_EQ(sampler.countDistinctPoints(10), 4U);
    EXPECT_EQ(sampler.pointCount(), 4U);
    EXPECT_NEAR(sampler.frame().diagonal(), std::sqrt(3), 1e-12);
}

TEST(PointCloudSampler, says_that_points_on_a_line_are_not_all)
{
    test::WorldPoints points;
    for (int i = 0; i < 600; ++i)
        points.emplace_back(i, 2 * i, 0);
    points.emplace_back(300, 0, 900);
    try {
        const PointCloudSampler sampler(points);
        FAIL();
    } catch (const InvalidInput &error) {
        EXPECT_STREQ(error.what(), "All points but 1 isolated one lie on a line: there is no "
                                   "surface to reconstruct.");
    }
}

} // namespace
} // namespace neuralmesh
