// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmesh/errors.h"

#include <cmath>
#include <cstdio>

namespace neuralmesh {
namespace {

/// A count as it is, another number with six digits.
std::string figure(double number)
{
    char text[32];
    const bool isCount = std::floor(number) == number && std::abs(number) < 1e15;
    std::snprintf(text, sizeof text, isCount ? "%.0f" : "%g", number);
    return text;
}

std::string countOf(std::uint64_t count, const char *one, const char *many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string sentenceAbout(Parameter parameter, InvalidParameter::Problem problem, double value,
                          double limit, const ParameterNames &names)
{
    using Problem = InvalidParameter::Problem;
    const std::string name = names(parameter);
    if (problem == Problem::noRate) // the value may be NaN
        return name + " must lie between 0 and 1, both excluded.";
    const std::string bound = figure(limit);
    const std::string counted = parameter == Parameter::snapshots
                                    ? name + " names " + figure(value) + " vertices"
                                    : name + " is " + figure(value);
    switch (problem) {
    case Problem::aboveMost:
        return name + " must be at most " + bound + ", not " + figure(value) + ".";
    case Problem::repeated: return counted + " twice.";
    case Problem::notAscending: return counted + " after more of them.";
    case Problem::aboveTarget:
        return counted + ", more than " + names(Parameter::targetVertexCount) + ", which is " +
               bound + ".";
    case Problem::belowStart:
        return counted + ", fewer than the " + bound + " vertices of the starting mesh.";
    case Problem::aboveDistinctPoints:
        return counted + ", but there are only " + bound +
               " distinct points to draw from: at most " + bound + " vertices are possible.";
    default: return name + " must be at least " + bound + ", not " + figure(value) + ".";
    }
}

/// What is wrong with a starting mesh: the rest of a sentence that starts with its name.
std::string predicateOf(InvalidStartingMesh::Problem problem, std::uint64_t count)
{
    using Problem = InvalidStartingMesh::Problem;
    const std::string notManifold = " is not two-manifold: ";
    switch (problem) {
    case Problem::missing: return " is missing.";
    case Problem::notFinite: return " has coordinates that are NaN, infinite or too large.";
    case Problem::noFaces: return " has no faces.";
    case Problem::unknownVertex:
        return " lacks vertices: " + countOf(count, "face names one", "faces name one") +
               " that is not there.";
    case Problem::repeatedCorner:
        return notManifold + countOf(count, "face names", "faces name") + " a vertex twice.";
    case Problem::crowdedEdge:
        return notManifold + countOf(count, "edge belongs", "edges belong") +
               " to more than two faces.";
    case Problem::openEdge:
        return " is not closed: " + countOf(count, "edge belongs", "edges belong") +
               " to one face only. Close its holes, or merge its close vertices.";
    case Problem::severalFans: return notManifold + "several fans of faces meet at one vertex.";
    case Problem::doubledFace: return notManifold + "two faces have the same three vertices.";
    case Problem::notOrientable: return " is not orientable: its faces have no common outside.";
    }
    return {};
}

} // namespace

std::string nameOf(Parameter parameter)
{
    switch (parameter) {
    case Parameter::targetVertexCount: return "targetVertexCount";
    case Parameter::winnerRate: return "winnerRate";
    case Parameter::smoothingRate: return "smoothingRate";
    case Parameter::smoothingPasses: return "smoothingPasses";
    case Parameter::signalsPerSplit: return "signalsPerSplit";
    case Parameter::inactivityFactor: return "inactivityFactor";
    case Parameter::threads: return "threads";
    case Parameter::counterDecay: return "counterDecay";
    case Parameter::snapshots: return "snapshots";
    case Parameter::maxHoleSize: return "maxHoleSize";
    case Parameter::timeLimit: return "timeLimit";
    }
    return {};
}

std::string allPointsBut(std::uint64_t ignored)
{
    return "All points" +
           (ignored == 0 ? "" : " but " + countOf(ignored, "isolated one", "isolated ones"));
}

FlatTarget::FlatTarget(bool wasSought, std::uint64_t ignored)
    : InvalidInput(allPointsBut(ignored) +
                   (wasSought ? " lie on a plane, and are too few or too uneven for a sheet to be "
                                "found in them."
                              : " lie on a plane: a closed surface cannot be fitted to them. Learn "
                                "the topology from the data.")),
      wasSought_(wasSought), ignored_(ignored)
{
}

InvalidParameter::InvalidParameter(Parameter parameter, Problem problem, double value, double limit)
    : InvalidInput(sentenceAbout(parameter, problem, value, limit, nameOf)), parameter_(parameter),
      problem_(problem), value_(value), limit_(limit)
{
}

std::string InvalidParameter::sentence(const ParameterNames &names) const
{
    return sentenceAbout(parameter_, problem_, value_, limit_, names);
}

InvalidStartingMesh::InvalidStartingMesh(Problem problem, std::uint64_t count)
    : InvalidInput("The starting mesh" + predicateOf(problem, count)), problem_(problem),
      count_(count)
{
}

std::string InvalidStartingMesh::sentence(const std::string &subject) const
{
    return subject + predicateOf(problem_, count_);
}

} // namespace neuralmesh
