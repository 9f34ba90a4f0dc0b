// SPDX-License-Identifier: GPL-3.0-or-later
// Chi-square tests of uniformity by area, over 64 patches of equal area.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/points_for_tests.h"

namespace neuralmesh::test {

constexpr int patches = 64;
constexpr std::size_t patchSamples = 100000;
/// What chi-square with 63 degrees of freedom exceeds with a probability of 0.001.
constexpr double criticalValue = 103.44;

/// Place in [0, 1] to one of eight rows.
inline int row(double share)
{
    return std::min(7, std::max(0, static_cast<int>(8 * share)));
}

/// Share of a full turn, in [0, 1).
inline double turn(double y, double x)
{
    return std::atan2(y, x) / (2 * M_PI) + 0.5;
}

/// Of a sphere around the origin: height is uniform (Archimedes).
inline int spherePatch(const vcg::Point3d &p)
{
    return 8 * row(0.5 + 0.5 * p.Z() / p.Norm()) + row(turn(p.Y(), p.X()));
}

/// Of a torus around the z axis: at angle b of the tube, a ring has the area of its length, so up
/// to b lies a share of (b + minor / major sin b) / 2 pi.
inline int torusPatch(const vcg::Point3d &p, double major, double minor)
{
    const double outwards = std::hypot(p.X(), p.Y()) - major;
    const double b = std::atan2(p.Z(), outwards);
    const double share = (b + minor / major * std::sin(b)) / (2 * M_PI) + 0.5;
    return 8 * row(share) + row(turn(p.Y(), p.X()));
}

/// Expects that samples are uniform by area, with three seeds. `patchOf` takes a sample in world
/// coordinates.
template <class PatchOf> void expectUniform(const Sampler &sampler, const PatchOf &patchOf)
{
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const WorldPoints samples = drawWorld(sampler, seed, patchSamples);
        ASSERT_EQ(samples.size(), patchSamples);
        std::array<int, patches> counts{};
        for (const vcg::Point3d &sample : samples)
            ++counts[static_cast<std::size_t>(patchOf(sample))];
        const double expected = static_cast<double>(patchSamples) / patches;
        double chiSquare = 0;
        for (const int count : counts)
            chiSquare += (count - expected) * (count - expected) / expected;
        EXPECT_LT(chiSquare, criticalValue) << "seed " << seed;
        ::testing::Test::RecordProperty("chi_square_" + std::to_string(seed),
                                        std::to_string(chiSquare));
    }
}

} // namespace neuralmesh::test
