// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_sentences.h"

#include <cctype>

#include "hosts/common/error_sentences.h"
#include "parameter_names.h"

namespace {

using neuralmesh::Parameter;

std::string filterParameter(Parameter parameter)
{
    switch (parameter) {
    case Parameter::targetVertexCount: return named("TargetVertNum");
    case Parameter::winnerRate: return named("WinnerRate");
    case Parameter::smoothingRate: return named("SmoothingRate");
    case Parameter::smoothingPasses: return named("SmoothingPasses");
    case Parameter::signalsPerSplit: return named("SignalsPerSplit");
    case Parameter::inactivityFactor: return named("InactivityFactor");
    case Parameter::threads: return named("Threads");
    case Parameter::counterDecay: return named("CounterDecay");
    case Parameter::snapshots: return named("Snapshots");
    case Parameter::maxHoleSize: return named("MaxHoleSize");
    case Parameter::timeLimit: return named("TimeLimit");
    }
    return {};
}

std::string fieldOfRange(char variable, bool isUpper)
{
    return named(std::string(isUpper ? "max" : "min") + static_cast<char>(std::toupper(variable)));
}

} // namespace

const neuralmesh::HostTerms &filterTerms()
{
    static const neuralmesh::HostTerms terms{
        filterParameter,
        named("DensityFromQuality"),
        named("PointFile"),
        "starting layer",
        fieldOfRange,
        chosen("Topology", 1, "Learned from the data"),
        chosen("Boundaries", 1, "Open"),
        "; numbers of more than about 10^38 are none for the host",
        ", by more than the seven digits that the host keeps",
        ": open it in MeshLab and export it with binary encoding.",
        ": open it in MeshLab and export it as PLY with binary encoding."};
    return terms;
}

std::string sentenceFor(const neuralmesh::InvalidInput &error)
{
    return neuralmesh::sentenceFor(error, filterTerms());
}
