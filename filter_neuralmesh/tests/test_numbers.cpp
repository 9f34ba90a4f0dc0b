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
