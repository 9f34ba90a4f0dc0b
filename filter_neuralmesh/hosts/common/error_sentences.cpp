// SPDX-License-Identifier: GPL-3.0-or-later
#include "hosts/common/error_sentences.h"

#include <cctype>

#include "neuralmesh/sampler_errors.h"
#include "neuralmesh/too_little_memory.h"

namespace neuralmesh {
namespace {

/// Densities come from vertex quality.
std::string aboutDensity(const InvalidDensity &error, const HostTerms &terms)
{
    const std::string of = terms.densityFromQuality + ": the quality of ";
    switch (error.problem()) {
    case InvalidDensity::Problem::notValid:
        return of + std::to_string(error.broken()) + " of " + std::to_string(error.count()) +
               " vertices is negative, NaN or infinite (the first is vertex " +
               std::to_string(error.first()) + ").";
    case InvalidDensity::Problem::allZero:
        return of + "all vertices is 0, so none would be sampled.";
    case InvalidDensity::Problem::noFace: return "No face has both an area and a quality above 0.";
    case InvalidDensity::Problem::wrongCount: break; // hosts hand over one for each vertex
    }
    return error.what();
}

std::string aboutRange(const EmptyRange &error, const HostTerms &terms)
{
    const bool isCoordinate = error.variable() >= 'x';
    const std::string name(1, static_cast<char>(std::toupper(error.variable())));
    const std::string low = terms.rangeEnd(error.variable(), false);
    const std::string high = terms.rangeEnd(error.variable(), true);
    if (error.isInfinite())
        return low + " and " + high + " must be finite, and so must their difference" +
               terms.aboutLargest + ".";
    return (isCoordinate ? "The box is empty: " : "The range of " + name + " is empty: ") + low +
           " must be below " + high + terms.aboutDigits + ".";
}

/// With the way to convert the file that the host's users have at hand.
std::string aboutConversion(const NeedsConversion &error, const HostTerms &terms)
{
    std::string sentence = error.what();
    sentence.pop_back();
    return sentence + (error.format() == NeedsConversion::Format::textPly ? terms.convertTextPly
                                                                          : terms.convertE57);
}

std::string aboutFile(const InvalidPointFile &error, const HostTerms &terms)
{
    std::string reason = error.reason();
    try {
        std::rethrow_if_nested(error);
    } catch (const InvalidInput &nested) {
        reason = sentenceFor(nested, terms);
    }
    return terms.pointFile + " '" + error.path() + "': " + reason;
}

} // namespace

std::string sentenceFor(const InvalidInput &error, const HostTerms &terms)
{
    if (const auto *parameter = dynamic_cast<const InvalidParameter *>(&error))
        return parameter->sentence(terms.parameter);
    if (const auto *start = dynamic_cast<const InvalidStartingMesh *>(&error))
        return start->sentence("The " + terms.startingMesh);
    if (const auto *memory = dynamic_cast<const TooLittleMemory *>(&error))
        return memory->sentence(terms.parameter);
    if (const auto *flat = dynamic_cast<const FlatTarget *>(&error);
        flat != nullptr && !flat->wasSought())
        return allPointsBut(flat->ignored()) +
               " lie on a plane: a closed surface cannot be fitted to them. Use " +
               terms.learnedTopology + ", which makes a sheet of them.";
    if (const auto *density = dynamic_cast<const InvalidDensity *>(&error))
        return aboutDensity(*density, terms);
    if (const auto *range = dynamic_cast<const EmptyRange *>(&error))
        return aboutRange(*range, terms);
    if (const auto *conversion = dynamic_cast<const NeedsConversion *>(&error))
        return aboutConversion(*conversion, terms);
    if (const auto *file = dynamic_cast<const InvalidPointFile *>(&error))
        return aboutFile(*file, terms);
    return error.what();
}

} // namespace neuralmesh
