// SPDX-License-Identifier: GPL-3.0-or-later
// The ordered neighbour ring of a vertex, and the VCG vertex component that holds it.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "neuralmesh/geometry.h"

namespace neuralmesh {

/// Ids index NeuralMesh::vert. They stay valid while the mesh grows; pointers do not.
inline constexpr VertexId noVertex = 0xffffffffU;

/// The neighbours of a vertex in counter-clockwise order seen from outside. Consecutive neighbours
/// a, b of v stand for the face (v, a, b). The ring of a vertex inside the surface is closed: the
/// last neighbour is followed by the first. That of a vertex on a boundary is open: between the
/// last and the first there is no face. Then the first is the next vertex along the boundary with
/// the surface to the left, the last is the previous one.
///
/// The usual valences are stored inline, so that walking a ring costs loads that do not wait for
/// each other (about twice as fast as walking half-edges); longer rings spill to the heap.
class NeighbourRing {
public:
    static constexpr int inlineCapacity = 10;

    NeighbourRing() = default;
    NeighbourRing(const NeighbourRing &other) { *this = other; }
    NeighbourRing(NeighbourRing &&) noexcept = default;
    NeighbourRing &operator=(NeighbourRing &&) noexcept = default;
    NeighbourRing &operator=(const NeighbourRing &other)
    {
        if (this == &other)
            return *this;
        size_ = other.size_;
        isOpen_ = other.isOpen_;
        for (int i = 0; i < inlineCapacity; ++i)
            inline_[i] = other.inline_[i];
        spill_ = other.spill_ ? std::make_unique<std::vector<VertexId>>(*other.spill_) : nullptr;
        return *this;
    }

    int size() const { return size_; }
    bool isOpen() const { return isOpen_; }
    void setOpen(bool isOpen) { isOpen_ = isOpen; }

    /// Faces around the vertex: face i lies between the neighbours at places i and next(i).
    int faceCount() const { return isOpen_ ? size_ - 1 : size_; }
    bool hasFaceAfter(int place) const { return !isOpen_ || place + 1 < size_; }
    bool hasFaceBefore(int place) const { return !isOpen_ || place > 0; }
    /// Whether the edge to the neighbour at that place is one of a boundary.
    bool isBoundaryEdge(int place) const { return isOpen_ && (place == 0 || place + 1 == size_); }
    const VertexId *begin() const { return spill_ ? spill_->data() : inline_; }
    const VertexId *end() const { return begin() + size_; }
    VertexId operator[](int i) const
    {
        assert(0 <= i && i < size_);
        return begin()[i];
    }

    /// The neighbour i places after the first, for any i >= 0, as if the ring were closed.
    VertexId at(int i) const { return begin()[i % size_]; }
    int next(int i) const { return i + 1 < size_ ? i + 1 : 0; }
    int previous(int i) const { return i > 0 ? i - 1 : size_ - 1; }

    /// Place of a neighbour, or -1.
    int find(VertexId id) const
    {
        const VertexId *ids = begin();
        for (int i = 0; i < size_; ++i)
            if (ids[i] == id)
                return i;
        return -1;
    }
    bool contains(VertexId id) const { return find(id) >= 0; }

    /// Leaves the ring closed.
    void clear()
    {
        size_ = 0;
        isOpen_ = false;
        spill_.reset();
    }
    void pushBack(VertexId id) { insert(size_, id); }
    void set(int place, VertexId id) { data()[place] = id; }

    /// Makes `id` the neighbour at `place`; those from `place` on move one back.
    void insert(int place, VertexId id)
    {
        assert(0 <= place && place <= size_);
        reserve(size_ + 1);
        VertexId *ids = data();
        for (int i = size_; i > place; --i)
            ids[i] = ids[i - 1];
        ids[place] = id;
        ++size_;
    }

    void erase(int place)
    {
        assert(0 <= place && place < size_);
        VertexId *ids = data();
        for (int i = place; i + 1 < size_; ++i)
            ids[i] = ids[i + 1];
        --size_;
    }

    /// Makes the neighbour at `place` the first.
    void rotate(int place) { std::rotate(data(), data() + place, data() + size_); }

private:
    VertexId *data() { return spill_ ? spill_->data() : inline_; }

    void reserve(int count)
    {
        if (count <= inlineCapacity && !spill_)
            return;
        if (!spill_)
            spill_ = std::make_unique<std::vector<VertexId>>(inline_, inline_ + size_);
        if (static_cast<int>(spill_->size()) < count)
            spill_->resize(static_cast<std::size_t>(count) * 2);
    }

    std::int32_t size_ = 0;
    VertexId inline_[inlineCapacity] = {};
    bool isOpen_ = false;
    std::unique_ptr<std::vector<VertexId>> spill_;
};

namespace component {

/// VCG vertex component: the vertex's neighbour ring, R().
template <class T> class OneRing : public T {
public:
    NeighbourRing &R() { return ring_; }
    const NeighbourRing &R() const { return ring_; }
    const NeighbourRing &cR() const { return ring_; }

    template <class Other> void ImportData(const Other &other) { T::ImportData(other); }

    static void Name(std::vector<std::string> &names)
    {
        names.emplace_back("OneRing");
        T::Name(names);
    }

private:
    NeighbourRing ring_;
};

} // namespace component
} // namespace neuralmesh
