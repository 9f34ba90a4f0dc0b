// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/manifold_mesh.h"

#include <algorithm>
#include <utility>

#include "core/mesh/face_sides.h"
#include "core/mesh/ring_topology.h"
#include "neuralmesh/errors.h"

namespace neuralmesh {
namespace {

using Faces = std::vector<Corners>;
using Problem = InvalidStartingMesh::Problem;

constexpr std::size_t corner(std::size_t c)
{
    return c % 3;
}

void requireProperFaces(const Faces &faces)
{
    if (faces.empty())
        throw InvalidStartingMesh(Problem::noFaces);
    const auto broken = std::count_if(faces.begin(), faces.end(), [](const Corners &f) {
        return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
    });
    if (broken > 0)
        throw InvalidStartingMesh(Problem::repeatedCorner, static_cast<std::uint64_t>(broken));
}

/// The end of the sides of one edge, which begin at `begin`.
std::size_t endOfEdge(const std::vector<FaceSide> &sides, std::size_t begin)
{
    std::size_t end = begin + 1;
    while (end < sides.size() && sides[end].low == sides[begin].low &&
           sides[end].high == sides[begin].high)
        ++end;
    return end;
}

void requireTwoFacesAtEachEdge(const std::vector<FaceSide> &sides, Boundaries boundaries)
{
    std::size_t open = 0;
    std::size_t crowded = 0;
    for (std::size_t i = 0; i < sides.size();) {
        const std::size_t end = endOfEdge(sides, i);
        open += end - i == 1 ? 1 : 0;
        crowded += end - i > 2 ? 1 : 0;
        i = end;
    }
    if (crowded > 0)
        throw InvalidStartingMesh(Problem::crowdedEdge, crowded);
    if (open > 0 && boundaries == Boundaries::refused)
        throw InvalidStartingMesh(Problem::openEdge, open);
}

/// Faces across each face's sides, and whether the two agree on their orientation.
class Adjacency {
public:
    Adjacency(const Faces &faces, Boundaries boundaries) : neighbours_(faces.size())
    {
        const std::vector<FaceSide> sides = sidesByEdge(faces);
        requireTwoFacesAtEachEdge(sides, boundaries);
        for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
            if (endOfEdge(sides, i) == i + 1)
                continue; // on a boundary, or seen with the side before
            const FaceSide &a = sides[i];
            const FaceSide &b = sides[i + 1];
            const bool agree = a.isRising != b.isRising;
            neighbours_[a.face].add(b.face, agree);
            neighbours_[b.face].add(a.face, agree);
        }
    }

    template <class Visit> void forEachNeighbour(FaceId face, Visit visit) const
    {
        for (int i = 0; i < neighbours_[face].count; ++i)
            visit(neighbours_[face].faces[i], neighbours_[face].agree[i]);
    }

    bool isOnBoundary(FaceId face) const { return neighbours_[face].count < 3; }

private:
    struct Neighbours {
        FaceId faces[3];
        bool agree[3];
        int count = 0;

        void add(FaceId face, bool agrees)
        {
            faces[count] = face;
            agree[count++] = agrees;
        }
    };

