// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/quadric_decimation.h"

#include <array>
#include <cmath>
#include <queue>
#include <vector>

#include "core/mesh/boundary.h"
#include "core/mesh/enumeration.h"
#include "core/mesh/ring_topology.h"

namespace neuralmesh {
namespace {

/// Weight of an edge's squared length, times the area at its ends, beside the quadric error. It
/// decides where the surface is flat, and keeps the vertices apart evenly there.
constexpr double lengthWeight = 1e-3;

/// Cosine between a face's normals before and after a collapse, at the least.
constexpr double leastTurn = 0.2;

/// Edges up to this share of those of a mesh of the vertices asked for are collapsed before any
/// error is weighed: they are too short to matter, and most of a level set's.
constexpr double shortEdge = 0.25;

/// Sum of squared distances to planes, each weighted by its face's area.
struct Quadric {
    std::array<double, 10> q{}; // aa ab ac ad bb bc bd cc cd dd
    double area = 0;

    void addPlane(const Point3 &n, double d, double weight)
    {
        const double p[4] = {n.X(), n.Y(), n.Z(), d};
        for (int i = 0, k = 0; i < 4; ++i)
            for (int j = i; j < 4; ++j)
                q[static_cast<std::size_t>(k++)] += weight * p[i] * p[j];
        area += weight;
    }
    Quadric operator+(const Quadric &other) const
    {
        Quadric sum = *this;
        for (std::size_t i = 0; i < q.size(); ++i)
            sum.q[i] += other.q[i];
        sum.area += other.area;
        return sum;
    }
    double at(const Point3 &p) const
    {
        const double x = p.X(), y = p.Y(), z = p.Z();
        return q[0] * x * x + q[4] * y * y + q[7] * z * z + q[9] +
               2 * (q[1] * x * y + q[2] * x * z + q[3] * x + q[5] * y * z + q[6] * y + q[8] * z);
    }
};

/// Whether a face of v that u is not a corner of would turn if v moved.
bool turnsFace(const NeuralMesh &mesh, VertexId v, VertexId u, const Point3 &place)
{
    const Point3 &before = mesh.position(v);
    bool turns = false;
    forEachFaceAround(mesh, v, [&](VertexId a, VertexId b) {
        if (a == u || b == u)
            return;
        const Point3 &p = mesh.position(a);
        const Point3 side = mesh.position(b) - p;
        const Point3 old = side ^ (before - p);
        const Point3 now = side ^ (place - p);
        turns =
            turns || (old * now <= leastTurn * old.Norm() * now.Norm() && old.SquaredNorm() > 0);
    });
    return turns;
}

class Decimation {
public:
    explicit Decimation(NeuralMesh &mesh)
        : mesh_(mesh), quadrics_(mesh.idBound()), stamps_(mesh.idBound(), 0)
    {
        for (VertexId v = 0; v < mesh_.idBound(); ++v)
            if (mesh_.isLive(v))
                measure(v);
        for (VertexId v = 0; v < mesh_.idBound(); ++v)
            if (mesh_.isLive(v))
                for (const VertexId u : mesh_.ring(v))
                    if (v < u)
                        offer(v, u);
    }

    void run(int vertices)
    {
        while (mesh_.vn > vertices && !edges_.empty()) {
            const Edge edge = edges_.top();
            edges_.pop();
            if (edge.stamp != stamps_[edge.v] + stamps_[edge.u] || !mesh_.isLive(edge.v) ||
                !mesh_.isLive(edge.u) || !canCollapse(mesh_, edge.v, edge.u))
                continue;
            const Point3 place = bestPlace(edge.v, edge.u);
            if (!turnsFace(mesh_, edge.v, edge.u, place) &&
                !turnsFace(mesh_, edge.u, edge.v, place))
                remove(edge.v, edge.u, place);
        }
    }

private:
    /// Valid while neither of its ends has changed, which their stamps count.
    struct Edge {
        double cost;
        VertexId v, u;
        unsigned stamp;
        bool operator<(const Edge &other) const // the cheapest on top; ties by id
        {
            return cost != other.cost ? cost > other.cost
                   : v != other.v     ? v > other.v
                                      : u > other.u;
        }
    };

