// SPDX-License-Identifier: GPL-3.0-or-later
#include "hosts/common/progress_part.h"

#include <gtest/gtest.h>

#include <vector>

namespace neuralmesh {
namespace {

TEST(ProgressPart, is_reported_between_its_bounds)
{
    std::vector<double> fractions;
    const Progress whole = [&](double fraction, const char *) {
        fractions.push_back(fraction);
        return fraction < 0.75;
    };
    EXPECT_TRUE(part(whole, 0.25, 0.75)(0, "working"));
    EXPECT_TRUE(part(whole, 0.25, 0.75)(0.5, "working"));
    EXPECT_FALSE(part(whole, 0.25, 0.75)(1, "working"));
    EXPECT_EQ(fractions, (std::vector<double>{0.25, 0.5, 0.75}));
    EXPECT_FALSE(part({}, 0.25, 0.75));
}

} // namespace
} // namespace neuralmesh
