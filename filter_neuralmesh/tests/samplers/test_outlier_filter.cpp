// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/outlier_filter.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// A sphere of 10,000 points with `outliers` more, uniform in the box of twice its size.
test::WorldPoints sphereWithOutliers(int outliers)
{
    test::WorldPoints points = test::spherePoints(10000, 1);
    Random random(2);
    for (int i = 0; i < outliers; ++i)
        points.push_back(test::inUnitCube(random) * 4 - vcg::Point3d(2, 2, 2));
    return points;
}

TEST(OutlierFilter, keeps_a_clean_cloud_whole)
{
    const std::vector<Point3> points = sphereWithOutliers(0);
    EXPECT_EQ(OutlierFilter(points).share(), 0);
}

TEST(OutlierFilter, finds_points_that_stand_alone_and_no_others)
{
    const std::vector<Point3> points = sphereWithOutliers(500);
    const OutlierFilter filter(points);
    ASSERT_TRUE(filter.isActive());
    int found = 0, far = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i < 10000)
            EXPECT_FALSE(filter.isOutlier(points[i])) << i;
        // Further from the sphere than a tenth of its radius: several times the usual spacing.
        else if (std::abs(points[i].Norm() - 1) > 0.1) {
            ++far;
            found += filter.isOutlier(points[i]) ? 1 : 0;
        }
    }
    EXPECT_GE(found, 0.98 * far) << "of " << far;
}

TEST(OutlierFilter, counts_points_at_one_place_as_one)
{
    // Invalid returns of a scanner are stored as 0 0 0, here a third of all.
    std::vector<Point3> points = test::spherePoints(10000, 1);
    const Point3 nowhere(0, 0, 0);
    points.insert(points.end(), 5000, nowhere);
    const OutlierFilter filter(points);
    ASSERT_TRUE(filter.isActive());
    EXPECT_TRUE(filter.isOutlier(nowhere));
    EXPECT_NEAR(filter.share(), 1.0 / 3, 0.01);
}

TEST(OutlierFilter, leaves_the_frame_to_the_others_however_far_it_is)
{
    for (const std::size_t count : {std::size_t(5000), std::size_t(250000)})
        for (const std::size_t zeros : {1U, 30U}) {
            test::WorldPoints points = test::spherePoints(count, 1);
            const vcg::Point3d place(512345.6, 5403707.6, 356.1);
            for (vcg::Point3d &p : points)
                p += place;
            points.insert(points.begin() + 1000, zeros * count / 5000, vcg::Point3d(0, 0, 0));
            const PointCloudSampler sampler(points);
            EXPECT_FALSE(sampler.isFlat());
            EXPECT_NEAR(sampler.frame().diagonal(), std::sqrt(12), 0.5);
            for (const vcg::Point3d &p : test::drawWorld(sampler, 1, 10000))
                EXPECT_NEAR((p - place).Norm(), 1, 1e-6);
        }
}

TEST(OutlierFilter, finds_strays_that_are_near_enough_to_a_surface_not_to_be_alone)
{
    // 0.2 off a sphere of 3,000 points, 3 spacings: a radius of 4 spacings holds more than eight.
    std::vector<Point3> points = test::spherePoints(3000, 1);
    for (std::size_t i = 0; i < 60; ++i)
        points.push_back(points[50 * i] * 1.2);
    const OutlierFilter filter(points);
    ASSERT_TRUE(filter.isActive());
    int found = 0, wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        (i < 3000 ? wrong : found) += filter.isOutlier(points[i]) ? 1 : 0;
    EXPECT_GE(found, 54);
    EXPECT_EQ(wrong, 0);
}

TEST(OutlierFilter, does_not_take_the_company_of_outliers_in_a_thin_box_for_a_surface)
{
    // A frame of bars; what is between them lies in a box that is thirteen times as wide as high.
    Random random(7);
    std::vector<Point3> points;
    for (int i = 0; i < 4200; ++i) {
        Point3 p = test::inUnitCube(random) * 2 - Point3(1, 1, 1);
        p.Z() *= 0.075;
        if (i < 4000)
            p[i % 2] = std::copysign(1 - 0.15 * std::floor(2 * random.unit()), p[i % 2]);
        points.push_back(p);
    }
    EXPECT_GT(OutlierFilter(points).share(), 0);
}

