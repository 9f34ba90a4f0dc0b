// SPDX-License-Identifier: GPL-3.0-or-later
// What goes wrong, by type, with figures. what() is a sentence in plain text, in the terms of these
// headers; a host whose users know other names words errors anew from what they hold.
#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace neuralmesh {

/// The input or a parameter cannot be used. The base of all errors but Cancelled.
class InvalidInput : public std::runtime_error {
public:
    explicit InvalidInput(const std::string &sentence) : std::runtime_error(sentence) {}
};

/// The beginning of a sentence about all points that are drawn: "All points but 3 isolated ones".
std::string allPointsBut(std::uint64_t ignored);

/// The target space lies in a plane, and a closed surface cannot be fitted to it: either none but a
/// closed one was asked for, or no open one was found.
class FlatTarget : public InvalidInput {
public:
    /// Whether a shape was sought in vain, and how many isolated points were ignored.
    explicit FlatTarget(bool wasSought, std::uint64_t ignored = 0);
    bool wasSought() const { return wasSought_; }
    std::uint64_t ignored() const { return ignored_; }

private:
    bool wasSought_;
    std::uint64_t ignored_;
};

/// The progress callback asked to stop.
class Cancelled : public std::runtime_error {
public:
    Cancelled() : std::runtime_error("Cancelled.") {}
};

/// What can be refused: members of GrowthParameters, but for the last.
enum class Parameter {
    targetVertexCount,
    winnerRate,
    smoothingRate,
    smoothingPasses,
    signalsPerSplit,
    inactivityFactor,
    threads,
    counterDecay,
    snapshots,
    maxHoleSize,
    timeLimit ///< no member, but that of Deadline::in()
};

/// The member's name, such as "targetVertexCount".
std::string nameOf(Parameter parameter);

/// How a host calls a parameter.
using ParameterNames = std::function<std::string(Parameter)>;

/// A parameter is out of its range, or does not fit the input.
class InvalidParameter : public InvalidInput {
public:
    enum class Problem {
        belowLeast,         ///< less than `limit`
        aboveMost,          ///< more than `limit`
        noRate,             ///< not between 0 and 1
        repeated,           ///< a snapshot of this count is there already
        notAscending,       ///< a snapshot of this count comes after a larger one
        aboveTarget,        ///< a snapshot with more vertices than the target, `limit`
        belowStart,         ///< fewer vertices than the starting mesh, `limit`
        aboveDistinctPoints ///< more vertices than there are distinct points, `limit`
    };

    /// `value` and `limit` are counts but for parameters that are none, whose value may be NaN.
    InvalidParameter(Parameter parameter, Problem problem, double value, double limit);

    Parameter parameter() const { return parameter_; }
    Problem problem() const { return problem_; }
    double value() const { return value_; }
    double limit() const { return limit_; }

    /// The sentence of what(), with the host's names of parameters.
    std::string sentence(const ParameterNames &names) const;

private:
    Parameter parameter_;
    Problem problem_;
    double value_;
    double limit_;
};

/// The mesh to start from is no closed two-manifold.
class InvalidStartingMesh : public InvalidInput {
public:
    enum class Problem {
        missing,   ///< none was given
        notFinite, ///< coordinates are NaN, infinite or too large
        noFaces,
        unknownVertex,  ///< `count` faces name a vertex that is not there
        repeatedCorner, ///< `count` faces name a vertex twice
        crowdedEdge,    ///< `count` edges belong to more than two faces
        openEdge,       ///< `count` edges belong to one face
        severalFans,    ///< of faces meet at a vertex
        doubledFace,    ///< two faces have the same corners
        notOrientable   ///< a Klein bottle, say
    };

    explicit InvalidStartingMesh(Problem problem, std::uint64_t count = 0);

    Problem problem() const { return problem_; }
    std::uint64_t count() const { return count_; }

    /// The sentence of what(), about a `subject` other than "The starting mesh".
    std::string sentence(const std::string &subject) const;

private:
    Problem problem_;
    std::uint64_t count_;
};

} // namespace neuralmesh
