// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/sheet_doubling.h"

#include <algorithm>
#include <map>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/triangle.h"
#include "core/topology/closure_cost.h"

namespace neuralmesh {
namespace {

/// Area of the disc over a loop, at the least: that of its shadow in the plane of its vector area.
double spannedArea(const NeuralMesh &mesh, const std::vector<VertexId> &loop)
{
    const Point3 &origin = mesh.position(loop.front());
    Point3 sum(0, 0, 0);
    for (std::size_t i = 0; i + 1 < loop.size(); ++i)
        sum += (mesh.position(loop[i]) - origin) ^ (mesh.position(loop[i + 1]) - origin);
    return sum.Norm() / 2;
}

class Doubling {
public:
    Doubling(NeuralMesh &mesh, const std::vector<VertexId> &sheets) : mesh_(mesh), front_(sheets) {}

    std::vector<Doubled> run()
    {
        mirror();
        if (!partChords() || !allHaveRoom()) {
            removeCopies();
            return {};
        }
        sew();
        std::vector<Doubled> doubled;
        for (const VertexId v : front_)
            if (!isSeam(v))
                doubled.emplace_back(v, other_[v]);
        for (const VertexId v : front_)
            if (isSeam(v))
                mesh_.removeVertex(other_[v]);
        return doubled;
    }

private:
    bool isSeam(VertexId v) const { return seam_[v]; }

    void mirror()
    {
        other_.assign(mesh_.idBound() + front_.size(), noVertex);
        seam_.assign(other_.size(), false);
        for (const VertexId v : front_) {
            const VertexId copy = mesh_.addVertex(mesh_.position(v));
            other_[v] = copy;
            other_[copy] = v;
            seam_[v] = seam_[copy] = mesh_.isOnBoundary(v);
        }
        for (const VertexId v : front_) {
            const NeighbourRing &ring = mesh_.ring(v);
            NeighbourRing &mirrored = mesh_.ring(other_[v]);
            for (int i = ring.size() - 1; i >= 0; --i)
                mirrored.pushBack(other_[ring[i]]);
            mirrored.setOpen(ring.isOpen());
        }
    }

    /// Until no edge inside a side joins two vertices of the seam that an edge of the other joins.
    bool partChords()
    {
        std::vector<Doubled> chords = sharedChords();
        while (!chords.empty()) {
            for (const auto &[a, b] : chords)
                partChord(a, b);
            const std::size_t before = chords.size();
            chords = sharedChords();
            if (chords.size() >= before)
                return false;
        }
        return true;
    }

    std::vector<Doubled> sharedChords() const
    {
        std::vector<Doubled> chords;
        for (const VertexId v : front_)
            if (isSeam(v))
                for (const VertexId u : mesh_.ring(v))
                    if (v < u && isSeam(u) && !isBoundaryEdge(mesh_, v, u) &&
                        mesh_.ring(other_[v]).contains(other_[u]))
                        chords.emplace_back(v, u);
        return chords;
    }

    /// The flipped edge must pass on its own side of the other's: over a valley in front, behind a
    /// ridge.
    void partChord(VertexId a, VertexId b)
    {
        const bool inFront = isValley(a, b);
        for (const bool front : {inFront, !inFront}) {
            const VertexId v = front ? a : other_[a];
            const VertexId u = front ? b : other_[b];
            if (canPart(v, u))
                return flip(mesh_, v, u);
        }
    }

    /// Seen from the front.
    bool isValley(VertexId a, VertexId b) const
    {
        const OppositeVertices opposite = oppositeVertices(mesh_, a, b);
        const Point3 &p = mesh_.position(a);
        const Point3 normal = (mesh_.position(b) - p) ^ (mesh_.position(opposite.left) - p);
        return normal * (mesh_.position(opposite.right) - p) > 0;
    }

    bool canPart(VertexId v, VertexId u) const
    {
        if (!canFlip(mesh_, v, u))
            return false;
        const OppositeVertices opposite = oppositeVertices(mesh_, v, u);
        return !(isSeam(opposite.left) && isSeam(opposite.right) &&
                 mesh_.ring(other_[opposite.left]).contains(other_[opposite.right]));
    }

