// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_terms.h"

namespace neuralmesh::python {
namespace {

const char *keyOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::targetVertexCount: return "vertices";
    case Parameter::winnerRate: return "winner_rate";
    case Parameter::smoothingRate: return "smoothing_rate";
    case Parameter::smoothingPasses: return "smoothing_passes";
    case Parameter::signalsPerSplit: return "signals_per_split";
    case Parameter::inactivityFactor: return "inactivity_factor";
    case Parameter::threads: return "threads";
    case Parameter::counterDecay: return "counter_decay";
    case Parameter::snapshots: return "snapshots";
    case Parameter::maxHoleSize: return "max_hole_size";
    case Parameter::timeLimit: return "time_limit";
    }
    return "";
}

std::string typed(const TypedNames &names, const std::string &key)
{
    const auto found = names.find(key);
    return found == names.end() ? key : found->second;
}

/// Corners of a box are (x, y, z), ranges are pairs.
std::string rangeEnd(char variable, bool isUpper)
{
    if (variable < 'x')
        return std::string(1, variable) + (isUpper ? "[1]" : "[0]");
    return std::string(isUpper ? "upper" : "lower") + "[" + std::to_string(variable - 'x') + "]";
}

} // namespace

HostTerms hostTerms(const TypedNames &names)
{
    const auto value = [&](const char *key, const char *number) {
        const std::string name = typed(names, key);
        return name + (name.rfind("--", 0) == 0 ? " " : "=") + number;
    };
    return {[names](Parameter parameter) { return typed(names, keyOf(parameter)); },
            typed(names, "density_from_quality"),
            "File",
            "starting mesh",
            rangeEnd,
            value("topology", "1"),
            value("boundaries", "1"),
            "",
            "",
            ".",
            ": save it as binary PLY."};
}

} // namespace neuralmesh::python
