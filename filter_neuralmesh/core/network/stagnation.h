// SPDX-License-Identifier: GPL-3.0-or-later
// When growth gets nowhere: splits and collapses balance each other, or nearly.
#pragma once

#include <cstdint>

#include "core/network/growing_network.h"

namespace neuralmesh {

/// Growth has come to a stop where it gains less than this share of its vertices...
inline constexpr double leastGain = 0.05;
/// ...in this many times μ·n signals, in which it would double without collapses (at the paper's
/// constants, n·μ·5/λ = n splits).
inline constexpr int stagnationPeriods = 5;
/// Or once it has taken so many times λ signals for each vertex of the target. From a solid, shapes
/// of all kinds take 1.0 to 1.6; sheets that fold 3 to 6, and crumple the more the longer it lasts.
inline constexpr int mostSignals = 2;

/// Watches a network from when it is made.
class Stagnation {
public:
    /// `lambda` is that of the parameters: a young network splits sooner.
    Stagnation(const GrowingNetwork &network, int lambda, int target)
        : network_(network), lambda_(static_cast<std::uint64_t>(lambda)),
          most_(mostSignals * lambda_ * static_cast<std::uint64_t>(target)),
          count_(network.vertexCount()), signals_(network.signals())
    {
    }

    /// Whether the network has gained too little since it last gained enough, or taken too much.
    bool isReached()
    {
        if (network_.signals() > most_)
            return true;
        const int count = network_.vertexCount();
        if (count >= count_ * (1 + leastGain)) {
            count_ = count;
            signals_ = network_.signals();
        }
        const auto nominal = static_cast<std::uint64_t>(count_ * leastGain + 1) * lambda_;
        return network_.signals() - signals_ >
               stagnationPeriods * network_.inactivityWindow() + 2 * nominal;
    }

private:
    const GrowingNetwork &network_;
    std::uint64_t lambda_;
    std::uint64_t most_;    ///< signals
    double count_;          ///< when it last gained enough
    std::uint64_t signals_; ///< by then
};

} // namespace neuralmesh