TEST(OutlierFilter, finds_groups_too_small_for_a_part_and_keeps_small_parts)
{
    // Beside a sphere, a patch of 20 points as dense as it, and a small sphere of 60.
    std::vector<Point3> points = test::spherePoints(10000, 1);
    for (const vcg::Point3d &p : test::spherePoints(20, 2))
        points.push_back(p * 0.06 + Point3(1.5, 0, 0));
    for (const vcg::Point3d &p : test::spherePoints(60, 3))
        points.push_back(p * 0.08 + Point3(0, 1.5, 0));
    const OutlierFilter filter(points);
    ASSERT_TRUE(filter.isActive());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_EQ(filter.isOutlier(points[i]), i >= 10000 && i < 10020) << i;
    EXPECT_LT(filter.bounds().max.X(), 1.2);
}

TEST(OutlierFilter, leaves_a_cloud_alone_that_is_nothing_but_small_groups)
{
    Random random(8);
    std::vector<Point3> points;
    for (int group = 0; group < 500; ++group) {
        const Point3 place = test::inUnitCube(random) * 100;
        for (int i = 0; i < 12; ++i)
            points.push_back(place + test::inUnitCube(random) * 0.1);
    }
    const OutlierFilter filter(points);
    EXPECT_FALSE(filter.isActive());
    EXPECT_FALSE(filter.isOutlier(points.front()));
}

TEST(OutlierFilter, takes_a_sparse_half_for_a_surface)
{
    // The lower half holds a twenty-fifth of the points: five times the spacing.
    Random random(4);
    std::vector<Point3> varied;
    for (const vcg::Point3d &p : test::spherePoints(20000, 5))
        if (random.unit() < (p.Z() > 0 ? 1.0 : 0.04))
            varied.push_back(p);
    const OutlierFilter filter(varied);
    EXPECT_LT(filter.share(), 0.01);
}

std::size_t outliersAfter(std::size_t first, const std::vector<Point3> &points)
{
    const OutlierFilter filter(points);
    return static_cast<std::size_t>(
        std::count_if(points.begin() + static_cast<std::ptrdiff_t>(first), points.end(),
                      [&](const Point3 &point) { return filter.isOutlier(point); }));
}

/// Points of a ring as thick as said, 130,000 for each unit; of those at one side, one in ten.
std::vector<Point3> ringWithSparseHalf(double thickness)
{
    Random random(8);
    std::vector<Point3> points;
    const auto count = static_cast<std::size_t>(130000 * thickness);
    while (points.size() < count) {
        const double along = 2 * M_PI * random.unit();
        const double across = 2 * M_PI * random.unit();
        const double radius = 1 + thickness / 2 * std::cos(across);
        if (random.unit() * (1 + thickness) < radius && (along < M_PI || random.unit() < 0.1))
            points.emplace_back(radius * std::cos(along), radius * std::sin(along),
                                thickness / 2 * std::sin(across));
    }
    return points;
}

TEST(OutlierFilter, keeps_a_sparse_half)
{
    // Three times the spacing: some points are alone and some are not.
    const std::vector<Point3> points = ringWithSparseHalf(0.3);
    EXPECT_LE(outliersAfter(0, points), 4U);
}

TEST(OutlierFilter, keeps_sparse_limbs_that_are_no_thicker_than_their_points_are_apart)
{
    // None has its neighbours in a plane, but those of the thick ring, at the same spacing, have.
    std::vector<Point3> points = ringWithSparseHalf(0.3);
    for (const Point3 &point : ringWithSparseHalf(0.03))
        points.push_back(point + Point3(0, 0, 1));
    EXPECT_LE(outliersAfter(0, points), 4U);
}

TEST(OutlierFilter, finds_strays_that_look_at_a_sparse_part_from_outside)
{
    // The neighbours of each, in the sparse half, lie in one direction from it.
    std::vector<Point3> points = ringWithSparseHalf(0.3);
    const std::size_t strays = points.size();
    for (int i = 0; i < 5; ++i)
        points.emplace_back(0, -2 - 3 * i, i);
    EXPECT_EQ(outliersAfter(strays, points), 5U);
    EXPECT_LE(outliersAfter(0, points), 9U);
}

