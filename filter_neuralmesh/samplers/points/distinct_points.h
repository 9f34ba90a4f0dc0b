// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <unordered_set>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A set of places.
class DistinctPoints {
public:
    explicit DistinctPoints(std::size_t expected = 0) { seen_.reserve(expected); }
    /// Whether the place is new.
    bool insert(const Point3 &point) { return seen_.insert(point).second; }
    bool contains(const Point3 &point) const { return seen_.count(point) > 0; }
    std::size_t size() const { return seen_.size(); }

private:
    struct Hash {
        std::size_t operator()(const Point3 &p) const
        {
            std::uint64_t hash = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double coordinate = p[axis] + 0.0; // -0 and 0 are one place
                std::uint64_t bits = 0;
                std::memcpy(&bits, &coordinate, sizeof bits);
                hash = (hash ^ bits) * 0x9e3779b97f4a7c15ULL;
                hash ^= hash >> 32;
            }
            return static_cast<std::size_t>(hash);
        }
    };

    std::unordered_set<Point3, Hash> seen_;
};

} // namespace neuralmesh
