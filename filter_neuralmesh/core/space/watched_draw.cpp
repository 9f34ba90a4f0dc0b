// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/watched_draw.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Samples of a part: of an expression, a tenth of a second.
constexpr std::size_t samplesOfPart = 1 << 16;

} // namespace

void drawWatched(const Sampler &sampler, Random &random, std::size_t count,
                 std::vector<Point> &samples, const Watch &watch)
{
    sampler.draw(random, std::min(count, samplesOfPart), samples);
    std::vector<Point> part;
    while (samples.size() < count) {
        watch.look();
        sampler.draw(random, std::min(count - samples.size(), samplesOfPart), part);
        samples.insert(samples.end(), part.begin(), part.end());
    }
}

} // namespace neuralmesh
