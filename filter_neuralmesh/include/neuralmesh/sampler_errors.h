// SPDX-License-Identifier: GPL-3.0-or-later
// What samplers refuse, where a host may want to say it in words of its own. Other refusals are
// plain InvalidInput: their sentences are about points, faces and expressions only.
#pragma once

#include <cstdint>
#include <string>

#include "neuralmesh/errors.h"

namespace neuralmesh {

/// The densities of points cannot be used.
class InvalidDensity : public InvalidInput {
public:
    enum class Problem {
        wrongCount, ///< `count` densities, which is not one for each point
        notValid,   ///< `broken` of `count` are negative, NaN or infinite; `first` is the first
        allZero,
        noFace ///< with an area and a density above 0
    };

    explicit InvalidDensity(Problem problem, std::uint64_t count = 0, std::uint64_t broken = 0,
                            std::uint64_t first = 0);

    Problem problem() const { return problem_; }
    std::uint64_t count() const { return count_; }
    std::uint64_t broken() const { return broken_; }
    std::uint64_t first() const { return first_; }

private:
    Problem problem_;
    std::uint64_t count_, broken_, first_;
};

/// A range of a coordinate ('x', 'y', 'z') or a parameter ('u', 'v') ends before it starts, or an
/// end of it, or its length, is not finite.
class EmptyRange : public InvalidInput {
public:
    explicit EmptyRange(char variable, bool isInfinite = false);
    char variable() const { return variable_; }
    bool isInfinite() const { return isInfinite_; }

private:
    char variable_;
    bool isInfinite_;
};

/// A file is of a format that is not read in place, and has to be converted to binary PLY.
class NeedsConversion : public InvalidInput {
public:
    enum class Format { textPly, e57 };

    explicit NeedsConversion(Format format);
    Format format() const { return format_; }

private:
    Format format_;
};

/// A point file cannot be used. The error that says why is nested, unless the file was changed
/// while it was being read: std::rethrow_if_nested() throws it.
class InvalidPointFile : public InvalidInput {
public:
    InvalidPointFile(const std::string &path, const std::string &reason);
    const std::string &path() const { return path_; }
    const std::string &reason() const { return reason_; }

private:
    std::string path_;
    std::string reason_;
};

} // namespace neuralmesh
