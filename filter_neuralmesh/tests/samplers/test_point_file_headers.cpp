// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts that headers give. What broken headers are answered with is in the corpus,
// pymeshlab_tests/broken_point_files.py; here, that no broken bytes make a reader leave the file.
#include <gtest/gtest.h>

#include <memory>

#include "neuralmesh/errors.h"
#include "neuralmesh/random.h"
#include "samplers/files/point_file_format.h"
#include "samplers/files/point_survey.h"
#include "tests/point_files_for_tests.h"

namespace neuralmesh {
namespace {

using test::bytesOf;

const test::WorldPoints corners{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, -3.5}};

/// The points of a file, or the sentence of the refusal as the only thing thrown.
test::WorldPoints pointsOf(const std::string &content)
{
    const PointRecords records(bytesOf(content), readPointLayout(bytesOf(content)));
    test::WorldPoints points;
    for (std::uint64_t i = 0; i < records.count(); ++i)
        points.push_back(records.point(i));
    return points;
}

TEST(PointFileHeaders, read_every_type_and_byte_order)
{
    for (const bool bigEndian : {false, true}) {
        EXPECT_EQ(pointsOf(test::plyOf<float>(corners, bigEndian)), corners);
        EXPECT_EQ(pointsOf(test::plyOf<double>(corners, bigEndian)), corners);
        EXPECT_EQ(pointsOf(test::npyOf<float>(corners, bigEndian)), corners);
        EXPECT_EQ(pointsOf(test::npyOf<double>(corners, bigEndian)), corners);
    }
}

/// Two points with y of type float between doubles, colours and labels, behind another element
/// and before faces.
std::string plyOfManyTypes()
{
    std::string content = "ply\r\nformat binary_big_endian 1.0\r\ncomment made by hand\r\n"
                          "element camera 2\r\nproperty double focus\r\n"
                          "element vertex 2\r\nproperty uchar red\r\nproperty double z\r\n"
                          "property double x\r\nproperty short label\r\nproperty float y\r\n"
                          "element face 1\r\nproperty list uchar int vertex_indices\r\n"
                          "end_header\r\n";
    content += std::string(16, 'c');
    for (const double start : {10.0, 20.0}) {
        content += '\xff';
        test::append(content, start + 3, true);
        test::append(content, start + 1, true);
        content += "lb";
        test::append(content, static_cast<float>(start + 2), true);
    }
    return content + "faces";
}

TEST(PointFileHeaders, read_ply_properties_of_any_type_and_order_behind_other_elements)
{
    const test::WorldPoints expected{{11, 12, 13}, {21, 22, 23}};
    const std::string content = plyOfManyTypes();
    EXPECT_EQ(pointsOf(content), expected);
    const PointRecords records(bytesOf(content), readPointLayout(bytesOf(content)));
    const PointSurvey survey = surveyPoints(records);
    EXPECT_EQ(survey.bounds.min, expected[0]);
    EXPECT_EQ(survey.bounds.max, expected[1]);
    EXPECT_EQ(survey.notFinite, 0U);
}

TEST(PointFileHeaders, read_las_counts_and_scaled_coordinates_of_both_generations)
{
    const vcg::Point3d shift(500000, 4500000, 100);
    test::WorldPoints far = corners;
    for (vcg::Point3d &p : far)
        p += shift;
    for (const int minor : {2, 4}) {
        const test::WorldPoints read = pointsOf(test::lasOf(far, minor, shift, {}));
        ASSERT_EQ(read.size(), far.size());
        for (std::size_t i = 0; i < far.size(); ++i)
            EXPECT_LT((read[i] - far[i]).Norm(), 1e-6) << "LAS 1." << minor << ", point " << i;
    }
}

TEST(PointFileHeaders, a_survey_finds_bounds_and_what_is_not_finite_in_every_type)
{
    test::WorldPoints broken = corners;
    broken[1].Y() = std::nan("");
    broken[3].X() = INFINITY;
    for (const std::string &content :
         {test::plyOf<float>(broken), test::npyOf<double>(broken, true)}) {
        const PointRecords records(bytesOf(content), readPointLayout(bytesOf(content)));
        const PointSurvey survey = surveyPoints(records);
        EXPECT_EQ(survey.notFinite, 2U);
        EXPECT_EQ(survey.firstNotFinite, 1U);
    }
    for (const std::string &content :
         {test::plyOf<float>(corners, true), test::npyOf<double>(corners),
          test::lasOf(corners, 2, {0, 0, 0}, {})}) {
        const PointRecords records(bytesOf(content), readPointLayout(bytesOf(content)));
        const PointSurvey survey = surveyPoints(records);
        EXPECT_EQ(survey.notFinite, 0U);
        EXPECT_EQ(survey.bounds.min, vcg::Point3d(0, 0, -3.5));
        EXPECT_EQ(survey.bounds.max, vcg::Point3d(1, 2, 0));
    }
}

/// Bytes in a block of exactly their size, so that a sanitizer sees a read behind the end.
class ExactCopy {
public:
    explicit ExactCopy(const std::string &content)
        : data_(new unsigned char[content.size()]), size_(content.size())
    {
        std::memcpy(data_.get(), content.data(), size_);
    }
    Bytes bytes() const { return {data_.get(), size_}; }

private:
    std::unique_ptr<unsigned char[]> data_;
    std::size_t size_;
};

/// A few bytes of the front replaced, by any or by telling ones, and sometimes the end cut off.
std::string mutated(std::string content, Random &random)
{
    static const std::string telling("\0\x01\x7f\x80\xff 0-9\n{(<>,'", 16);
    const std::size_t front = std::min<std::size_t>(content.size(), 400);
    const std::uint64_t changes = 1 + random.below(6);
    for (std::uint64_t i = 0; i < changes; ++i)
        content[random.below(front)] = random.below(2) == 0 ? static_cast<char>(random.below(256))
                                                            : telling[random.below(telling.size())];
    if (random.below(4) == 0)
        content.resize(random.below(content.size() + 1));
    return content;
}

TEST(PointFileHeaders, no_change_of_bytes_leads_to_a_read_outside_the_file)
{
    const std::string valid[] = {test::plyOf<float>(corners),
                                 test::plyOf<double>(corners, true),
                                 test::npyOf<double>(corners),
                                 test::npyOf<float>(corners, true),
                                 test::lasOf(corners, 2, {0, 0, 0}, {}),
                                 test::lasOf(corners, 4, {0, 0, 0}, {})};
    Random random(1);
    int accepted = 0;
    int refused = 0;
    for (int i = 0; i < 30000; ++i) {
        const ExactCopy copy(mutated(valid[random.below(std::size(valid))], random));
        try {
            const PointRecords records(copy.bytes(), readPointLayout(copy.bytes()));
            surveyPoints(records);
            ++accepted;
        } catch (const InvalidInput &) {
            ++refused;
        }
    }
    // Both happen often: the changes are neither all fatal nor all harmless.
    EXPECT_GT(accepted, 3000);
    EXPECT_GT(refused, 3000);
}

} // namespace
} // namespace neuralmesh
