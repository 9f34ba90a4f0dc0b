// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/parameters.h"

#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

using Problem = InvalidParameter::Problem;

/// Twenty and a hundred times the paper's: time is in proportion to both, and nothing is gained
/// from there on.
constexpr int mostSmoothingPasses = 100;
constexpr int mostSignalsPerSplit = 10000;

void requireRate(Parameter parameter, double value)
{
    // Written so that NaN is refused too.
    if (!(value > 0 && value < 1))
        throw InvalidParameter(parameter, Problem::noRate, value, 1);
}

void requireAtLeast(Parameter parameter, int value, int least)
{
    if (value < least)
        throw InvalidParameter(parameter, Problem::belowLeast, value, least);
}

void requireAtMost(Parameter parameter, int value, int most)
{
    if (value > most)
        throw InvalidParameter(parameter, Problem::aboveMost, value, most);
}

void requireSnapshots(const std::vector<int> &counts, int target)
{
    const auto refuse = [](Problem problem, int count, int limit) {
        throw InvalidParameter(Parameter::snapshots, problem, count, limit);
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (i > 0 && counts[i] == counts[i - 1])
            refuse(Problem::repeated, counts[i], counts[i - 1]);
        if (i > 0 && counts[i] < counts[i - 1])
            refuse(Problem::notAscending, counts[i], counts[i - 1]);
        if (counts[i] > target)
            refuse(Problem::aboveTarget, counts[i], target);
    }
}

} // namespace

void GrowthParameters::validate() const
{
    requireAtLeast(Parameter::targetVertexCount, targetVertexCount, 4);
    requireRate(Parameter::winnerRate, winnerRate);
    requireRate(Parameter::smoothingRate, smoothingRate);
    requireAtLeast(Parameter::smoothingPasses, smoothingPasses, 1);
    requireAtMost(Parameter::smoothingPasses, smoothingPasses, mostSmoothingPasses);
    requireAtLeast(Parameter::signalsPerSplit, signalsPerSplit, 1);
    requireAtMost(Parameter::signalsPerSplit, signalsPerSplit, mostSignalsPerSplit);
    requireAtLeast(Parameter::inactivityFactor, inactivityFactor, 1);
    requireAtLeast(Parameter::threads, threads, 0);
    requireRate(Parameter::counterDecay, counterDecay);
    requireSnapshots(snapshots, targetVertexCount);
    if (!(maxHoleSize >= 0))
        throw InvalidParameter(Parameter::maxHoleSize, Problem::belowLeast, maxHoleSize, 0);
}

} // namespace neuralmesh