    std::vector<Neighbours> neighbours_;
};

double volumeOf(const std::vector<Point3> &points, const Faces &faces,
                const std::vector<FaceId> &chosen)
{
    double volume = 0;
    for (const FaceId f : chosen)
        volume += points[faces[f][0]] * (points[faces[f][1]] ^ points[faces[f][2]]) / 6;
    return volume;
}

/// Turns faces so that neighbours agree, component by component.
void orient(const std::vector<Point3> &points, Faces &faces, Boundaries boundaries)
{
    const Adjacency adjacency(faces, boundaries);
    enum State : unsigned char { unseen, kept, turned };
    std::vector<State> states(faces.size(), unseen);
    for (FaceId seed = 0; seed < faces.size(); ++seed) {
        if (states[seed] != unseen)
            continue;
        states[seed] = kept;
        std::vector<FaceId> component{seed};
        bool hasTurned = false;
        bool isClosed = true;
        for (std::size_t next = 0; next < component.size(); ++next) {
            const FaceId f = component[next];
            isClosed = isClosed && !adjacency.isOnBoundary(f);
            adjacency.forEachNeighbour(f, [&](FaceId g, bool agree) {
                const State wanted = agree == (states[f] == kept) ? kept : turned;
                if (states[g] == unseen) {
                    states[g] = wanted;
                    component.push_back(g);
                } else if (states[g] != wanted) {
                    throw InvalidStartingMesh(Problem::notOrientable);
                }
            });
        }
        for (const FaceId f : component)
            if (states[f] == turned) {
                std::swap(faces[f][1], faces[f][2]);
                hasTurned = true;
            }
        if (hasTurned && isClosed && volumeOf(points, faces, component) < 0)
            for (const FaceId f : component)
                std::swap(faces[f][1], faces[f][2]);
    }
}

/// Points that faces name, renumbered.
void addVertices(NeuralMesh &mesh, const std::vector<Point3> &points, Faces &faces)
{
    std::vector<VertexId> place(points.size(), noVertex);
    mesh.Clear();
    for (Corners &face : faces)
        for (VertexId &v : face) {
            if (place[v] == noVertex) {
                place[v] = mesh.addVertex(points[v]);
            }
            v = place[v];
        }
}

/// From a neighbour of a vertex to the next, across a face.
using Step = std::pair<VertexId, VertexId>;

/// The steps around each vertex, one vertex after the other.
class Fans {
public:
    Fans(const Faces &faces, VertexId vertexCount)
        : first_(static_cast<std::size_t>(vertexCount) + 1, 0), steps_(3 * faces.size())
    {
        for (const Corners &face : faces)
            for (const VertexId v : face)
                ++first_[v + 1];
        for (std::size_t v = 1; v < first_.size(); ++v)
            first_[v] += first_[v - 1];
        std::vector<std::size_t> next = first_;
        for (const Corners &face : faces)
            for (std::size_t c = 0; c < 3; ++c)
                steps_[next[face[c]]++] = {face[corner(c + 1)], face[corner(c + 2)]};
    }

    /// Makes the ring of v, from its neighbour of the lowest id on, or along a boundary.
    void makeRing(NeuralMesh &mesh, VertexId v)
    {
        const auto begin = steps_.begin() + static_cast<std::ptrdiff_t>(first_[v]);
        const auto end = steps_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]);
        std::sort(begin, end);
        const auto from = [&](VertexId at) {
            const auto step = std::lower_bound(begin, end, Step(at, 0));
            return step != end && step->first == at ? step->second : noVertex;
        };
        // The neighbour that no step leads to, if there is one: v lies on a boundary then.
        const auto boundary = std::find_if(begin, end, [&](const Step &step) {
            return std::none_of(begin, end,
                                [&](const Step &other) { return other.second == step.first; });
        });
        const VertexId start = boundary != end ? boundary->first : begin->first;
        NeighbourRing &ring = mesh.ring(v);
        VertexId at = start;
        do {
            ring.pushBack(at);
            at = from(at);
        } while (at != start && at != noVertex);
        ring.setOpen(at == noVertex);
        if (ring.faceCount() != end - begin)
            throw InvalidStartingMesh(Problem::severalFans);
        if (!ring.isOpen() && end - begin < 3)
            throw InvalidStartingMesh(Problem::doubledFace);
    }

private:
    std::vector<std::size_t> first_; ///< by vertex
    std::vector<Step> steps_;
};

} // namespace

void makeManifold(NeuralMesh &mesh, const std::vector<Point3> &points, const Faces &given,
                  Boundaries boundaries)
{
    Faces faces = given;
    requireProperFaces(faces);
    orient(points, faces, boundaries);
    addVertices(mesh, points, faces);
    Fans fans(faces, mesh.idBound());
    for (VertexId v = 0; v < mesh.idBound(); ++v)
        fans.makeRing(mesh, v);
}

} // namespace neuralmesh