    /// Whether each vertex of the seam has three neighbours once it is sewn.
    bool allHaveRoom() const
    {
        return std::all_of(front_.begin(), front_.end(), [&](VertexId v) {
            return !isSeam(v) || mesh_.valence(v) + mesh_.valence(other_[v]) - 2 >= 3;
        });
    }

    void sew()
    {
        for (const VertexId v : front_) {
            NeighbourRing &behind = mesh_.ring(other_[v]);
            for (int i = 0; i < behind.size(); ++i)
                if (isSeam(behind[i]))
                    behind.set(i, other_[behind[i]]);
            if (!isSeam(v))
                continue;
            // The ring in front ends where that behind begins, and the other way round.
            NeighbourRing &ring = mesh_.ring(v);
            for (int i = 1; i + 1 < behind.size(); ++i)
                ring.pushBack(behind[i]);
            ring.setOpen(false);
        }
    }

    void removeCopies()
    {
        for (const VertexId v : front_)
            mesh_.removeVertex(other_[v]);
    }

    NeuralMesh &mesh_;
    const std::vector<VertexId> &front_; ///< the vertices of the sheets
    std::vector<VertexId> other_;        ///< from a vertex to its copy, and back
    std::vector<bool> seam_;
};

} // namespace

int OpenSheets::judge()
{
    const std::vector<int> label = labelComponents(mesh_);
    const auto of = [&](VertexId v) { return static_cast<std::size_t>(label[v]); };
    std::vector<double> own(label.size(), 0);
    forEachFace(mesh_, [&](VertexId a, VertexId b, VertexId c) {
        own[of(a)] += area(Triangle{mesh_.position(a), mesh_.position(b), mesh_.position(c)});
    });
    std::vector<double> spanned(label.size(), 0);
    for (const std::vector<VertexId> &loop : boundaryLoops(mesh_))
        spanned[of(loop.front())] += spannedArea(mesh_, loop);
    const auto isSheet = [&](std::size_t i) { return spanned[i] > largeDisc * own[i]; };
    forEachVertex(mesh_, [&](VertexId v) { isOfSheet_[v] = isSheet(of(v)) ? 1 : 0; });
    int sheets = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
        sheets += isSheet(i) ? 1 : 0;
    isEmpty_ = sheets == 0;
    return sheets;
}

int OpenSheets::copies() const
{
    int count = 0;
    for (const VertexId v : vertices())
        count += mesh_.isOnBoundary(v) ? 0 : 1;
    return count;
}

std::vector<VertexId> OpenSheets::vertices() const
{
    std::vector<VertexId> found;
    if (isEmpty_)
        return found;
    const std::vector<int> label = labelComponents(mesh_);
    std::vector<bool> isSheet(label.size(), false);
    const auto of = [&](VertexId v) { return static_cast<std::size_t>(label[v]); };
    forEachVertex(mesh_,
                  [&](VertexId v) { isSheet[of(v)] = isSheet[of(v)] || isOfSheet_[v] != 0; });
    std::vector<bool> isOpen(label.size(), false);
    forEachVertex(mesh_,
                  [&](VertexId v) { isOpen[of(v)] = isOpen[of(v)] || mesh_.isOnBoundary(v); });
    forEachVertex(mesh_, [&](VertexId v) {
        if (isSheet[of(v)] && isOpen[of(v)])
            found.push_back(v);
    });
    return found;
}

std::vector<Doubled> doubleSheets(NeuralMesh &mesh, const std::vector<VertexId> &sheets)
{
    const std::vector<int> label = labelComponents(mesh);
    std::map<int, std::vector<VertexId>> components;
    for (const VertexId v : sheets)
        components[label[v]].push_back(v);
    std::vector<Doubled> doubled;
    for (const auto &component : components) {
        const std::vector<Doubled> added = Doubling(mesh, component.second).run();
        doubled.insert(doubled.end(), added.begin(), added.end());
    }
    return doubled;
}

} // namespace neuralmesh
