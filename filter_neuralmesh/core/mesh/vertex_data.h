// SPDX-License-Identifier: GPL-3.0-or-later
// Data of the vertices that follow the mesh: they grow with it, and a slot used again starts anew.
//
// The manner is that of geometry-central's MeshData.
#pragma once

#include <cassert>
#include <utility>
#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// A value for every vertex, by id. Vertices that are added start with the initial value. The mesh
/// must outlive its data. Not to be made or destroyed while another thread uses the mesh.
template <class T> class VertexData final : private VertexFollower {
public:
    explicit VertexData(const NeuralMesh &mesh, T initial = T())
        : mesh_(mesh), initial_(std::move(initial)), values_(mesh.idBound(), initial_)
    {
        mesh_.follow(*this);
    }
    ~VertexData() { mesh_.unfollow(*this); }
    VertexData(const VertexData &) = delete;
    VertexData &operator=(const VertexData &) = delete;

    T &operator[](VertexId v)
    {
        assert(v < values_.size());
        return values_[v];
    }
    const T &operator[](VertexId v) const
    {
        assert(v < values_.size());
        return values_[v];
    }

    /// Gives every vertex the initial value again.
    void reset() { values_.assign(values_.size(), initial_); }

private:
    void vertexAdded(VertexId v) override
    {
        if (v == values_.size())
            values_.push_back(initial_);
        else
            values_[v] = initial_;
    }
    void vertexRemoved(VertexId) override {}

    const NeuralMesh &mesh_;
    T initial_;
    std::vector<T> values_;
};

} // namespace neuralmesh
