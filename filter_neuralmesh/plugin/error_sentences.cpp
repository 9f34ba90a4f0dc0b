// SPDX-License-Identifier: GPL-3.0-or-later
#include "error_sentences.h"

#include <cctype>

#include "neuralmesh/sampler_errors.h"
#include "parameter_names.h"

namespace {

using namespace neuralmesh;

std::string filterParameter(Parameter parameter)
{
    switch (parameter) {
    case Parameter::targetVertexCount: return named("TargetVertNum");
    case Parameter::winnerRate: return named("WinnerRate");
    case Parameter::smoothingRate: return named("SmoothingRate");
    case Parameter::smoothingPasses: return named("SmoothingPasses");
    case Parameter::signalsPerSplit: return named("SignalsPerSplit");
    case Parameter::inactivityFactor: return named("InactivityFactor");
    case Parameter::counterDecay: return named("CounterDecay");
    case Parameter::snapshots: return named("Snapshots");
    case Parameter::maxHoleSize: return named("MaxHoleSize");
    }
    return {};
}

/// Densities come from vertex quality.
std::string aboutDensity(const InvalidDensity &error)
{
    const std::string of = named("DensityFromQuality") + ": the quality of ";
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
    return (isCoordinate ? "The box is empty: " : "The range of " + name + " is empty: ") +
           named("min" + name) + " must be below " + named("max" + name) + ".";
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
    return named("PointFile") + " '" + error.path() + "': " + reason;
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
        return "All points lie on a plane: a closed surface cannot be fitted to them. Use " +
               chosen("Topology", 1, "Learned from the data") + ", which makes a sheet of them.";
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
