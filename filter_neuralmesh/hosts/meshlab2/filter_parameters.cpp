// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_parameters.h"

#include <QStringList>

#include <algorithm>
#include <cctype>

#include "hosts/common/threads.h"

namespace neuralmesh::meshlab2 {
namespace {

/// The place of the chosen option among those of filters.json, which are in the core's order.
template <class Enum>
Enum option(const MeshFilterParameterValues &values, const char *id, const QStringList &options)
{
    const QString chosen = values.value(QLatin1String(id)).toString();
    const auto place = options.indexOf(chosen);
    if (place < 0)
        throw InvalidInput(std::string(id) + " must be one of " +
                           options.join(QStringLiteral(", ")).toStdString() + ", not '" +
                           chosen.toStdString() + "'.");
    return static_cast<Enum>(place);
}

/// "20, 100,1000", in any order. Empty: none.
std::vector<int> snapshotCounts(const QString &text)
{
    std::vector<int> counts;
    if (text.trimmed().isEmpty())
        return counts;
    for (const QString &entry : text.split(QLatin1Char(','))) {
        bool isCount = false;
        counts.push_back(entry.trimmed().toInt(&isCount));
        if (!isCount)
            throw InvalidInput(
                "snapshots must be vertex counts separated by commas, such as 20,100,1000: '" +
                entry.trimmed().toStdString() + "' is none.");
    }
    std::sort(counts.begin(), counts.end());
    return counts;
}

std::string idOf(Parameter parameter)
{
    return parameter == Parameter::targetVertexCount ? "targetVertNum" : nameOf(parameter);
}

std::string rangeEnd(char variable, bool isUpper)
{
    return std::string(isUpper ? "max" : "min") + static_cast<char>(std::toupper(variable));
}

} // namespace

GrowthParameters growthParameters(const MeshFilterParameterValues &values, std::uint64_t seed)
{
    const auto value = [&](const char *id) { return values.value(QLatin1String(id)); };
    GrowthParameters growth;
    growth.targetVertexCount = value("targetVertNum").toInt();
    growth.topology = option<Topology>(values, "topology", {"of_start", "learned"});
    growth.boundaries = option<BoundaryRule>(values, "boundaries", {"closed", "open"});
    growth.maxHoleSize = value("maxHoleSize").toDouble() / 100;
    growth.snapshots = snapshotCounts(value("snapshots").toString());
    growth.surfaceFit = value("surfaceFit").toBool();
    growth.startMesh = option<StartMesh>(
        values, "startMesh", {"tetrahedron", "octahedron", "icosahedron", "a_layer", "from_data"});
    growth.threads = threadsAllowed(value("threads").toInt());
    growth.winnerRate = value("winnerRate").toDouble();
    growth.smoothingRate = value("smoothingRate").toDouble();
    growth.smoothingPasses = value("smoothingPasses").toInt();
    growth.signalsPerSplit = value("signalsPerSplit").toInt();
    growth.inactivityFactor = value("inactivityFactor").toInt();
    growth.counterDecay = value("counterDecay").toDouble();
    growth.splitRule = option<SplitRule>(values, "splitRule", {"balanced", "paper"});
    growth.edgeFlips = value("edgeFlips").toBool();
    growth.seed = seed;
    return growth;
}

Source sourceOf(const MeshFilterParameterValues &values)
{
    return option<Source>(values, "source", {"points", "surface", "visible_layers", "point_file"});
}

const HostTerms &terms()
{
    static const HostTerms terms{idOf,
                                 "densityFromQuality",
                                 "pointFile",
                                 "starting layer",
                                 rangeEnd,
                                 "topology 'learned'",
                                 "boundaries 'open'",
                                 "; numbers of more than about 10^38 are none for the host",
                                 ", by more than the seven digits that the host keeps",
                                 ": open it in MeshLab and export it with binary encoding.",
                                 ": open it in MeshLab and export it as PLY with binary encoding."};
    return terms;
}

} // namespace neuralmesh::meshlab2
