// SPDX-License-Identifier: GPL-3.0-or-later
// What a network that learns by batches is given, and how it ends.
#include <gtest/gtest.h>

#include "core/growth.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

/// Counts what is drawn of a cloud.
class CountingSampler : public Sampler {
public:
    explicit CountingSampler(const test::WorldPoints &points) : points_(points) {}

    const UnitFrame &frame() const override { return points_.frame(); }
    Box bounds() const override { return points_.bounds(); }
    std::size_t pointCount() const override { return points_.pointCount(); }
    void draw(Random &random, std::size_t count, std::vector<Point> &samples) const override
    {
        points_.draw(random, count, samples);
        independent_ += count;
    }
    void drawStratified(Random &random, const Strata &strata,
                        std::vector<Point> &samples) const override
    {
        points_.drawStratified(random, strata, samples);
        stratified_ += samples.size();
    }

    std::size_t independent() const { return independent_; }
    std::size_t stratified() const { return stratified_; }

private:
    PointCloudSampler points_;
    mutable std::size_t independent_ = 0;
    mutable std::size_t stratified_ = 0;
};

TEST(Growth, learns_from_strata_by_batches_and_from_independent_samples_one_by_one)
{
    const test::WorldPoints points = test::spherePoints(2000, 1);
    GrowthParameters parameters;
    parameters.targetVertexCount = 200;
    parameters.topology = Topology::learned;
    const CountingSampler learned(points);
    NeuralMesh mesh;
    grow(mesh, learned, parameters);
    EXPECT_GT(learned.stratified(), 20U * 200); // and the measure of the error is independent
    EXPECT_LT(learned.independent(), learned.stratified());
    parameters.topology = Topology::ofStart;
    const CountingSampler oneByOne(points);
    NeuralMesh another;
    grow(another, oneByOne, parameters);
    EXPECT_EQ(oneByOne.stratified(), 0U);
}

TEST(Growth, by_batches_ends_where_the_latest_vertices_have_found_their_places)
{
    // In the unit frame, as all errors here: 0.0026, and 0.00285 without the closing batches.
    double sum = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const PointCloudSampler sampler(test::spherePoints(20000, seed));
        GrowthParameters parameters;
        parameters.targetVertexCount = 400;
        parameters.seed = seed;
        parameters.surfaceFit = false;
        NeuralMesh mesh;
        sum += grow(mesh, sampler, parameters).rmsError;
    }
    EXPECT_LT(sum / 8, 0.0027);
}

} // namespace
} // namespace neuralmesh
