// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace neuralmesh {

/// Seeded pseudo-random numbers: xoshiro256++ (Blackman and Vigna, 2019), seeded by splitmix64.
///
/// The generator and its mappings are our own because the distributions of the standard library
/// differ between implementations, and the same seed has to give the same mesh everywhere.
class Random {
public:
    explicit Random(std::uint64_t seed)
    {
        for (std::uint64_t &word : state_) {
            seed += 0x9e3779b97f4a7c15ULL;
            word = mix(seed);
        }
    }

    /// 64 uniform bits.
    std::uint64_t bits()
    {
        const std::uint64_t result = rotateLeft(state_[0] + state_[3], 23) + state_[0];
        const std::uint64_t shifted = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= shifted;
        state_[3] = rotateLeft(state_[3], 45);
        return result;
    }

    /// Uniform in [0, count) by multiplication and shift (Lemire 2019). The bias of leaving out
    /// the rejection step is below count / 2^32. count must lie in [1, 2^32].
    std::uint64_t below(std::uint64_t count) { return ((bits() >> 32) * count) >> 32; }

    /// Uniform in [0, 1) with 53 bits.
    double unit() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

private:
    static std::uint64_t rotateLeft(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

    static std::uint64_t mix(std::uint64_t x)
    {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
        return x ^ (x >> 31);
    }

    std::uint64_t state_[4];
};

} // namespace neuralmesh
