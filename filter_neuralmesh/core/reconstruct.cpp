// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/reconstruct.h"

#include <memory>

#include "core/fit/few_points.h"
#include "core/growth.h"
#include "core/mesh/mesh_checks.h"
#include "core/result/plain_mesh.h"
#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

/// `unit` is the length of the unit frame's unit in the world.
Report reportOf(const NeuralMesh &network, const GrowthReport &growth, double unit)
{
    const TopologyFigures topology = measureTopology(network);
    Report report;
    report.vertices = topology.vertices;
    report.faces = topology.faces;
    report.components = topology.components;
    report.genus = topology.genus;
    report.boundaryLoops = topology.boundaryLoops;
    report.valenceHistogram = valenceHistogram(network);
    report.signalCount = growth.signalCount;
    report.splitCount = growth.splitCount;
    report.collapseCount = growth.collapseCount;
    report.selfIntersections = growth.selfIntersections;
    report.reachedTarget = growth.reachedTarget;
    report.timeUp = growth.timeUp;
    report.keptIdle = growth.keptIdle;
    report.changes = growth.changes;
    report.rmsError = growth.rmsError * unit;
    report.maxError = growth.maxError * unit;
    report.coverage = growth.coverage;
    report.unsupportedArea = growth.unsupportedArea;
    for (const double error : growth.convergence)
        report.convergence.push_back(error * unit);
    return report;
}

Result growFrom(NeuralMesh &network, const Sampler &sampler, const GrowthParameters &parameters,
                const Progress &progress, const SnapshotTaker &takeSnapshot)
{
    const UnitFrame &frame = sampler.frame();
    NetworkTaker takeNetwork;
    if (takeSnapshot)
        takeNetwork = [&](std::unique_ptr<NeuralMesh> snapshot) {
            bringNearBounds(*snapshot, sampler, parameters.startMesh); // not all are finished
            takeSnapshot(plainMesh(*snapshot, frame));
        };
    const GrowthReport growth = grow(network, sampler, parameters, progress, takeNetwork);
    return {plainMesh(network, frame), reportOf(network, growth, frame.diagonal())};
}

} // namespace

Result reconstruct(const Sampler &sampler, const GrowthParameters &parameters,
                   const Progress &progress, const SnapshotTaker &takeSnapshot)
{
    if (parameters.startMesh == StartMesh::given)
        throw InvalidStartingMesh(InvalidStartingMesh::Problem::missing);
    NeuralMesh network;
    return growFrom(network, sampler, parameters, progress, takeSnapshot);
}

Result reconstructFrom(const Mesh &startingMesh, const Sampler &sampler,
                       const GrowthParameters &parameters, const Progress &progress,
                       const SnapshotTaker &takeSnapshot)
{
    parameters.validate();
    NeuralMesh network;
    makeNetwork(network, startingMesh, sampler.frame());
    GrowthParameters fromGiven = parameters;
    fromGiven.startMesh = StartMesh::given;
    return growFrom(network, sampler, fromGiven, progress, takeSnapshot);
}

} // namespace neuralmesh
