// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_sentences.h"

#include <cctype>

#include "hosts/common/error_sentences.h"

namespace {

using neuralmesh::Parameter;

std::string filterParameter(Parameter parameter)
{
    switch (parameter) {
    case Parameter::targetVertexCount: return "TargetVertNum";
    case Parameter::winnerRate: return "WinnerRate";
    case Parameter::smoothingRate: return "SmoothingRate";
    case Parameter::smoothingPasses: return "SmoothingPasses";
    case Parameter::signalsPerSplit: return "SignalsPerSplit";
    case Parameter::inactivityFactor: return "InactivityFactor";
    case Parameter::threads: return "Threads";
    case Parameter::counterDecay: return "CounterDecay";
    case Parameter::snapshots: return "Snapshots";
    case Parameter::maxHoleSize: return "MaxHoleSize";
    }
    return {};
}

std::string fieldOfRange(char variable, bool isUpper)
{
    return std::string(isUpper ? "max" : "min") + static_cast<char>(std::toupper(variable));
}

} // namespace

const neuralmesh::HostTerms &filterTerms()
{
    static const neuralmesh::HostTerms terms{
        filterParameter,
        "DensityFromQuality",
        "PointFile",
        "starting layer",
        fieldOfRange,
        "Set Topology to 'Learned from the data'",
        "Topology learned from the data",
        "Boundaries open",
        ": open it in MeshLab and export it with binary encoding.",
        ": open it in MeshLab and export it as PLY with binary encoding."};
    return terms;
}

std::string sentenceFor(const neuralmesh::InvalidInput &error)
{
    return neuralmesh::sentenceFor(error, filterTerms());
}
