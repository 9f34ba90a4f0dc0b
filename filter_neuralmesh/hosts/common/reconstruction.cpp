// SPDX-License-Identifier: GPL-3.0-or-later
#include "hosts/common/reconstruction.h"

#include <cstdio>

namespace neuralmesh {
namespace {

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

/// A count as people write it: 10,100.
template <class Integer> std::string grouped(Integer count)
{
    std::string text = std::to_string(count);
    for (std::size_t end = text.size(); end > 3; end -= 3)
        text.insert(end - 3, ",");
    return text;
}

std::string counted(int count, const std::string &singular, const std::string &plural)
{
    return grouped(count) + " " + (count == 1 ? singular : plural);
}

/// What was opened, joined and filled; nothing where nothing was.
std::string topologyChanges(const TopologyChanges &changes)
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

std::string topology(const Report &report, const HostTerms &terms)
{
    std::string text = " Topology: " + counted(report.components, "component", "components") +
                       ", genus " + std::to_string(report.genus) + ", " +
                       counted(report.boundaryLoops, "boundary loop", "boundary loops") + ".";
    switch (report.changes.shape) {
    case LearnedShape::notAsked: text += " It is that of the starting mesh."; break;
    case LearnedShape::found:
        text += report.changes.isShapeClear
                    ? " It was learned from the data."
                    : " It was learned from the data. Warning: the points leave the shape open: "
                      "handles or parts may be missing, or too many. More points may help, or less "
                      "noise.";
        break;
    case LearnedShape::notFinished:
        text +=
            " It is that of the starting mesh, since the shape of the data was not read in time.";
        break;
    case LearnedShape::notFound:
        text += " Warning: it is that of the starting mesh, since the points tell no shape that "
                "can be trusted. More points may help, or less noise, or a " +
                terms.startingMesh + ".";
    }
    return text + topologyChanges(report.changes);
}

/// How a deadline cut the run short; nothing where none did.
std::string timeUp(const Report &report, const HostTerms &terms)
{
    const std::string limit = " " + terms.parameter(Parameter::timeLimit);
    switch (report.timeUp) {
    case TimeUp::no: break;
    case TimeUp::inGrowth: return limit + " ended the growth: this is the mesh so far.";
    case TimeUp::inSurfaceFit:
        return limit +
               " ended the surface fit: this is the mesh so far, less accurate than it would "
               "have become.";
    }
    return {};
}

/// What in the result is not to be trusted, and what to try.
std::string warnings(const Report &report, const HostTerms &terms)
{
    std::string text;
    const std::string target = terms.parameter(Parameter::targetVertexCount);
    const bool isLearned = report.changes.shape != LearnedShape::notAsked;
    if (report.coverage < leastCoverage)
        text += " Warning: " + percent(1 - report.coverage) +
                " of the points are not near the mesh, which is not to be trusted. Try " +
                (isLearned ? "" : terms.learnedTopology + ", or ") + "a higher " + target + ".";
    if (report.unsupportedArea > mostUnsupported)
        text +=
            " Warning: " + percent(report.unsupportedArea) +
            " of the mesh lies where there are no points: it closes holes in the data, or joins "
            "parts of it. Try " +
            (isLearned ? terms.openBoundaries + ", or a smaller " +
                             terms.parameter(Parameter::maxHoleSize) + "."
                       : terms.learnedTopology + ".");
    if (report.selfIntersections > 0)
        text += " Warning: " + grouped(report.selfIntersections) +
                " faces intersect another. Where walls are closer to each other than the vertices, "
                "a higher " +
                target + " parts them.";
    return text;
}

} // namespace

std::string summary(const Reconstruction &reconstruction, const HostTerms &terms)
{
    const Report &report = reconstruction.result.report;
    char error[64];
    std::snprintf(error, sizeof error, "%.3g (%.2g %% of the diagonal)", report.rmsError,
                  100 * report.rmsError / reconstruction.diagonal);
    char seconds[32];
    std::snprintf(seconds, sizeof seconds, "%.2f s", reconstruction.seconds);
    std::string text = "Neural mesh: " + grouped(report.vertices) + " vertices, " +
                       grouped(report.faces) + " faces, RMS error " + error + "; " +
                       grouped(report.signalCount) + " signals, " + grouped(report.splitCount) +
                       " splits, " + grouped(report.collapseCount) + " collapses, seed " +
                       std::to_string(reconstruction.seed) + ", " + seconds + ".";
    text += timeUp(report, terms);
    if (report.keptIdle)
        text += " To reach " + terms.parameter(Parameter::targetVertexCount) +
                ", vertices were kept that are nearest to no sample. That is no harm by itself; it "
                "happens where the target is close to the number of points, where the mesh has "
                "folded, and where " +
                terms.parameter(Parameter::inactivityFactor) + " or " +
                terms.parameter(Parameter::signalsPerSplit) + " is low.";
    return text + topology(report, terms) + warnings(report, terms);
}

std::string outlierRemark(const Outliers &outliers)
{
    if (outliers.count == 0)
        return {};
    const bool isOne = outliers.count == 1;
    char share[32];
    std::snprintf(share, sizeof share, "%.2g", 100 * outliers.share);
    return (outliers.isEstimate ? "About " : "") + grouped(outliers.count) +
           (isOne ? " isolated point, " : " isolated points, ") + share + " % of the cloud, " +
           (isOne ? "is ignored." : "are ignored.");
}

} // namespace neuralmesh
