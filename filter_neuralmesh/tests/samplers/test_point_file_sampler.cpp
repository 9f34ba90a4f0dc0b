// SPDX-License-Identifier: GPL-3.0-or-later
#include "samplers/files/point_file_sampler.h"

#include <gtest/gtest.h>

#include "neuralmesh/errors.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/meshes_for_tests.h"
#include "tests/point_files_for_tests.h"

namespace neuralmesh {
namespace {

using test::TemporaryFile;

std::string refusal(const std::string &content)
{
    const TemporaryFile file(content);
    try {
        const PointFileSampler sampler(file.path());
    } catch (const InvalidInput &error) {
        const std::string sentence = error.what();
        const std::string start = "'" + file.path() + "': ";
        EXPECT_EQ(sentence.substr(0, start.size()), start);
        return sentence.substr(start.size());
    }
    return "accepted";
}

TEST(PointFileSampler, draws_what_the_same_points_in_memory_give)
{
    const test::WorldPoints points = test::spherePoints(5003, 1); // not a multiple of eight
    const TemporaryFile file(test::npyOf<double>(points));
    const PointFileSampler inFile(file.path());
    const PointCloudSampler inMemory(points);
    EXPECT_EQ(inFile.pointCount(), 5003U);
    EXPECT_EQ(inFile.bounds().min, inMemory.bounds().min);
    EXPECT_EQ(inFile.bounds().max, inMemory.bounds().max);
    EXPECT_EQ(test::drawWorld(inFile, 7, 20000), test::drawWorld(inMemory, 7, 20000));
}

TEST(PointFileSampler, draws_of_strata_what_the_same_points_in_memory_give)
{
    test::WorldPoints points = test::spherePoints(400, 1);
    for (Point3 &point : points) // dense about the origin: sparse points are drawn more often
        point = (point + Point3(0, 0, 1)) * (point.Z() + 1.1);
    const TemporaryFile file(test::npyOf<double>(points));
    const PointFileSampler fromFile(file.path());
    const PointCloudSampler fromMemory(points);
    for (const std::size_t strata : {100U, 400U, 900U}) {
        Random random(1);
        Random same(1);
        std::vector<Point> drawn;
        std::vector<Point> expected;
        fromFile.drawStratified(random, {strata, 0, strata}, drawn);
        fromMemory.drawStratified(same, {strata, 0, strata}, expected);
        EXPECT_EQ(drawn, expected);
    }
}

TEST(PointFileSampler, has_the_points_that_it_looked_at_in_time)
{
    test::WorldPoints points = test::spherePoints(300000, 1);
    points.back() = {std::nan(""), 0, 0}; // not looked at
    const Progress late = Progress::silent([] { return true; });
    for (const std::string &content : {test::npyOf<double>(points), test::plyOf<float>(points)}) {
        const TemporaryFile file(content);
        const PointFileSampler sampler(file.path(), late);
        EXPECT_EQ(sampler.pointCount(), 262144U); // a block
        for (const vcg::Point3d &p : test::drawWorld(sampler, 7, 1000))
            EXPECT_NEAR(p.Norm(), 1, 1e-6);
    }
}

TEST(PointFileSampler, draws_no_outliers)
{
    test::WorldPoints points = test::spherePoints(10000, 1);
    Random random(2);
    for (int i = 0; i < 500; ++i)
        points.push_back(test::inUnitCube(random) * 4 - vcg::Point3d(2, 2, 2));
    const TemporaryFile file(test::plyOf<float>(points));
    const PointFileSampler sampler(file.path());
    EXPECT_NEAR(sampler.outliers().share, 500.0 / 10500, 0.01);
    int far = 0;
    for (const vcg::Point3d &p : test::drawWorld(sampler, 7, 20000))
        far += std::abs(p.Norm() - 1) > 0.1 ? 1 : 0;
    EXPECT_LT(far, 20); // of some 900 without the filter
}

TEST(PointFileSampler, counts_distinct_points_up_to_what_is_asked)
{
    test::WorldPoints twice = test::spherePoints(50, 1);
    twice.insert(twice.end(), twice.begin(), twice.begin() + 50);
    const TemporaryFile file(test::npyOf<double>(twice));
    const PointFileSampler sampler(file.path());
    EXPECT_EQ(sampler.countDistinctPoints(1000), 50U);
    EXPECT_EQ(sampler.countDistinctPoints(20), 20U);
}

TEST(PointFileSampler, believes_a_las_header_only_where_its_bounds_fit_the_points)
{
    const vcg::Point3d shift(500000, 4500000, 100);
    test::WorldPoints points = test::spherePoints(1000, 1);
    for (vcg::Point3d &p : points)
        p += shift;
    vcg::Box3d fitting(shift - vcg::Point3d(1, 1, 1), shift + vcg::Point3d(1, 1, 1));
    vcg::Box3d huge(shift - vcg::Point3d(9, 9, 9), shift + vcg::Point3d(9, 9, 9));
    vcg::Box3d elsewhere(shift + vcg::Point3d(1, 1, 1), shift + vcg::Point3d(3, 3, 3));
    vcg::Box3d notFinite = fitting;
    notFinite.max.X() = std::nan("");
    for (const vcg::Box3d &claimed : {fitting, huge, elsewhere, notFinite}) {
        const TemporaryFile file(test::lasOf(points, 2, shift, claimed));
        const PointFileSampler sampler(file.path());
        // The sphere reaches to within 0.01 of its box in every direction.
        EXPECT_NEAR(sampler.frame().diagonal(), 2 * std::sqrt(3.0), 0.03);
        EXPECT_LT((toWorld(sampler.frame(), {0, 0, 0}) - shift).Norm(), 0.03);
    }
}

TEST(PointFileSampler, draws_no_point_that_a_las_header_does_not_know_of)
{
    // One in three points is a pilot point, and these are not.
    const vcg::Point3d shift(500000, 4500000, 100);
    test::WorldPoints points = test::spherePoints(60000, 1);
    for (vcg::Point3d &p : points)
        p += shift;
    points.insert(points.begin() + 1, 2, shift + vcg::Point3d(0, 0, 5000));
    const vcg::Box3d claimed(shift - vcg::Point3d(1, 1, 1), shift + vcg::Point3d(1, 1, 1));
    const TemporaryFile file(test::lasOf(points, 2, shift, claimed));
    const PointFileSampler sampler(file.path());
    EXPECT_EQ(sampler.outliers().count, 2U);
    EXPECT_NEAR(sampler.frame().diagonal(), 2 * std::sqrt(3.0), 0.03);
    for (const vcg::Point3d &p : test::drawWorld(sampler, 1, 200000))
        EXPECT_LT((p - shift).Norm(), 1.01);
}

TEST(PointFileSampler, counts_the_strays_of_a_large_file)
{
    test::WorldPoints points = test::spherePoints(300000, 1);
    points.insert(points.begin() + 1, 3, vcg::Point3d(1e7, 0, 0)); // between the pilot points
    const TemporaryFile file(test::npyOf<double>(points));
    const PointFileSampler sampler(file.path());
    EXPECT_EQ(sampler.outliers().count, 3U);
    // The frame is as wide as pilot points reach.
    EXPECT_NEAR(sampler.frame().diagonal(), 2 * std::sqrt(3.0), 0.1);
}

TEST(PointFileSampler, notices_numbers_that_are_none_whatever_the_time_of_the_file)
{
    test::WorldPoints points = test::spherePoints(100, 1);
    const TemporaryFile file(test::npyOf<double>(points));
    const PointFileSampler sampler(file.path());
    const auto path = std::filesystem::u8path(file.path());
    const auto time = std::filesystem::last_write_time(path);
    points[50].Y() = std::nan("");
    file.overwrite(test::npyOf<double>(points));
    std::filesystem::last_write_time(path, time);
    EXPECT_THROW(test::drawWorld(sampler, 7, 10000), InvalidInput);
}

TEST(PointFileSampler, refuses_what_cannot_carry_a_closed_surface)
{
    const auto refusalOf = [](const test::WorldPoints &points) {
        return refusal(test::npyOf<double>(points));
    };
    EXPECT_NE(refusalOf(test::WorldPoints(9, {1, 2, 3})).find("in one place"), std::string::npos);
    EXPECT_NE(refusalOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}}).find("Only 3 distinct"),
              std::string::npos);
    test::WorldPoints line, plane;
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const double a = random.unit();
        line.push_back(vcg::Point3d(3, -1, 2) * a);
        plane.push_back(vcg::Point3d(3, -1, 2) * a + vcg::Point3d(1, 1, 0) * random.unit());
    }
    EXPECT_NE(refusalOf(line).find("on a line"), std::string::npos);
    EXPECT_EQ(refusalOf(plane), "accepted");
    plane[5].X() = std::nan("");
    EXPECT_NE(refusalOf(plane).find("1 of 200 points"), std::string::npos);
    EXPECT_NE(refusalOf(plane).find("point 5"), std::string::npos);
    EXPECT_NE(refusalOf(test::WorldPoints{{1e308, 0, 0}, {-1e308, 0, 0}}).find("too large"),
              std::string::npos);
}

TEST(PointFileSampler, notices_that_the_file_shrinks_or_is_written_to)
{
    const std::string content = test::npyOf<double>(test::spherePoints(100, 1));
    const TemporaryFile file(content);
    const PointFileSampler sampler(file.path());
    test::drawWorld(sampler, 7, 10);
    if (!file.write(content.substr(0, content.size() / 2)))
        file.overwrite(content); // Windows lets nobody cut the file
    EXPECT_THROW(test::drawWorld(sampler, 7, 10), InvalidInput);
}

TEST(PointFileSampler, reads_a_file_whose_name_has_letters_of_any_script)
{
    const TemporaryFile file(test::npyOf<double>(test::spherePoints(100, 1)),
                             "gr\u00f6\u00dfe-\u70b9\u7fa4");
    EXPECT_EQ(test::drawWorld(PointFileSampler(file.path()), 7, 10).size(), 10U);
}

TEST(PointFileSampler, can_be_cancelled_while_it_reads_the_file)
{
    const TemporaryFile file(test::npyOf<double>(test::spherePoints(100, 1)));
    const auto stop = [](double, const char *) { return false; };
    EXPECT_THROW(PointFileSampler(file.path(), stop), Cancelled);
}

} // namespace
} // namespace neuralmesh
