// SPDX-License-Identifier: GPL-3.0-or-later
// The one interface of all target spaces (P in the paper, a probability distribution in space).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "neuralmesh/geometry.h"
#include "neuralmesh/random.h"
#include "neuralmesh/unit_frame.h"

namespace neuralmesh {

/// Points of a target space that were taken for outliers and are not drawn.
struct Outliers {
    std::uint64_t count = 0;
    double share = 0;        ///< of all points
    bool isEstimate = false; ///< where not every point was looked at
};

/// Those from `first` to before `end` of so many parts of a target space that are equally probable.
struct Strata {
    std::size_t count = 0;
    std::size_t first = 0;
    std::size_t end = 0;
};

class Sampler {
public:
    Sampler() = default;
    virtual ~Sampler() = default;

    /// The frame in which samples are given.
    virtual const UnitFrame &frame() const = 0;

    /// Bounds of the target space, in the unit frame.
    virtual Box bounds() const = 0;

    /// Step 1 of the paper: `count` independent samples of P, in the unit frame, into `samples`,
    /// whatever these held before. All randomness comes from `random`. Called for thousands of
    /// samples at once.
    virtual void draw(Random &random, std::size_t count, std::vector<Point> &samples) const = 0;

    /// One sample of each stratum into `samples` (stratified sampling): each is distributed as
    /// those of draw() where a stratum is drawn at random, and all together lie on P more evenly. A
    /// space that has no strata draws independent ones. Of points of uneven density, those far from
    /// others are drawn more often, so that the crowded ones do not have all samples.
    virtual void drawStratified(Random &random, const Strata &strata,
                                std::vector<Point> &samples) const
    {
        draw(random, strata.end - strata.first, samples);
    }

    /// How many points the space has, repeated ones included, perhaps with outliers; by default
    /// more than any network asks for, as a surface has.
    virtual std::size_t pointCount() const { return std::numeric_limits<std::size_t>::max(); }

    /// How many distinct points the space has; may stop counting at `enough`. A vertex that wins
    /// needs a point of its own, so no network can hold more vertices.
    virtual std::size_t countDistinctPoints(std::size_t enough) const { return enough; }

    /// Whether all of it lies in one plane, where no surface but an open one can be.
    virtual bool isFlat() const { return false; }

    virtual Outliers outliers() const { return {}; }
};

} // namespace neuralmesh
