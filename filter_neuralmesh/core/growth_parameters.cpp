// SPDX-License-Identifier: GPL-3.0-or-later
#include "growth_parameters.h"

#include <string>

#include "errors.h"

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
}

} // namespace neuralmesh
