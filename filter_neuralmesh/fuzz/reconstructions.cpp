// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters and a small cloud, at times with a starting mesh: either it is refused by a sentence,
// or the result keeps its promises. Fourteen bytes are parameters, and the rest points of three.
#include <cmath>
#include <vector>

#include "fuzz/choices.h"
#include "fuzz/fuzz_target.h"
#include "neuralmesh/samplers.h"
#include "tests/promises.h"

namespace neuralmesh::fuzz {
namespace {

constexpr std::size_t mostPoints = 700; // from 500 on there are isolated points

GrowthParameters parametersOf(Choices &choices)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = 4 + choices.below(61);
    const int switches = choices.byte();
    parameters.topology = (switches & 1) != 0 ? Topology::ofStart : Topology::learned;
    parameters.boundaries = (switches & 2) != 0 ? BoundaryRule::open : BoundaryRule::closed;
    parameters.splitRule = (switches & 4) != 0 ? SplitRule::paper : SplitRule::balanced;
    parameters.edgeFlips = (switches & 8) == 0;
    parameters.surfaceFit = (switches & 16) == 0;
    parameters.threads = (switches & 32) != 0 ? 2 : 1;
    parameters.startMesh = static_cast<StartMesh>(choices.below(5));
    parameters.smoothingPasses = 1 + choices.below(8);
    parameters.signalsPerSplit = 1 + choices.below(120);
    parameters.inactivityFactor = 1 + choices.below(20);
    parameters.winnerRate = choices.share();
    parameters.smoothingRate = choices.share();
    parameters.counterDecay = choices.share();
    parameters.maxHoleSize = choices.byte() / 64.0;
    parameters.seed = static_cast<std::uint64_t>(choices.byte()) + 1;
    if (const int count = choices.below(65); count > 0)
        parameters.snapshots = {count};
    return parameters;
}

/// Mostly sixteenths of `unit`; some that are telling.
double coordinate(Choices &choices, double unit)
{
    const auto code = static_cast<std::int8_t>(choices.byte());
    switch (code) {
    case -128: return std::nan("");
    case -127: return 1e300;
    case -126: return 1e-300;
    case -125: return 1e6 * unit;
    default: return code / 16.0 * unit;
    }
}

std::vector<Point> pointsOf(Choices &choices)
{
    const double unit = std::pow(10.0, choices.below(61) - 30);
    std::vector<Point> points;
    while (!choices.isEnd() && points.size() < mostPoints) {
        Point &point = points.emplace_back();
        for (double &place : point)
            place = coordinate(choices, unit);
    }
    return points;
}

Mesh startOf(Choices &choices)
{
    Mesh start;
    for (int i = choices.below(12); i > 0; --i)
        start.triangles.push_back({static_cast<VertexId>(choices.below(10)),
                                   static_cast<VertexId>(choices.below(10)),
                                   static_cast<VertexId>(choices.below(10))});
    for (int i = choices.below(10); i > 0; --i)
        start.positions.push_back(
            {coordinate(choices, 1), coordinate(choices, 1), coordinate(choices, 1)});
    return start;
}

void run(Choices &choices)
{
    const GrowthParameters parameters = parametersOf(choices);
    const bool isGiven = parameters.startMesh == StartMesh::given;
    const Mesh start = isGiven ? startOf(choices) : Mesh();
    const auto sampler = pointCloudSampler(pointsOf(choices));
    const auto checkSnapshot = [&](const Mesh &snapshot) {
        require(static_cast<int>(snapshot.positions.size()) == parameters.snapshots.front(),
                "the number of vertices of a snapshot");
    };
    const Result result = isGiven ? reconstructFrom(start, *sampler, parameters, {}, checkSnapshot)
                                  : reconstruct(*sampler, parameters, {}, checkSnapshot);
    const std::string broken = test::brokenPromise(result, *sampler, parameters);
    require(broken.empty(), broken);
}

} // namespace
} // namespace neuralmesh::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    neuralmesh::fuzz::Choices choices(data, size);
    return neuralmesh::fuzz::refusingOrNot([&] { neuralmesh::fuzz::run(choices); });
}
