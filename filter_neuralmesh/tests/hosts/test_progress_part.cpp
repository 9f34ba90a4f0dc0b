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

TEST(ProgressPart, has_the_deadline_of_the_whole)
{
    bool isUp = false;
    const auto timeUp = [&] { return isUp; };
    const Progress heard([](double, const char *) { return true; }, timeUp);
    const Progress silent = Progress::silent(timeUp);
    EXPECT_FALSE(part(heard, 0, 1).isTimeUp());
    EXPECT_FALSE(part(silent, 0, 1).isTimeUp());
    isUp = true;
    EXPECT_TRUE(part(heard, 0, 1).isTimeUp());
    EXPECT_TRUE(part(silent, 0, 1).isTimeUp());
}

} // namespace
} // namespace neuralmesh
