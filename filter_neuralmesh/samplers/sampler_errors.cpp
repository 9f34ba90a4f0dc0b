// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/sampler_errors.h"

namespace neuralmesh {
namespace {

std::string sentenceAbout(InvalidDensity::Problem problem, std::uint64_t count,
                          std::uint64_t broken, std::uint64_t first)
{
    using Problem = InvalidDensity::Problem;
    switch (problem) {
    case Problem::wrongCount:
        return "There are " + std::to_string(count) +
               " densities, which is not one for each point.";
    case Problem::notValid:
        return "The density of " + std::to_string(broken) + " of " + std::to_string(count) +
               " points is negative, NaN or infinite (the first is point " + std::to_string(first) +
               ").";
    case Problem::allZero: return "The density of all points is 0, so none would be sampled.";
    case Problem::noFace: return "No face has both an area and a density above 0.";
    }
    return {};
}

std::string sentenceAbout(NeedsConversion::Format format)
{
    return format == NeedsConversion::Format::textPly
               ? "it is a PLY file of text, of which no point can be read in place. Save it as "
                 "binary PLY."
               : "it is an E57 file, whose points are packed in pages, so that none can be read in "
                 "place. Convert it first.";
}

} // namespace

InvalidDensity::InvalidDensity(Problem problem, std::uint64_t count, std::uint64_t broken,
                               std::uint64_t first)
    : InvalidInput(sentenceAbout(problem, count, broken, first)), problem_(problem), count_(count),
      broken_(broken), first_(first)
{
}

EmptyRange::EmptyRange(char variable, bool isInfinite)
    : InvalidInput(std::string("The range of ") + variable +
                   (isInfinite ? " has an end or a length that is not finite."
                               : " is empty: its lower end must be below its upper end.")),
      variable_(variable), isInfinite_(isInfinite)
{
}

NeedsConversion::NeedsConversion(Format format)
    : InvalidInput(sentenceAbout(format)), format_(format)
{
}

InvalidPointFile::InvalidPointFile(const std::string &path, const std::string &reason)
    : InvalidInput("'" + path + "': " + reason), path_(path), reason_(reason)
{
}

} // namespace neuralmesh
