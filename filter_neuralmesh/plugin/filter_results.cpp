// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_results.h"

#include <cstdio>

#include <common/plugins/interfaces/filter_plugin.h>

#include "core/mesh_checks.h"

std::map<std::string, QVariant> resultValues(const Reconstruction &result)
{
    const neuralmesh::TopologyFigures topology = neuralmesh::measureTopology(result.mesh);
    const std::vector<int> histogram = neuralmesh::valenceHistogram(result.mesh);
    Eigen::VectorXd valences(static_cast<Eigen::Index>(histogram.size()));
    for (std::size_t k = 0; k < histogram.size(); ++k)
        valences[static_cast<Eigen::Index>(k)] = histogram[k];
    return {{"vertices", topology.vertices},
            {"faces", topology.faces},
            {"genus", topology.genus},
            {"components", topology.components},
            {"boundary_loops", 0}, // validate() knows closed meshes only
            {"splits", static_cast<int>(result.growth.splitCount)},
            {"collapses", static_cast<int>(result.growth.collapseCount)},
            {"seed", static_cast<int>(result.seed)},
            {"signals", static_cast<double>(result.growth.signalCount)},
            {"seconds", result.seconds},
            {"reached_target", result.growth.reachedTarget},
            {"valence_histogram", QVariant::fromValue(valences)}};
}

std::string summary(const Reconstruction &result)
{
    char figures[256];
    std::snprintf(figures, sizeof figures,
                  "Neural mesh: %d vertices, %d faces; %.3g signals, %.0f splits, %.0f collapses, "
                  "seed %.0f, %.2f s.",
                  result.mesh.vn, result.mesh.fn, static_cast<double>(result.growth.signalCount),
                  static_cast<double>(result.growth.splitCount),
                  static_cast<double>(result.growth.collapseCount),
                  static_cast<double>(result.seed), result.seconds);
    std::string text = figures;
    if (!result.growth.reachedTarget)
        text += " TargetVertNum was not reached: the input has too few points for more vertices, "
                "each new one takes the points of another.";
    return text;
}
