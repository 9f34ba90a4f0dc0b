// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/ordered_samples.h"

#include <algorithm>

namespace neuralmesh {
namespace {

/// Samples of a part: of an expression, a tenth of a second.
constexpr std::size_t samplesOfPart = 1 << 16;

} // namespace

OrderedSamples::OrderedSamples(const Sampler &sampler, Watch &watch)
    : sampler_(sampler), watch_(watch), order_(sampler.bounds())
{
}

const std::vector<Point3> &OrderedSamples::draw(Random &random, std::size_t count)
{
    drawParts(count, [&](std::size_t first, std::size_t end, std::vector<Point> &samples) {
        sampler_.draw(random, end - first, samples);
    });
    return ordered_;
}

const std::vector<Point3> &OrderedSamples::drawStratified(Random &random, std::size_t strata)
{
    drawParts(strata, [&](std::size_t first, std::size_t end, std::vector<Point> &samples) {
        sampler_.drawStratified(random, {strata, first, end}, samples);
    });
    return ordered_;
}

/// By calls of draw(first, end, samples).
template <class Draw> void OrderedSamples::drawParts(std::size_t count, const Draw &draw)
{
    draw(0, std::min(count, samplesOfPart), drawn_);
    while (drawn_.size() < count) {
        watch_.look();
        draw(drawn_.size(), std::min(count, drawn_.size() + samplesOfPart), part_);
        drawn_.insert(drawn_.end(), part_.begin(), part_.end());
    }
    order_.sort(drawn_, ordered_);
}

} // namespace neuralmesh
