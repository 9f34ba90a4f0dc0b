// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/handle_loop.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace neuralmesh {
namespace {

constexpr Scalar unreached = std::numeric_limits<Scalar>::infinity();

/// Shortest paths from a root to all vertices of its component (Dijkstra).
struct PathTree {
    std::vector<Scalar> distance;
    std::vector<VertexId> parent;
    std::vector<VertexId> reached; ///< in order of distance

    PathTree(const NeuralMesh &mesh, VertexId root)
        : distance(mesh.idBound(), unreached), parent(mesh.idBound(), noVertex)
    {
        using Open = std::pair<Scalar, VertexId>;
        std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
        distance[root] = 0;
        open.push({0, root});
        while (!open.empty()) {
            const auto [d, v] = open.top();
            open.pop();
            if (d > distance[v])
                continue;
            reached.push_back(v);
            for (const VertexId u : mesh.ring(v)) {
                const Scalar through = d + (mesh.position(u) - mesh.position(v)).Norm();
                if (through < distance[u]) {
                    distance[u] = through;
                    parent[u] = v;
                    open.push({through, u});
                }
            }
        }
    }

    bool holds(VertexId a, VertexId b) const { return parent[a] == b || parent[b] == a; }
};

/// Sets of faces that can be merged (union by halving paths).
class FaceSets {
public:
    explicit FaceSets(FaceId count) : leader_(count)
    {
        std::iota(leader_.begin(), leader_.end(), FaceId(0));
    }

    /// False where both are in one set already.
    bool merge(FaceId a, FaceId b)
    {
        a = leader(a);
        b = leader(b);
        leader_[a] = b;
        return a != b;
    }

private:
    FaceId leader(FaceId face)
    {
        while (leader_[face] != face)
            face = leader_[face] = leader_[leader_[face]];
        return face;
    }

    std::vector<FaceId> leader_;
};

struct Edge {
    Scalar loopLength; ///< of the loop that it closes in the tree
    VertexId a, b;
};

std::vector<VertexId> loopThrough(const PathTree &tree, const Edge &edge)
{
    const auto toRoot = [&](VertexId v) {
        std::vector<VertexId> path{v};
        while (tree.parent[path.back()] != noVertex)
            path.push_back(tree.parent[path.back()]);
        return path;
    };
    std::vector<VertexId> one = toRoot(edge.a);
    std::vector<VertexId> other = toRoot(edge.b);
    while (one.size() > 1 && other.size() > 1 && one[one.size() - 2] == other[other.size() - 2]) {
        one.pop_back();
        other.pop_back();
    }
    one.insert(one.end(), other.rbegin() + 1, other.rend());
    return one;
}

} // namespace

std::vector<std::vector<VertexId>> handleLoops(const NeuralMesh &mesh, const FaceTable &faces,
                                               VertexId root)
{
    const PathTree tree(mesh, root);
    std::vector<Edge> edges;
    for (const VertexId a : tree.reached)
        for (const VertexId b : mesh.ring(a))
            if (a < b && !tree.holds(a, b))
                edges.push_back({tree.distance[a] + tree.distance[b] +
                                     (mesh.position(a) - mesh.position(b)).Norm(),
                                 a, b});
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge &e, const Edge &f) { return e.loopLength > f.loopLength; });
    // A tree of faces that crosses the edges with the longest loops leaves those that close
    // handles.
    FaceSets joined(faces.size());
    std::vector<std::vector<VertexId>> loops;
    for (const Edge &edge : edges)
        if (!joined.merge(faces.leftOf(edge.a, edge.b), faces.leftOf(edge.b, edge.a)))
            loops.push_back(loopThrough(tree, edge));
    std::reverse(loops.begin(), loops.end());
    return loops;
}

} // namespace neuralmesh
