// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/signal_counters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "neuralmesh/random.h"

namespace neuralmesh {
namespace {

/// The reference: every counter touched at every signal, as equation 7 says.
class NaiveCounters {
public:
    std::map<VertexId, double> values;

    void decay(double alpha)
    {
        for (auto &[id, value] : values)
            value *= alpha;
    }
    double highestValue() const
    {
        double highest = 0;
        for (const auto &[id, value] : values)
            highest = std::max(highest, value);
        return highest;
    }
};

void expectSame(const SignalCounters &counters, const NaiveCounters &naive)
{
    ASSERT_EQ(counters.size(), naive.values.size());
    for (const auto &[id, value] : naive.values)
        ASSERT_NEAR(counters.value(id), value, 1e-9 * (1 + value));
    ASSERT_NEAR(counters.value(counters.highest()), naive.highestValue(),
                1e-9 * (1 + naive.highestValue()));
}

void follow(double alpha, std::uint64_t seed, int operations)
{
    Random random(seed);
    SignalCounters counters;
    NaiveCounters naive;
    for (int i = 0; i < operations; ++i) {
        const auto id = static_cast<VertexId>(random.below(40));
        const double value = 10 * random.unit();
        if (!counters.contains(id)) {
            counters.insert(id, value);
            naive.values[id] = value;
        } else if (const std::uint64_t choice = random.below(20); choice == 0) {
            counters.erase(id);
            naive.values.erase(id);
        } else if (choice == 1) {
            counters.set(id, value);
            naive.values[id] = value;
        } else {
            counters.add(id, value);
            naive.values[id] += value;
            counters.decay(alpha);
            naive.decay(alpha);
        }
        if (!naive.values.empty())
            expectSame(counters, naive);
    }
}

TEST(SignalCounters, decay_as_if_every_counter_were_multiplied)
{
    follow(0.95, 1, 20000);   // the paper's: the unit passes 1e100 every 4,500 signals
    follow(0.99999, 2, 5000); // a long memory
    follow(0.05, 3, 5000);    // rescaled every 77 signals
}

TEST(SignalCounters, give_the_lowest_id_of_equal_counters)
{
    SignalCounters counters;
    for (const VertexId id : {8U, 2U, 5U})
        counters.insert(id, 1);
    EXPECT_EQ(counters.highest(), 2U);
    counters.add(5);
    EXPECT_EQ(counters.highest(), 5U);
    counters.erase(5);
    EXPECT_EQ(counters.highest(), 2U);
}

} // namespace
} // namespace neuralmesh
