// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/alias_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace neuralmesh {
namespace {

std::vector<int> counts(const std::vector<double> &weights, int draws)
{
    const AliasTable table(weights);
    Random random(1);
    std::vector<int> result(weights.size(), 0);
    for (int i = 0; i < draws; ++i)
        ++result[table.draw(random)];
    return result;
}

TEST(AliasTable, draws_in_proportion_to_the_weights)
{
    const std::vector<double> weights{1, 2, 3, 4, 0.5, 100, 7, 2.5};
    const int draws = 1000000;
    const std::vector<int> found = counts(weights, draws);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const double share = weights[i] / 120;
        // Five standard deviations of a binomial.
        const double tolerance = 5 * std::sqrt(draws * share * (1 - share));
        EXPECT_NEAR(found[i], draws * share, tolerance) << i;
    }
}

TEST(AliasTable, never_draws_what_has_no_weight)
{
    const std::vector<int> found = counts({0, 3, 0, 0.1, 0, 0, 1e-3, 0}, 100000);
    for (const std::size_t empty : {0U, 2U, 4U, 5U, 7U})
        EXPECT_EQ(found[empty], 0) << empty;
}

TEST(AliasTable, takes_weights_of_any_size)
{
    for (const double scale : {1e-300, 1.0, 1e308}) {
        const std::vector<int> found = counts({0.25 * scale, 0.75 * scale, scale}, 100000);
        EXPECT_NEAR(found[0], 12500, 525) << scale; // five standard deviations
        EXPECT_NEAR(found[2], 50000, 791) << scale;
    }
    EXPECT_EQ(counts({7}, 10)[0], 10);
}

} // namespace
} // namespace neuralmesh