    void measure(VertexId v)
    {
        const Point3 &centre = mesh_.position(v);
        forEachFaceAround(mesh_, v, [&](VertexId a, VertexId b) {
            const Point3 toA = mesh_.position(a) - centre;
            const Point3 toB = mesh_.position(b) - centre;
            addPlane(v, toA ^ toB);
            // Across the face at a boundary edge, so that the boundary keeps its place.
            for (const VertexId end : {a, b})
                if (isBoundaryEdge(mesh_, v, end))
                    addPlane(v, (toA ^ toB) ^ (mesh_.position(end) - centre).Normalize());
        });
    }

    /// The plane through v with that normal, which is as long as the plane counts.
    void addPlane(VertexId v, Point3 normal)
    {
        const double weight = normal.Norm();
        if (!(weight > 0))
            return;
        normal /= weight;
        quadrics_[v].addPlane(normal, -(normal * mesh_.position(v)), weight);
    }

    Point3 bestPlace(VertexId v, VertexId u) const
    {
        const Quadric sum = quadrics_[v] + quadrics_[u];
        const Point3 &a = mesh_.position(v);
        const Point3 &b = mesh_.position(u);
        Point3 best = (a + b) / 2;
        for (const Point3 &place : {a, b})
            if (sum.at(place) < sum.at(best))
                best = place;
        return best;
    }

    void offer(VertexId v, VertexId u)
    {
        const Quadric sum = quadrics_[v] + quadrics_[u];
        const double length = (mesh_.position(v) - mesh_.position(u)).SquaredNorm();
        edges_.push({sum.at(bestPlace(v, u)) + lengthWeight * length * sum.area, v, u,
                     stamps_[v] + stamps_[u]});
    }

    void remove(VertexId v, VertexId u, const Point3 &place)
    {
        collapse(mesh_, v, u);
        mesh_.position(u) = place;
        quadrics_[u] = quadrics_[u] + quadrics_[v];
        ++stamps_[u];
        for (const VertexId w : mesh_.ring(u))
            offer(u, w);
    }

    NeuralMesh &mesh_;
    std::vector<Quadric> quadrics_;
    std::vector<unsigned> stamps_; ///< how often the vertex has changed
    std::priority_queue<Edge> edges_;
};

/// Of triangles that are equilateral and equal.
double usualEdge(const NeuralMesh &mesh, int vertices)
{
    double doubleArea = 0;
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        const Point3 &p = mesh.position(v);
        doubleArea += ((mesh.position(a) - p) ^ (mesh.position(b) - p)).Norm();
    });
    return std::sqrt(doubleArea / (std::sqrt(3.0) * vertices));
}

/// Collapses each vertex into its nearest neighbour, where that is nearer than `length`.
void collapseShortEdges(NeuralMesh &mesh, double length, int vertices)
{
    for (VertexId v = 0; v < mesh.idBound() && mesh.vn > vertices; ++v) {
        if (!mesh.isLive(v))
            continue;
        VertexId nearest = noVertex;
        double least = length * length;
        for (const VertexId u : mesh.ring(v)) {
            const double squared = (mesh.position(u) - mesh.position(v)).SquaredNorm();
            if (squared < least) {
                least = squared;
                nearest = u;
            }
        }
        if (nearest != noVertex && canCollapse(mesh, v, nearest) &&
            !turnsFace(mesh, v, nearest, mesh.position(nearest)))
            collapse(mesh, v, nearest);
    }
}

} // namespace

void decimate(NeuralMesh &mesh, int vertices)
{
    const double length = shortEdge * usualEdge(mesh, vertices);
    int before = 0;
    do {
        before = mesh.vn;
        collapseShortEdges(mesh, length, vertices);
    } while (mesh.vn < before * 0.9);
    Decimation(mesh).run(vertices);
    mesh.compact(); // a thousandth of the slots may be in use, and all of them are walked through
}

} // namespace neuralmesh