TEST(OutlierFilter, finds_few_strays_at_any_distance)
{
    // As many at each order of distance: the neighbours of most lie in one direction, which by
    // their variance looks like a line, and a line like a sheet.
    Random random(3);
    for (const int strays : {1, 2, 9, 20, 60, 60, 60, 150, 150, 150, 500})
        for (const double reach : {3.0, 1e2, 1e4, 1e7, 1e30, 1e300}) {
            test::WorldPoints points = test::spherePoints(5000, 1);
            for (int i = 0; i < strays; ++i) {
                const double distance = 1.5 * std::pow(reach / 1.5, random.unit());
                vcg::Point3d direction = test::inUnitCube(random) - vcg::Point3d(.5, .5, .5);
                points.push_back(direction.Normalize() * distance);
            }
            const PointCloudSampler sampler(points);
            EXPECT_EQ(sampler.outliers().count, static_cast<std::uint64_t>(strays)) << reach;
            EXPECT_NEAR(sampler.frame().diagonal(), std::sqrt(12), 0.05);
        }
}

TEST(OutlierFilter, finds_strays_that_are_all_far_away)
{
    // Uniform in a cube: at these distances, nearly all are of one order.
    for (const double reach : {1e5, 1e7, 1e12, 1e100}) {
        test::WorldPoints points = test::spherePoints(5000, 1);
        Random random(3);
        while (points.size() < 5200)
            points.push_back((test::inUnitCube(random) - Point3(.5, .5, .5)) * reach);
        EXPECT_EQ(PointCloudSampler(points).outliers().count, 200U) << reach;
    }
}

TEST(OutlierFilter, finds_strays_between_the_pilot_points)
{
    // One in three points is a pilot point, and the strays are not; of 300,000, one in fifteen.
    for (const std::size_t count : {std::size_t(60000), std::size_t(300000)}) {
        test::WorldPoints points = test::spherePoints(count, 1);
        points.insert(points.begin() + 1, vcg::Point3d(50, 0, 0));
        points.insert(points.begin() + 2, vcg::Point3d(50, 1, 0));
        const PointCloudSampler sampler(points);
        EXPECT_EQ(sampler.outliers().count, 2U);
        EXPECT_NEAR(sampler.frame().diagonal(), std::sqrt(12), 0.01);
    }
}

TEST(OutlierFilter, finds_strays_that_are_nearer_to_a_surface_than_its_pilot_points)
{
    // 0.06 to 0.09 from it: 20,000 pilot points have as much between them, 100,000 have half of it.
    test::WorldPoints points = test::spherePoints(100000, 1);
    Random random(9);
    for (const vcg::Point3d &place : test::spherePoints(1000, 2))
        points.push_back(place * (1.06 + 0.03 * random.unit()));
    const auto found = PointCloudSampler(points).outliers().count;
    EXPECT_GE(found, 990U);
    EXPECT_LE(found, 1000U);
}

TEST(OutlierFilter, finds_a_place_that_is_stored_a_thousand_times)
{
    test::WorldPoints points = test::spherePoints(5000, 1);
    for (const vcg::Point3d &place : test::spherePoints(20, 2))
        points.insert(points.end(), 1000, place * 2);
    EXPECT_EQ(PointCloudSampler(points).outliers().count, 20000U);
}

/// A sphere of 5,000 points with 500 more, as many at each distance from its centre in the range.
std::vector<Point3> sphereWithStrays(double nearest, double furthest, double power, Random &random)
{
    std::vector<Point3> points = test::spherePoints(5000, 1);
    for (int i = 0; i < 500; ++i) {
        Point3 direction = test::inUnitCube(random) - Point3(.5, .5, .5);
        const double distance = nearest + (furthest - nearest) * std::pow(random.unit(), 1 / power);
        points.push_back(direction.Normalize() * distance);
    }
    return points;
}

TEST(OutlierFilter, chance_clusters_of_strays_are_no_part)
{
    // So many next to the sphere that some have eight others around; none is part of the surface.
    Random random(4);
    for (int round = 0; round < 10; ++round) {
        const std::vector<Point3> points = sphereWithStrays(1.25, 1.5, 1, random);
        const OutlierFilter filter(points);
        for (std::size_t i = 0; i < points.size(); ++i)
            EXPECT_EQ(filter.isOutlier(points[i]), i >= 5000) << i;
    }
}

TEST(OutlierFilter, strays_in_a_plane_by_chance_are_no_part)
{
    // Uniform in a ball: one in ten has its neighbours in a plane.
    Random random(5);
    for (int round = 0; round < 5; ++round) {
        const std::vector<Point3> points = sphereWithStrays(1.5, 10, 3, random);
        const OutlierFilter filter(points);
        for (std::size_t i = 5000; i < points.size(); ++i)
            EXPECT_TRUE(filter.isOutlier(points[i])) << i;
    }
}

