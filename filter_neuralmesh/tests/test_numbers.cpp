// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that have to be the same everywhere.
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "core/nth_root.h"
#include "core/random_streams.h"

namespace neuralmesh {
namespace {

TEST(NthRoot, is_that_of_the_c_library_but_for_the_last_places)
{
    for (const double number : {1e-6, 0.05, 0.5, 0.95, 0.995, 0.9999999})
        for (int n = 1; n < 200000; n += 1 + n / 7) {
            const double root = nthRoot(number, n);
            EXPECT_NEAR(root, std::pow(number, 1.0 / n), 1e-15) << number << " " << n;
            EXPECT_LT(root, 1) << number << " " << n;
        }
}

/// xoshiro256++ seeded by splitmix64, as in xoshiro256plusplus.c and splitmix64.c of Blackman and
/// Vigna (prng.di.unimi.it). The values of seed 0 are those that the tests of rand_xoshiro have for
/// seed_from_u64(0). Those of the others come from the published algorithm in Python's integers.
TEST(Random, gives_the_reference_output_of_xoshiro256_seeded_by_splitmix64)
{
    Random zero(0);
    for (const std::uint64_t expected :
         {5987356902031041503ULL, 7051070477665621255ULL, 6633766593972829180ULL,
          211316841551650330ULL, 9136120204379184874ULL, 379361710973160858ULL})
        EXPECT_EQ(zero.bits(), expected);
    Random one(1);
    for (const std::uint64_t expected :
         {14971601782005023387ULL, 13781649495232077965ULL, 1847458086238483744ULL})
        EXPECT_EQ(one.bits(), expected);
    Random highest(~0ULL); // the sum of splitmix64 wraps around
    for (const std::uint64_t expected :
         {6254647548650071986ULL, 16610832622747802512ULL, 16422857234328439435ULL})
        EXPECT_EQ(highest.bits(), expected);
}

TEST(Random, unit_is_the_53_high_bits_and_below_the_32_high_bits)
{
    // Of seed 0, first bits 5987356902031041503.
    EXPECT_EQ(Random(0).unit(), static_cast<double>(5987356902031041503ULL >> 11) / (1ULL << 53));
    EXPECT_EQ(Random(0).below(1ULL << 32), 5987356902031041503ULL >> 32);
    EXPECT_EQ(Random(0).below(1), 0U);
    EXPECT_EQ(Random(0).below(10), 3U); // 0.32 of 10
}

TEST(RandomStreams, differ_by_seed_purpose_and_chunk)
{
    std::vector<std::uint64_t> first;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        first.push_back(randomStream(seed, Purpose::growth).bits());
        first.push_back(randomStream(seed, Purpose::measuring).bits());
        for (std::uint64_t chunk = 0; chunk < 20; ++chunk)
            first.push_back(randomStream(seed, Purpose::snapshot, chunk).bits());
    }
    EXPECT_EQ(std::set<std::uint64_t>(first.begin(), first.end()).size(), first.size());
}

TEST(RandomStreams, of_growth_is_that_of_the_seed)
{
    EXPECT_EQ(randomStream(7, Purpose::growth).bits(), Random(7).bits());
}

} // namespace
} // namespace neuralmesh
