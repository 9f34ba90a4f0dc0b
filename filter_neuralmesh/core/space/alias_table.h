// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "neuralmesh/random.h"

namespace neuralmesh {

/// Draws indices in proportion to weights, in constant time: the alias method (Walker 1977, with
/// the set-up of Vose 1991).
class AliasTable {
public:
    AliasTable() = default;

    /// Weights are finite and not negative; at least one, at most 2^32, is positive.
    explicit AliasTable(const std::vector<double> &weights);

    std::size_t size() const { return columns_.size(); }

    std::size_t draw(Random &random) const
    {
        const auto index = static_cast<std::size_t>(random.below(columns_.size()));
        const Column &column = columns_[index];
        return random.unit() < column.share ? index : column.alias;
    }

private:
    /// Each index has a column of the same height; what it leaves empty is another's.
    struct Column {
        double share = 1; ///< of the index itself
        std::uint32_t alias = 0;
    };

    std::vector<Column> columns_;
};

} // namespace neuralmesh