TEST(OutlierFilter, strays_of_heavy_tails_are_no_part)
{
    // Each coordinate is Cauchy-distributed: strays are as dense as the surface next to it, and
    // thin out to a thousand radii.
    std::vector<Point3> points = test::spherePoints(20000, 1);
    Random random(6);
    const auto cauchy = [&] { return 2 * std::tan(M_PI * (random.unit() - 0.5)); };
    while (points.size() < 21000) {
        const Point3 place(cauchy(), cauchy(), cauchy());
        if (std::abs(place.Norm() - 1) > 0.5)
            points.push_back(place);
    }
    EXPECT_GE(outliersAfter(20000, points), 1000U);
    EXPECT_EQ(outliersAfter(0, points), 1000U);
}

/// Points of a floor, one by one.
std::vector<Point3> floorOf(int points, double side)
{
    Random random(5);
    std::vector<Point3> floor;
    for (int i = 0; i < points; ++i)
        floor.push_back(test::inUnitCube(random) * side);
    for (Point3 &point : floor)
        point.Z() = 0;
    return floor;
}

TEST(OutlierFilter, keeps_sparse_returns_of_the_same_ground_among_strays)
{
    // Around a floor, ground with a hundredth of its density, ten times the spacing: 990 points.
    // And 60 strays above, which are no reason to keep each other.
    std::vector<Point3> points = floorOf(10000, 10);
    Random random(6);
    while (points.size() < 10990) {
        const Point3 place = test::inUnitCube(random) * 33.3 - Point3(11.6, 11.6, 0);
        if (place.X() < 0 || place.X() > 10 || place.Y() < 0 || place.Y() > 10)
            points.emplace_back(place.X(), place.Y(), 0);
    }
    for (int i = 0; i < 60; ++i)
        points.push_back(test::inUnitCube(random) * 100 + Point3(0, 0, 5));
    const std::size_t strays = outliersAfter(10990, points);
    EXPECT_EQ(strays, 60U);
    EXPECT_LT(outliersAfter(0, points) - strays, 10U);
}

TEST(OutlierFilter, the_border_of_a_floor_is_no_sparse_part)
{
    // Spikes of the border stand alone, and each other's neighbours among those that do are far:
    // no reason to keep strays that are as far from them.
    std::vector<Point3> points = floorOf(60000, 10);
    for (int i = 0; i < 120; ++i)
        points.emplace_back(i / 12.0, -0.22, 0);
    const std::size_t strays = points.size();
    Random random(8);
    for (int i = 0; i < 60; ++i)
        points.emplace_back(10 * random.unit(), -4 * random.unit(), 0.7 + 4 * random.unit());
    EXPECT_EQ(outliersAfter(strays, points), 60U);
    EXPECT_LT(outliersAfter(0, points), 65U);
}

TEST(OutlierFilter, keeps_a_wire_far_above_a_floor)
{
    std::vector<Point3> points = floorOf(10000, 10);
    Random random(7);
    for (int i = 0; i < 120; ++i) // a spacing of 0.2, on a floor of 0.1
        points.push_back(Point3(0.2 * i - 7, 3, 6 + 0.0005 * i * i) +
                         test::inUnitCube(random) * 0.05);
    EXPECT_EQ(outliersAfter(0, points), 0U);
}

TEST(OutlierFilter, keeps_a_small_object_far_away)
{
    std::vector<Point3> points = test::spherePoints(10000, 1);
    for (const vcg::Point3d &p : test::spherePoints(60, 3))
        points.push_back(p * 0.08 + Point3(0, 150, 0));
    EXPECT_EQ(outliersAfter(0, points), 0U);
}

TEST(OutlierFilter, leaves_small_clouds_alone)
{
    std::vector<Point3> points = test::spherePoints(450, 6);
    points.emplace_back(9, 9, 9);
    const OutlierFilter filter(points);
    EXPECT_FALSE(filter.isActive());
    EXPECT_FALSE(filter.isOutlier(points.back()));
}

TEST(OutlierFilter, a_sampler_draws_no_outliers)
{
    test::WorldPoints points = sphereWithOutliers(500);
    const PointCloudSampler sampler(points);
    EXPECT_NEAR(sampler.outliers().share, 500.0 / 10500, 0.01);
    int far = 0;
    for (const vcg::Point3d &p : test::drawWorld(sampler, 1, 20000))
        far += std::abs(p.Norm() - 1) > 0.1 ? 1 : 0;
    EXPECT_LT(far, 20); // of some 900 without the filter
}

} // namespace
} // namespace neuralmesh
