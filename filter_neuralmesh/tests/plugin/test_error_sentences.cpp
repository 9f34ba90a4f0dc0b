// SPDX-License-Identifier: GPL-3.0-or-later
// What users of the filters read. pymeshlab_tests/ see most of the sentences in the real host.
#include "plugin/error_sentences.h"

#include <gtest/gtest.h>

#include <cmath>

#include "neuralmesh/parameters.h"
#include "neuralmesh/sampler_errors.h"

namespace neuralmesh {
namespace {

std::string refusalOf(const GrowthParameters &parameters)
{
    try {
        parameters.validate();
    } catch (const InvalidInput &error) {
        return sentenceFor(error);
    }
    return "accepted";
}

TEST(ErrorSentences, parameters_are_called_as_in_the_dialog)
{
    GrowthParameters parameters;
    parameters.counterDecay = 1;
    EXPECT_EQ(refusalOf(parameters), "CounterDecay must lie between 0 and 1, both excluded.");
    parameters = {};
    parameters.snapshots = {6000};
    EXPECT_EQ(refusalOf(parameters),
              "Snapshots names 6000 vertices, more than TargetVertNum, which is 5000.");
    parameters = {};
    parameters.maxHoleSize = -0.25;
    EXPECT_EQ(refusalOf(parameters), "MaxHoleSize must be at least 0, not -0.25.");
    parameters.maxHoleSize = std::nan("");
    EXPECT_EQ(refusalOf(parameters), "MaxHoleSize must be at least 0, not nan.");
}

TEST(ErrorSentences, a_starting_mesh_is_a_layer)
{
    EXPECT_EQ(sentenceFor(InvalidStartingMesh(InvalidStartingMesh::Problem::openEdge, 1)),
              "The starting layer is not closed: 1 edge belongs to one face only. Close its holes, "
              "or merge its close vertices.");
}

TEST(ErrorSentences, densities_are_vertex_qualities)
{
    using Problem = InvalidDensity::Problem;
    EXPECT_EQ(sentenceFor(InvalidDensity(Problem::notValid, 50, 2, 11)),
              "DensityFromQuality: the quality of 2 of 50 vertices is negative, NaN or infinite "
              "(the first is vertex 11).");
    EXPECT_EQ(sentenceFor(InvalidDensity(Problem::noFace)),
              "No face has both an area and a quality above 0.");
}

TEST(ErrorSentences, ranges_are_those_of_two_fields)
{
    const std::string digits = ", by more than the seven digits that the host keeps.";
    EXPECT_EQ(sentenceFor(EmptyRange('y')), "The box is empty: minY must be below maxY" + digits);
    EXPECT_EQ(sentenceFor(EmptyRange('u')),
              "The range of U is empty: minU must be below maxU" + digits);
    EXPECT_EQ(sentenceFor(EmptyRange('z', true)),
              "minZ and maxZ must be finite, and so must their difference; numbers of more than "
              "about 10^38 are none for the host.");
}

TEST(ErrorSentences, of_a_point_file_tell_the_parameter_and_the_reason_behind)
{
    std::string sentence;
    try {
        try {
            throw NeedsConversion(NeedsConversion::Format::e57);
        } catch (const InvalidInput &reason) {
            std::throw_with_nested(InvalidPointFile("scan.e57", reason.what()));
        }
    } catch (const InvalidInput &error) {
        EXPECT_STREQ(error.what(),
                     "'scan.e57': it is an E57 file, whose points are packed in pages, so that "
                     "none can be read in place. Convert it first.");
        sentence = sentenceFor(error);
    }
    EXPECT_EQ(sentence,
              "PointFile 'scan.e57': it is an E57 file, whose points are packed in pages, so that "
              "none can be read in place. Convert it first: open it in MeshLab and export it as "
              "PLY with binary encoding.");
    EXPECT_EQ(sentenceFor(InvalidPointFile("a.ply", "it was changed.")),
              "PointFile 'a.ply': it was changed.");
}

} // namespace
} // namespace neuralmesh
