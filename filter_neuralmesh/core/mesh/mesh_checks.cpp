// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_checks.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"

namespace neuralmesh {
namespace {

std::string describe(const char *what, VertexId v, VertexId u)
{
    return std::string(what) + " (vertices " + std::to_string(v) + " and " + std::to_string(u) +
           ")";
}

std::string findDefectAt(const NeuralMesh &mesh, VertexId v)
{
    const NeighbourRing &ring = mesh.ring(v);
    if (ring.size() < (ring.isOpen() ? 2 : 3))
        return describe("a vertex has too few neighbours", v, v);
    if (std::set<VertexId>(ring.begin(), ring.end()).size() !=
        static_cast<std::size_t>(ring.size()))
        return describe("a ring names a neighbour twice", v, v);
    for (int i = 0; i < ring.size(); ++i) {
        const VertexId a = ring[i];
        if (a == v)
            return describe("a vertex is its own neighbour", v, v);
        if (!mesh.isLive(a))
            return describe("a ring names a removed vertex", v, a);
        const NeighbourRing &other = mesh.ring(a);
        if (!ring.hasFaceAfter(i)) {
            if (!other.isOpen() || other[0] != v)
                return describe("a boundary is not the same seen from two of its vertices", v, a);
            continue;
        }
        const int place = other.find(ring[ring.next(i)]);
        if (place < 0 || !other.hasFaceAfter(place) || other[other.next(place)] != v)
            return describe("a face is not the same seen from two of its corners", v, a);
    }
    return {};
}

/// Of the tetrahedron of a face and an origin, which is to be near: the terms of a mesh far from it
/// are larger than their sum by so much that rounding decides its sign.
double sixfoldVolume(const NeuralMesh &mesh, VertexId v, VertexId a, VertexId b,
                     const Point3 &origin)
{
    return (mesh.position(v) - origin) *
           ((mesh.position(a) - origin) ^ (mesh.position(b) - origin));
}

Point3 firstPosition(const NeuralMesh &mesh)
{
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        if (mesh.isLive(v))
            return mesh.position(v);
    return {0, 0, 0};
}

} // namespace

std::string findDefect(const NeuralMesh &mesh)
{
    int live = 0;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        if (!mesh.isLive(v)) {
            if (mesh.valence(v) != 0)
                return describe("a removed vertex has neighbours", v, v);
            continue;
        }
        ++live;
        if (std::string defect = findDefectAt(mesh, v); !defect.empty())
            return defect;
    }
    return live == mesh.vn ? std::string() : "the vertex count is wrong";
}

void validate(const NeuralMesh &mesh)
{
    if (const std::string defect = findDefect(mesh); !defect.empty())
        throw std::logic_error("The network is broken: " + defect + ".");
}

std::vector<int> labelComponents(const NeuralMesh &mesh)
{
    std::vector<int> labels(mesh.idBound(), -1);
    std::vector<VertexId> open;
    int components = 0;
    forEachVertex(mesh, [&](VertexId seed) {
        if (labels[seed] >= 0)
            return;
        labels[seed] = components;
        open.push_back(seed);
        while (!open.empty()) {
            const VertexId v = open.back();
            open.pop_back();
            for (const VertexId u : mesh.ring(v))
                if (labels[u] < 0) {
                    labels[u] = components;
                    open.push_back(u);
                }
        }
        ++components;
    });
    return labels;
}

TopologyFigures measureTopology(const NeuralMesh &mesh)
{
    TopologyFigures figures;
    const std::vector<int> labels = labelComponents(mesh);
    forEachVertex(mesh, [&](VertexId v) {
        figures.components = std::max(figures.components, labels[v] + 1);
        ++figures.vertices;
    });
    forEachEdge(mesh, [&](VertexId, VertexId) { ++figures.edges; });
    forEachFace(mesh, [&](VertexId, VertexId, VertexId) { ++figures.faces; });
    figures.boundaryLoops = static_cast<int>(boundaryLoops(mesh).size());
    figures.genus = figures.components -
                    (figures.vertices - figures.edges + figures.faces + figures.boundaryLoops) / 2;
    return figures;
}

std::vector<int> valenceHistogram(const NeuralMesh &mesh)
{
    std::vector<int> histogram;
    forEachVertex(mesh, [&](VertexId v) {
        const auto valence = static_cast<std::size_t>(mesh.valence(v));
        if (histogram.size() <= valence)
            histogram.resize(valence + 1, 0);
        ++histogram[valence];
    });
    return histogram;
}

double signedVolume(const NeuralMesh &mesh)
{
    double volume = 0;
    const Point3 origin = firstPosition(mesh);
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        volume += sixfoldVolume(mesh, v, a, b, origin) / 6;
    });
    return volume;
}

std::vector<double> signedVolumes(const NeuralMesh &mesh, const std::vector<int> &labels)
{
    std::vector<double> volumes;
    std::vector<Point3> origins;
    forEachVertex(mesh, [&](VertexId v) {
        if (static_cast<std::size_t>(labels[v]) == origins.size()) // the first of its component
            origins.push_back(mesh.position(v));
    });
    volumes.assign(origins.size(), 0);
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        const auto component = static_cast<std::size_t>(labels[v]);
        volumes[component] += sixfoldVolume(mesh, v, a, b, origins[component]) / 6;
    });
    return volumes;
}

} // namespace neuralmesh
