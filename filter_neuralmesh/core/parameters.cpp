// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/parameters.h"

#include <string>

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

void requireRate(const char *name, double value)
{
    // Written so that NaN is refused too.
    if (!(value > 0 && value < 1))
        throw InvalidInput(std::string(name) + " must lie between 0 and 1, both excluded.");
}

void requireAtLeast(const char *name, int value, int least)
{
    if (value < least)
        throw InvalidInput(std::string(name) + " must be at least " + std::to_string(least) +
                           ", not " + std::to_string(value) + ".");
}

void requireSnapshots(const std::vector<int> &counts, int target)
{
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::string named = "Snapshots names " + std::to_string(counts[i]) + " vertices";
        if (i > 0 && counts[i] == counts[i - 1])
            throw InvalidInput(named + " twice.");
        if (i > 0 && counts[i] < counts[i - 1])
            throw InvalidInput(named + " after more of them.");
        if (counts[i] > target)
            throw InvalidInput(named + ", more than TargetVertNum, which is " +
                               std::to_string(target) + ".");
    }
}

} // namespace

void GrowthParameters::validate() const
{
    requireAtLeast("TargetVertNum", targetVertexCount, 4);
    requireRate("WinnerRate", winnerRate);
    requireRate("SmoothingRate", smoothingRate);
    requireAtLeast("SmoothingPasses", smoothingPasses, 1);
    requireAtLeast("SignalsPerSplit", signalsPerSplit, 1);
    requireAtLeast("InactivityFactor", inactivityFactor, 1);
    requireRate("CounterDecay", counterDecay);
    requireSnapshots(snapshots, targetVertexCount);
}

} // namespace neuralmesh
