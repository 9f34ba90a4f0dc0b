// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_sentences.h"

#include <cctype>

#include "neuralmesh/sampler_errors.h"

namespace {

using namespace neuralmesh;

std::string filterParameter(Parameter parameter)
{
    switch (parameter) {
    case Parameter::targetVertexCount: return "TargetVertNum";
    case Parameter::winnerRate: return "WinnerRate";
    case Parameter::smoothingRate: return "SmoothingRate";
    case Parameter::smoothingPasses: return "SmoothingPasses";
    case Parameter::signalsPerSplit: return "SignalsPerSplit";
    case Parameter::inactivityFactor: return "InactivityFactor";
    case Parameter::counterDecay: return "CounterDecay";
    case Parameter::snapshots: return "Snapshots";
    case Parameter::maxHoleSize: return "MaxHoleSize";
    }
    return {};
}

/// Densities come from vertex quality.
std::string aboutDensity(const InvalidDensity &error)
{
    const std::string of = "DensityFromQuality: the quality of ";
    switch (error.problem()) {
    case InvalidDensity::Problem::notValid:
        return of + std::to_string(error.broken()) + " of " + std::to_string(error.count()) +
               " vertices is negative, NaN or infinite (the first is vertex " +
               std::to_string(error.first()) + ").";
    case InvalidDensity::Problem::allZero:
        return of + "all vertices is 0, so none would be sampled.";
    case InvalidDensity::Problem::noFace: return "No face has both an area and a quality above 0.";
    case InvalidDensity::Problem::wrongCount: break; // a layer has a quality for each vertex
    }
    return error.what();
}

std::string aboutRange(const EmptyRange &error)
{
    const std::string name(1, static_cast<char>(std::toupper(error.variable())));
    const bool isCoordinate = error.variable() >= 'x';
    if (error.isInfinite())
        return "min" + name + " and max" + name +
               " must be finite, and so must their difference; numbers of more than about 10^38 "
               "are "
               "none for the host.";
    return (isCoordinate ? "The box is empty: min" : "The range of " + name + " is empty: min") +
           name + " must be below max" + name +
           ", by more than the seven digits that the host keeps.";
}

/// With the way to convert the file that users of MeshLab have at hand.
std::string aboutConversion(const NeedsConversion &error)
{
    std::string sentence = error.what();
    sentence.pop_back();
    return sentence + (error.format() == NeedsConversion::Format::textPly
                           ? ": open it in MeshLab and export it with binary encoding."
                           : ": open it in MeshLab and export it as PLY with binary encoding.");
}

std::string aboutFile(const InvalidPointFile &error)
{
    std::string reason = error.reason();
    try {
        std::rethrow_if_nested(error);
    } catch (const InvalidInput &nested) {
        reason = sentenceFor(nested);
    }
    return "PointFile '" + error.path() + "': " + reason;
}

} // namespace

std::string sentenceFor(const InvalidInput &error)
{
    if (const auto *parameter = dynamic_cast<const InvalidParameter *>(&error))
        return parameter->sentence(filterParameter);
    if (const auto *start = dynamic_cast<const InvalidStartingMesh *>(&error))
        return start->sentence("The starting layer");
    if (const auto *flat = dynamic_cast<const FlatTarget *>(&error);
        flat != nullptr && !flat->wasSought())
        return "All points lie on a plane: a closed surface cannot be fitted to them. Set Topology "
               "to 'Learned from the data', which makes a sheet of them.";
    if (const auto *density = dynamic_cast<const InvalidDensity *>(&error))
        return aboutDensity(*density);
    if (const auto *range = dynamic_cast<const EmptyRange *>(&error))
        return aboutRange(*range);
    if (const auto *conversion = dynamic_cast<const NeedsConversion *>(&error))
        return aboutConversion(*conversion);
    if (const auto *file = dynamic_cast<const InvalidPointFile *>(&error))
        return aboutFile(*file);
    return error.what();
}
