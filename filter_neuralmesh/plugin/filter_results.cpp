// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_results.h"

#include <cstdio>

#include <common/plugins/interfaces/filter_plugin.h>

#include "core/mesh/mesh_checks.h"

namespace {

template <class T> QVariant toVector(const std::vector<T> &values, double scale)
{
    Eigen::VectorXd vector(static_cast<Eigen::Index>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
        vector[static_cast<Eigen::Index>(k)] = scale * values[k];
    return QVariant::fromValue(vector);
}

} // namespace

std::map<std::string, QVariant> resultValues(const Reconstruction &result)
{
    const neuralmesh::TopologyFigures topology = neuralmesh::measureTopology(result.mesh);
    return {{"vertices", topology.vertices},
            {"faces", topology.faces},
            {"genus", topology.genus},
            {"components", topology.components},
            {"boundary_loops", 0}, // closed by construction: rings have no ends
            {"splits", static_cast<int>(result.growth.splitCount)},
            {"collapses", static_cast<int>(result.growth.collapseCount)},
            {"self_intersections", result.growth.selfIntersections},
            {"seed", static_cast<int>(result.seed)},
            {"signals", static_cast<double>(result.growth.signalCount)},
            {"seconds", result.seconds},
            {"reached_target", result.growth.reachedTarget},
            {"rms_error", result.growth.rmsError * result.diagonal},
            {"max_error", result.growth.maxError * result.diagonal},
            {"convergence", toVector(result.growth.convergence, result.diagonal)},
            {"valence_histogram", toVector(neuralmesh::valenceHistogram(result.mesh), 1)}};
}

std::string summary(const Reconstruction &result)
{
    char figures[256];
    std::snprintf(figures, sizeof figures,
                  "Neural mesh: %d vertices, %d faces, RMS error %.3g; %.3g signals, %.0f splits, "
                  "%.0f collapses, seed %.0f, %.2f s.",
                  result.mesh.vn, result.mesh.fn, result.growth.rmsError * result.diagonal,
                  static_cast<double>(result.growth.signalCount),
                  static_cast<double>(result.growth.splitCount),
                  static_cast<double>(result.growth.collapseCount),
                  static_cast<double>(result.seed), result.seconds);
    std::string text = figures;
    if (result.growth.keptIdle)
        text += " To reach TargetVertNum, vertices were kept that are nearest to no sample. Either "
                "the target is close to the number of points, or InactivityFactor or "
                "SignalsPerSplit is too low.";
    if (result.growth.selfIntersections > 0)
        text += " " + std::to_string(result.growth.selfIntersections) +
                " faces intersect another. Where walls are closer to each other than the vertices, "
                "a higher TargetVertNum parts them.";
    return text;
}
