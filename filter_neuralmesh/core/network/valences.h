// SPDX-License-Identifier: GPL-3.0-or-later
// What the valences are to be, and how far one is from that.
#pragma once

namespace neuralmesh {

inline constexpr int idealValence = 6;

constexpr int squared(int x)
{
    return x * x;
}

constexpr int valenceSpread(int valence)
{
    return squared(valence - idealValence);
}

} // namespace neuralmesh
