// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/unsupported_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/edge_lengths.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/ring_topology.h"
#include "core/mesh/triangle.h"
#include "core/mesh/vertex_data.h"

namespace neuralmesh {
namespace {

/// Times the local spacing from which an edge counts as overlong.
constexpr Scalar overlongRatio = 2.5;

/// An edge is supported by a sample that is no further from its middle than this, in lengths of
/// the edge. On a surface, the height of the arc over an edge is far less; across a gap it is half
/// the edge or more.
constexpr Scalar supportDistance = 0.3;

/// A face is unsupported where no sample is nearer to its centre, in lengths of its edge.
constexpr Scalar farFromFace = 0.5;

/// A flip must shorten by this factor to count as progress.
constexpr Scalar shortening = 0.8;

/// Some milliseconds.
constexpr std::size_t verticesPerLook = 1024;

/// Whether an edge is overlong for the spacings at its ends.
bool exceeds(Scalar length, Scalar spacing, Scalar otherSpacing)
{
    return length > overlongRatio * (spacing + otherSpacing) / 2;
}

Scalar flippedLength(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    const OppositeVertices opposite = oppositeVertices(mesh, v, u);
    return edgeLength(mesh, opposite.left, opposite.right);
}

class WebRetraction {
public:
    WebRetraction(NeuralMesh &mesh, const SampleSupport &support)
        : mesh_(mesh), support_(support), spacing_(mesh)
    {
    }

    int run()
    {
        int flips = 0;
        forEachVertex(mesh_, [&](VertexId v) {
            open_.push_back(v);
            spacing_[v] = localSpacing(mesh_, v);
        });
        std::reverse(open_.begin(), open_.end()); // the lowest id is looked at first
        for (std::size_t looked = 0; !open_.empty(); ++looked) {
            const VertexId v = open_.back();
            open_.pop_back();
            if (looked % verticesPerLook == 0)
                support_.watch().look();
            flips += retractAt(v) ? 1 : 0;
        }
        return flips;
    }

private:
    /// Flips the first edge of v that can be. A flip frees the edges around it: its four corners
    /// are looked at again.
    bool retractAt(VertexId v)
    {
        for (int i = 0; i < mesh_.valence(v); ++i) {
            const VertexId u = mesh_.ring(v)[i];
            if (!isWeb(v, u))
                continue;
            const OppositeVertices opposite = oppositeVertices(mesh_, v, u);
            if (!flipIfMuchShorter(v, u) && !flipAfterNeighbour(v, u))
                continue;
            for (const VertexId corner : {opposite.right, opposite.left, u, v}) {
                open_.push_back(corner);
                spacing_[corner] = localSpacing(mesh_, corner);
            }
            return true;
        }
        return false;
    }

    bool isWeb(VertexId v, VertexId u) const
    {
        return exceeds(edgeLength(mesh_, v, u), spacing_[v], spacing_[u]) ||
               !isSupported(mesh_, support_, v, u);
    }

    bool flipIfMuchShorter(VertexId v, VertexId u)
    {
        if (!canFlip(mesh_, v, u) ||
            flippedLength(mesh_, v, u) > shortening * edgeLength(mesh_, v, u))
            return false;
        flip(mesh_, v, u);
        return true;
    }

    /// Where the opposite vertices lie on different sides of the void, flipping an edge of the
    /// web next to it first puts another vertex opposite. Tries each of the four.
    bool flipAfterNeighbour(VertexId v, VertexId u)
    {
        const Scalar length = edgeLength(mesh_, v, u);
        const OppositeVertices opposite = oppositeVertices(mesh_, v, u);
        const VertexId rim[4][2] = {
            {v, opposite.left}, {u, opposite.left}, {v, opposite.right}, {u, opposite.right}};
        for (const auto &[end, corner] : rim) {
            if (!isWeb(end, corner) || !canFlip(mesh_, end, corner))
                continue;
            const Scalar before = length + edgeLength(mesh_, end, corner);
            const Scalar rimAfter = flippedLength(mesh_, end, corner);
            const OppositeVertices undo = oppositeVertices(mesh_, end, corner);
            flip(mesh_, end, corner);
            if (canFlip(mesh_, v, u) && flippedLength(mesh_, v, u) <= shortening * length &&
                flippedLength(mesh_, v, u) + rimAfter <= shortening * before) {
                flip(mesh_, v, u);
                return true;
            }
            flip(mesh_, undo.left, undo.right);
        }
        return false;
    }

    NeuralMesh &mesh_;
    const SampleSupport &support_;
    std::vector<VertexId> open_;
    VertexData<Scalar> spacing_; ///< kept in step at the corners of each flip
};

} // namespace

bool isSupported(const NeuralMesh &mesh, const SampleSupport &support, VertexId v, VertexId u)
{
    const Point3 middle = (mesh.position(v) + mesh.position(u)) / 2;
    return support.hasWithin(middle, supportDistance * edgeLength(mesh, v, u));
}

double unsupportedShare(const NeuralMesh &mesh, const SampleSupport &support)
{
    double all = 0;
    double unsupported = 0;
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        const Triangle t{mesh.position(v), mesh.position(a), mesh.position(b)};
        const Scalar faceArea = area(t);
        all += faceArea;
        // Of an equilateral triangle of that area.
        const Scalar edge = std::sqrt(faceArea * 4 / std::sqrt(Scalar(3)));
        if (!support.hasWithin((t.a + t.b + t.c) / 3, farFromFace * edge))
            unsupported += faceArea;
    });
    return all > 0 ? unsupported / all : 0;
}

bool isOverlong(const NeuralMesh &mesh, VertexId v, VertexId u)
{
    return exceeds(edgeLength(mesh, v, u), localSpacing(mesh, v), localSpacing(mesh, u));
}

int retractWebs(NeuralMesh &mesh, const SampleSupport &support)
{
    return WebRetraction(mesh, support).run();
}

} // namespace neuralmesh
