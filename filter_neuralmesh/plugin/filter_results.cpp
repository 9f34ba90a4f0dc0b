// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_results.h"

#include <cstdio>

#include <common/plugins/interfaces/filter_plugin.h>

namespace {

template <class T> QVariant toVector(const std::vector<T> &values)
{
    Eigen::VectorXd vector(static_cast<Eigen::Index>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
        vector[static_cast<Eigen::Index>(k)] = values[k];
    return QVariant::fromValue(vector);
}

/// Shares from which a result is not what the points say: noise and the isolated points that a
/// cloud may hold leave them on the right side.
constexpr double leastCoverage = 0.9;
constexpr double mostUnsupported = 0.05;

std::string percent(double share)
{
    char text[16];
    std::snprintf(text, sizeof text, "%.0f %%", 100 * share);
    return text;
}

std::string counted(int count, const std::string &singular, const std::string &plural)
{
    return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

/// What was opened, joined and filled; nothing where nothing was.
std::string topologyChanges(const neuralmesh::TopologyChanges &changes)
{
    std::vector<std::string> parts;
    const auto add = [&](int count, const char *singular, const char *plural, const char *how) {
        if (count > 0)
            parts.push_back(counted(count, singular, plural) + how);
    };
    add(changes.gaps, "gap in the data", "gaps in the data", " left open");
    add(changes.websRemoved, "web", "webs", " between limbs removed");
    add(changes.holesFilled, "hole", "holes", " filled");
    add(changes.sheetsDoubled, "open sheet", "open sheets", " closed by a second one behind");
    std::string text;
    for (const std::string &part : parts)
        text += (text.empty() ? " " : ", ") + part;
    return text.empty() ? text : text + ".";
}

std::string topology(const neuralmesh::Report &report)
{
    std::string text = " Topology: " + counted(report.components, "component", "components") +
                       ", genus " + std::to_string(report.genus) + ", " +
                       counted(report.boundaryLoops, "boundary loop", "boundary loops") + ".";
    switch (report.changes.shape) {
    case neuralmesh::LearnedShape::notAsked: text += " It is that of the starting mesh."; break;
    case neuralmesh::LearnedShape::found:
        text += report.changes.isShapeClear
                    ? " It was learned from the data."
                    : " It was learned from the data, which leave it open: handles or parts may be "
                      "missing, or too many. More points may help, or less noise.";
        break;
    case neuralmesh::LearnedShape::notFound:
        text += " Warning: it is that of the starting mesh, since the points tell no shape that "
                "can be trusted. More points may help, or less noise, or a starting layer.";
    }
    return text + topologyChanges(report.changes);
}

/// What in the result is not to be trusted, and what to try.
std::string warnings(const neuralmesh::Report &report)
{
    std::string text;
    const bool isLearned = report.changes.shape != neuralmesh::LearnedShape::notAsked;
    if (report.coverage < leastCoverage)
        text += " Warning: " + percent(1 - report.coverage) +
                " of the points are not near the mesh, which is not to be trusted. Try " +
                (isLearned ? "" : "Topology learned from the data, or ") +
                "a higher TargetVertNum.";
    if (report.unsupportedArea > mostUnsupported)
        text +=
            " Warning: " + percent(report.unsupportedArea) +
            " of the mesh lies where there are no points: it closes holes in the data, or joins "
            "parts of it. Try " +
            (isLearned ? "Boundaries open, or a smaller MaxHoleSize."
                       : "Topology learned from the data.");
    if (report.selfIntersections > 0)
        text += " " + std::to_string(report.selfIntersections) +
                " faces intersect another. Where walls are closer to each other than the vertices, "
                "a higher TargetVertNum parts them.";
    return text;
}

} // namespace

std::map<std::string, QVariant> resultValues(const Reconstruction &reconstruction)
{
    const neuralmesh::Report &report = reconstruction.result.report;
    return {{"vertices", report.vertices},
            {"faces", report.faces},
            {"genus", report.genus},
            {"components", report.components},
            {"boundary_loops", report.boundaryLoops},
            {"splits", static_cast<int>(report.splitCount)},
            {"collapses", static_cast<int>(report.collapseCount)},
            {"self_intersections", report.selfIntersections},
            {"seed", static_cast<int>(reconstruction.seed)},
            {"signals", static_cast<double>(report.signalCount)},
            {"seconds", reconstruction.seconds},
            {"reached_target", report.reachedTarget},
            {"rms_error", report.rmsError},
            {"max_error", report.maxError},
            {"coverage", report.coverage},
            {"unsupported_area", report.unsupportedArea},
            {"convergence", toVector(report.convergence)},
            {"valence_histogram", toVector(report.valenceHistogram)}};
}

std::string summary(const Reconstruction &reconstruction)
{
    const neuralmesh::Report &report = reconstruction.result.report;
    char figures[256];
    std::snprintf(figures, sizeof figures,
                  "Neural mesh: %d vertices, %d faces, RMS error %.3g; %.3g signals, %.0f splits, "
                  "%.0f collapses, seed %.0f, %.2f s.",
                  report.vertices, report.faces, report.rmsError,
                  static_cast<double>(report.signalCount), static_cast<double>(report.splitCount),
                  static_cast<double>(report.collapseCount),
                  static_cast<double>(reconstruction.seed), reconstruction.seconds);
    std::string text = figures;
    if (report.keptIdle)
        text +=
            " To reach TargetVertNum, vertices were kept that are nearest to no sample. That is "
            "no harm by itself; it happens where TargetVertNum is close to the number of points, "
            "and where InactivityFactor or SignalsPerSplit is low.";
    return text + topology(report) + warnings(report);
}
