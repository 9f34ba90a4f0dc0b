// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/space/alias_table.h"

#include <algorithm>
#include <cassert>

namespace neuralmesh {

AliasTable::AliasTable(const std::vector<double> &weights) : columns_(weights.size())
{
    // By the largest first, so that the sum of large weights does not overflow.
    const double largest = *std::max_element(weights.begin(), weights.end());
    assert(largest > 0);
    double sum = 0;
    for (const double weight : weights)
        sum += weight / largest;

    std::vector<std::uint32_t> small;
    std::vector<std::uint32_t> large;
    const double perMean = static_cast<double>(weights.size()) / sum;
    for (std::uint32_t i = 0; i < weights.size(); ++i) {
        columns_[i] = {weights[i] / largest * perMean, i};
        (columns_[i].share < 1 ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const std::uint32_t filled = small.back();
        const std::uint32_t giver = large.back();
        small.pop_back();
        columns_[filled].alias = giver;
        columns_[giver].share -= 1 - columns_[filled].share;
        if (columns_[giver].share < 1) {
            large.pop_back();
            small.push_back(giver);
        }
    }
    // What is left over is full but for rounding, unless it has no weight at all.
    const auto heaviest = static_cast<std::uint32_t>(
        std::max_element(weights.begin(), weights.end()) - weights.begin());
    for (const std::uint32_t i : small)
        columns_[i] = weights[i] > 0 ? Column{1, i} : Column{0, heaviest};
    for (const std::uint32_t i : large)
        columns_[i].share = 1;
}

} // namespace neuralmesh
