// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/network/census.h"

#include <algorithm>
#include <iterator>

#include "core/mesh/enumeration.h"
#include "core/mesh/vertex_data.h"
#include "core/nth_root.h"

namespace neuralmesh {
namespace {

/// Samples for each vertex: one with the average share misses all with e^-10.
constexpr std::size_t samplesPerVertex = 10;

/// Where the points are few, a vertex may have only one of them: then so many for each point.
constexpr std::size_t fewPointsPerVertex = 4;

/// So many times as many idle vertices as by chance are hardly more.
constexpr double timesChance = 1.5;

/// How many of so many cells hold none of the points, where these fall into any of them alike.
double emptyCells(int cells, std::size_t points)
{
    return cells * power(1 - 1.0 / cells, points);
}

} // namespace

Census::Census(int vertices, std::size_t points)
    : samples_(samplesPerVertex * (points < fewPointsPerVertex * static_cast<std::size_t>(vertices)
                                       ? points
                                       : static_cast<std::size_t>(vertices))),
      idleByChance_(emptyCells(vertices, points))
{
}

std::vector<VertexId> Census::misplaced(GrowingNetwork &network,
                                        const std::vector<Point3> &samples) const
{
    std::vector<VertexId> idle = this->idle(network, samples);
    if (network.isOpenSurface())
        return idle; // as with webs: the sheet that closes it crosses it, and is to stay
    const std::vector<VertexId> crossing = network.findSelfIntersections().corners;
    std::vector<VertexId> either;
    std::set_union(idle.begin(), idle.end(), crossing.begin(), crossing.end(),
                   std::back_inserter(either));
    return either;
}

std::vector<VertexId> Census::idle(const GrowingNetwork &network,
                                   const std::vector<Point3> &samples) const
{
    VertexData<char> hasWon(network.mesh(), 0);
    std::vector<VertexId> winners(samples.size());
    network.locator().forEachNearest(
        network.workers(), samples, [&](std::size_t i, VertexId nearest) { winners[i] = nearest; });
    for (const VertexId winner : winners)
        hasWon[winner] = 1;
    std::vector<VertexId> idle;
    forEachVertex(network.mesh(), [&](VertexId v) {
        if (hasWon[v] == 0)
            idle.push_back(v);
    });
    if (static_cast<double>(idle.size()) <= timesChance * idleByChance_)
        idle.clear();
    return idle;
}

} // namespace neuralmesh
