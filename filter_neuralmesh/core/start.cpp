// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/start.h"

#include <vector>

#include "core/free_memory.h"
#include "core/mesh/boundary.h"
#include "core/shape/start_from_data.h"
#include "core/space/plain_points.h"
#include "core/topology/starting_mesh.h"
#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

/// Samples from which the starting solid takes its place and shape.
constexpr std::size_t startingSamples = 1000;

bool startsFromData(const GrowthParameters &parameters)
{
    return parameters.startMesh == StartMesh::fromData ||
           (parameters.topology == Topology::learned &&
            parameters.startMesh == StartMesh::tetrahedron);
}

/// Where time is up meanwhile, there is no shape.
void readShape(Start &start, NeuralMesh &mesh, const Sampler &sampler,
               const GrowthParameters &parameters, Workers &workers)
{
    const Progress progress = [&](double fraction, const char *activity) {
        workers.watch().report(shareOfStart * fraction, activity);
        return true;
    };
    try {
        const CoarseShape found = startFromData(mesh, sampler, parameters, workers, progress);
        start.shape = found.isTrusted ? LearnedShape::found : LearnedShape::notFound;
        start.isShapeClear = !found.isTrusted || found.isClear;
        start.gaps = found.isTrusted ? found.openings : 0;
    } catch (const TimeIsUp &) {
        start.shape = LearnedShape::notFinished;
    }
}

} // namespace

void requireAtLeast(Parameter parameter, int count, int startingVertices)
{
    if (count < startingVertices)
        throw InvalidParameter(parameter, InvalidParameter::Problem::belowStart, count,
                               startingVertices);
}

void requireEnoughPoints(const Sampler &sampler, int target)
{
    const auto wanted = static_cast<std::size_t>(target);
    const std::size_t distinct = sampler.countDistinctPoints(wanted);
    if (distinct < wanted)
        throw InvalidParameter(Parameter::targetVertexCount,
                               InvalidParameter::Problem::aboveDistinctPoints, target,
                               static_cast<double>(distinct));
    requireMemory(target);
}

Start makeStart(NeuralMesh &mesh, const Sampler &sampler, const GrowthParameters &parameters,
                Random &random, Workers &workers)
{
    Start start;
    if (startsFromData(parameters))
        readShape(start, mesh, sampler, parameters, workers);
    const bool isFound = start.shape == LearnedShape::found;
    start.hasShape = isFound || parameters.startMesh == StartMesh::given;
    const bool isFinished = start.shape != LearnedShape::notFinished;
    if (isFinished && sampler.isFlat() && (!start.hasShape || isClosed(mesh)))
        throw FlatTarget(start.shape != LearnedShape::notAsked, sampler.outliers().count);
    if (!start.hasShape) {
        std::vector<Point> drawn;
        sampler.draw(random, startingSamples, drawn);
        makeStartingSolid(mesh, parameters.startMesh, toVcg(drawn));
    }
    requireAtLeast(Parameter::targetVertexCount, parameters.targetVertexCount, mesh.vn);
    if (!parameters.snapshots.empty() && !isFound)
        requireAtLeast(Parameter::snapshots, parameters.snapshots.front(), mesh.vn);
    return start;
}

} // namespace neuralmesh
