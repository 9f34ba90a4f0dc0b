// SPDX-License-Identifier: GPL-3.0-or-later
// The throttle needs nothing of the host but the type of its callback.
#include "plugin/host_progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

namespace {

int calls = 0;
std::vector<int> percents;
bool answer = true;

bool hostCallback(const int percent, const char *)
{
    ++calls;
    percents.push_back(percent);
    return answer;
}

TEST(HostProgress, passes_on_the_first_report_and_holds_back_those_that_follow_at_once)
{
    calls = 0;
    answer = true;
    const neuralmesh::Progress progress = throttledProgress(hostCallback);
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 1000; ++i)
        EXPECT_TRUE(progress(i / 1000.0, "working"));
    const auto tenths = (std::chrono::steady_clock::now() - start) / std::chrono::milliseconds(100);
    EXPECT_GE(calls, 1);
    EXPECT_LE(calls, 1 + tenths);
}

TEST(HostProgress, never_runs_backwards)
{
    percents.clear();
    answer = true;
    const neuralmesh::Progress progress = throttledProgress(hostCallback);
    for (const double fraction : {0.5, 0.2, 0.6}) {
        progress(fraction, "working");
        std::this_thread::sleep_for(std::chrono::milliseconds(110)); // more than the throttle
    }
    EXPECT_EQ(percents, (std::vector<int>{50, 50, 60}));
}

TEST(HostProgress, passes_a_false_back)
{
    answer = false;
    EXPECT_FALSE(throttledProgress(hostCallback)(0.5, "working"));
}

TEST(HostProgress, is_none_where_the_host_has_no_callback)
{
    EXPECT_FALSE(throttledProgress(nullptr));
}

} // namespace
