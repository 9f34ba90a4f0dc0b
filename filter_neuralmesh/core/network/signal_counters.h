// SPDX-License-Identifier: GPL-3.0-or-later
// Signal counters τ of the vertices (steps 4 and 5): decay of all and the highest of all, fast.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/one_ring.h"

namespace neuralmesh {

/// Decay is lazy: instead of multiplying n counters by α at every signal (equation 7, O(n)), the
/// value of one signal grows by 1/α, and all is scaled back long before it overflows. The highest
/// counter stands at the top of an indexed binary heap; of equal counters the lowest id is higher.
class SignalCounters {
public:
    void insert(VertexId id, double value);
    void erase(VertexId id);
    bool contains(VertexId id) const { return id < places_.size() && places_[id] != nowhere; }
    std::size_t size() const { return heap_.size(); }

    double value(VertexId id) const { return stored_[id] / unit_; }
    void set(VertexId id, double value);
    /// Equation 6, for a signal that counts `amount`.
    void add(VertexId id, double amount = 1);
    /// Equation 7: every counter is multiplied by alpha, in (0, 1].
    void decay(double alpha);

    /// The vertex with the highest counter. Requires size() > 0.
    VertexId highest() const { return heap_.front(); }

private:
    using Place = std::uint32_t;
    static constexpr Place nowhere = 0xffffffffU;

    bool isHigher(VertexId a, VertexId b) const
    {
        return stored_[a] > stored_[b] || (stored_[a] == stored_[b] && a < b);
    }
    void put(Place place, VertexId id);
    void siftUp(Place place);
    void siftDown(Place place);
    void rescale();

    std::vector<double> stored_; ///< counter times unit_, by id
    std::vector<Place> places_;  ///< place in the heap, by id
    std::vector<VertexId> heap_;
    double unit_ = 1; ///< stored value of one signal
};

} // namespace neuralmesh
