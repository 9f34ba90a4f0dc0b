// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers by purpose: what one part of a run draws changes nothing for another.
#pragma once

#include <cstdint>

#include "neuralmesh/random.h"

namespace neuralmesh {

enum class Purpose : std::uint64_t {
    /// The samples of growth, and of all that its result follows from: the census and the fit.
    growth,
    measuring,
    /// The growth of the snapshot of that chunk's number.
    snapshot,
    /// The samples of a start from the data.
    shape
};

/// The stream of a seed for a purpose. Streams of other seeds, purposes and chunks have nothing in
/// common with it; that of growth is Random(seed).
inline Random randomStream(std::uint64_t seed, Purpose purpose, std::uint64_t chunk = 0)
{
    if (purpose == Purpose::growth && chunk == 0)
        return Random(seed);
    // Each part of the key is mixed in by a generator of its own.
    const std::uint64_t ofSeed = Random(seed).bits();
    const std::uint64_t ofPurpose = Random(ofSeed + static_cast<std::uint64_t>(purpose)).bits();
    return Random(Random(ofPurpose + chunk).bits());
}

} // namespace neuralmesh
