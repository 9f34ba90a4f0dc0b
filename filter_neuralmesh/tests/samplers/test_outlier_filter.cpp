// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/points/outlier_filter.h"

#include <gtest/gtest.h>

#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

Box3 boundsOf(const std::vector<Point3> &points)
{
    Box3 bounds;
    for (const Point3 &p : points)
        bounds.Add(p);
    return bounds;
}

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
    EXPECT_FALSE(OutlierFilter(points, boundsOf(points)).isActive());
}

TEST(OutlierFilter, finds_points_that_stand_alone_and_no_others)
{
    const std::vector<Point3> points = sphereWithOutliers(500);
    const OutlierFilter filter(points, boundsOf(points));
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
    const OutlierFilter filter(points, boundsOf(points));
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
    const OutlierFilter filter(points, boundsOf(points));
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
    EXPECT_TRUE(OutlierFilter(points, boundsOf(points)).isActive());
}

TEST(OutlierFilter, finds_groups_too_small_for_a_part_and_keeps_small_parts)
{
    // Beside a sphere, a patch of 20 points as dense as it, and a small sphere of 60.
    std::vector<Point3> points = test::spherePoints(10000, 1);
    for (const vcg::Point3d &p : test::spherePoints(20, 2))
        points.push_back(p * 0.06 + Point3(1.5, 0, 0));
    for (const vcg::Point3d &p : test::spherePoints(60, 3))
        points.push_back(p * 0.08 + Point3(0, 1.5, 0));
    const OutlierFilter filter(points, boundsOf(points));
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
    const OutlierFilter filter(points, boundsOf(points));
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
    const OutlierFilter filter(varied, boundsOf(varied));
    EXPECT_LT(filter.share(), 0.01);
}

TEST(OutlierFilter, leaves_small_clouds_alone)
{
    std::vector<Point3> points = test::spherePoints(450, 6);
    points.emplace_back(9, 9, 9);
    const OutlierFilter filter(points, boundsOf(points));
    EXPECT_FALSE(filter.isActive());
    EXPECT_FALSE(filter.isOutlier(points.back()));
}

TEST(OutlierFilter, a_sampler_draws_no_outliers)
{
    test::WorldPoints points = sphereWithOutliers(500);
    const PointCloudSampler sampler(points);
    EXPECT_NEAR(sampler.outlierShare(), 500.0 / 10500, 0.01);
    int far = 0;
    for (const vcg::Point3d &p : test::drawWorld(sampler, 1, 20000))
        far += std::abs(p.Norm() - 1) > 0.1 ? 1 : 0;
    EXPECT_LT(far, 20); // of some 900 without the filter
}

} // namespace
} // namespace neuralmesh
