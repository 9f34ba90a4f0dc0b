// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/signal_activity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace neuralmesh {
namespace {

TEST(SignalActivity, is_one_for_a_sample_at_the_usual_distance)
{
    SignalActivity activity;
    for (int i = 0; i < 10; ++i)
        EXPECT_NEAR(activity.count(0.25), 1, 1e-12) << i;
}

TEST(SignalActivity, is_one_on_a_surface_that_no_sample_has_missed_yet)
{
    // A starting mesh that is given may have a vertex just where the first sample is.
    SignalActivity activity;
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(activity.count(0), 1) << i;
    EXPECT_TRUE(std::isfinite(activity.count(0.25)));
}

TEST(SignalActivity, grows_with_the_distance_up_to_a_limit)
{
    SignalActivity activity;
    for (int i = 0; i < 1000; ++i)
        activity.count(0.01);
    const double near = activity.count(0.0025);
    const double far = activity.count(0.04);
    EXPECT_NEAR(near, 0.25 + 0.75 / 2, 0.01); // half the usual root of the distance
    EXPECT_NEAR(far, 0.25 + 0.75 * 2, 0.01);
    EXPECT_EQ(activity.count(100), activity.count(1e6));
}

} // namespace
} // namespace neuralmesh
