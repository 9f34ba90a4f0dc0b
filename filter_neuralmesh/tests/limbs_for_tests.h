// SPDX-License-Identifier: GPL-3.0-or-later
// A network that spans the gap between two legs, the samples that say that it should not, and what
// becomes of it when inactive vertices are collapsed.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "core/mesh/enumeration.h"
#include "core/network/growing_network.h"
#include "core/network/star_projection.h"
#include "core/topology/sample_support.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh::test {

/// A mesh in the making, and samples of what it should be.
struct Scene {
    std::vector<Point3> points;
    std::vector<Triangle> faces;
    std::vector<Point3> samples;
};

/// A body on two round legs, as a network has it that has not yet found the gap between them: one
/// tube for both, whose front and back sheets go straight across. Seen from above and from before:
///
///       ._____.          ___________
///     /         \       |   body    |
///    |  .     .  |      |___________|
///     \ _______ /       |  |     |  |
///                       |__|_web_|__|  z = 0
///
struct Legs {
    int perLeg = 10;   ///< faces around the outer half of a leg
    int acrossWeb = 6; ///< faces across the gap
    int legLevels = 9; ///< rows of faces
    int bodyLevels = 3;
    Scalar gap = 4.5;  ///< between the legs' axes
    Scalar height = 1; ///< of a row
    Scalar radius = 1; ///< of the legs

    Scalar bottomOfBody() const { return height * legLevels; }
    Scalar top() const { return height * (legLevels + bodyLevels); }
};

/// Its cross-section, counter-clockwise: around the left leg, the front of the web, around the
/// right leg, the back. All have the same at any height.
inline std::vector<vcg::Point2<Scalar>> crossSection(const Legs &legs)
{
    std::vector<vcg::Point2<Scalar>> loop;
    const auto addHalf = [&](Scalar centre, Scalar from) {
        for (int i = 0; i <= legs.perLeg; ++i) {
            const Scalar angle = from + M_PI * i / legs.perLeg;
            loop.emplace_back(centre + legs.radius * std::cos(angle),
                              legs.radius * std::sin(angle));
        }
    };
    addHalf(0, M_PI / 2);
    for (int i = 1; i < legs.acrossWeb; ++i)
        loop.emplace_back(legs.gap * i / legs.acrossWeb, -legs.radius);
    addHalf(legs.gap, -M_PI / 2);
    for (int i = 1; i < legs.acrossWeb; ++i)
        loop.emplace_back(legs.gap * (legs.acrossWeb - i) / legs.acrossWeb, legs.radius);
    return loop;
}

inline void addWebbedLegs(Scene &scene, const Legs &legs)
{
    const auto first = static_cast<VertexId>(scene.points.size());
    const auto loop = crossSection(legs);
    const auto size = static_cast<VertexId>(loop.size());
    const auto levels = static_cast<VertexId>(legs.legLevels + legs.bodyLevels + 1);
    for (VertexId level = 0; level < levels; ++level)
        for (const auto &p : loop)
            scene.points.emplace_back(p[0], p[1], level * legs.height);
    const auto at = [&](VertexId level, VertexId place) {
        return first + level * size + place % size;
    };
    for (VertexId level = 0; level + 1 < levels; ++level)
        for (VertexId k = 0; k < size; ++k) {
            scene.faces.push_back({{at(level, k), at(level, k + 1), at(level + 1, k)}});
            scene.faces.push_back({{at(level, k + 1), at(level + 1, k + 1), at(level + 1, k)}});
        }
    // Both ends by a strip of faces between front and back, from the middle of the left leg on.
    VertexId down = static_cast<VertexId>(legs.perLeg / 2);
    VertexId up = down + 1;
    const auto close = [&](VertexId a, VertexId b, VertexId c) {
        scene.faces.push_back({{at(0, a), at(0, c), at(0, b)}});
        scene.faces.push_back({{at(levels - 1, a), at(levels - 1, b), at(levels - 1, c)}});
    };
    for (VertexId faces = 0; faces + 2 < size; ++faces)
        if (faces % 2 == 0) {
            close(down, up, down + size - 1);
            down = (down + size - 1) % size;
        } else {
            close(down, up, up + 1);
            up = (up + 1) % size;
        }
}

/// Samples of body and legs everywhere, a fifth of a face apart.
inline void addSamplesOfLegs(Scene &scene, const Legs &legs)
{
    const Scalar step = std::min(legs.height, legs.radius) / 5;
    const auto isUnderLeg = [&](Scalar x, Scalar y) {
        return std::hypot(x, y) <= legs.radius || std::hypot(x - legs.gap, y) <= legs.radius;
    };
    const auto isUnderBody = [&](Scalar x, Scalar y) {
        return isUnderLeg(x, y) || (x >= 0 && x <= legs.gap);
    };
    for (Scalar x = -legs.radius; x <= legs.gap + legs.radius; x += step)
        for (Scalar y = -legs.radius; y <= legs.radius; y += step) {
            if (isUnderLeg(x, y))
                scene.samples.emplace_back(x, y, 0);
            else if (isUnderBody(x, y))
                scene.samples.emplace_back(x, y, legs.bottomOfBody());
            if (isUnderBody(x, y))
                scene.samples.emplace_back(x, y, legs.top());
        }
    const int around = static_cast<int>(2 * M_PI * legs.radius / step);
    for (Scalar z = step; z < legs.top(); z += step) {
        for (int i = 0; i < around; ++i) {
            const Scalar x = legs.radius * std::cos(2 * M_PI * i / around);
            const Scalar y = legs.radius * std::sin(2 * M_PI * i / around);
            const bool isBody = z > legs.bottomOfBody();
            if (!isBody || x < 0)
                scene.samples.emplace_back(x, y, z);
            if (!isBody || x > 0)
                scene.samples.emplace_back(legs.gap + x, y, z);
        }
        if (z > legs.bottomOfBody())
            for (Scalar x = 0; x <= legs.gap; x += step) {
                scene.samples.emplace_back(x, legs.radius, z);
                scene.samples.emplace_back(x, -legs.radius, z);
            }
    }
}

/// A mesh that has no free slots.
inline void addMesh(Scene &scene, const NeuralMesh &mesh)
{
    const auto first = static_cast<VertexId>(scene.points.size());
    forEachVertex(mesh, [&](VertexId v) { scene.points.push_back(mesh.position(v)); });
    forEachFace(mesh, [&](VertexId v, VertexId a, VertexId b) {
        scene.faces.push_back({{first + v, first + a, first + b}});
    });
}

/// The mesh's vertices and the middles of its edges.
inline void addSamplesOf(Scene &scene, const NeuralMesh &mesh)
{
    forEachVertex(mesh, [&](VertexId v) { scene.samples.push_back(mesh.position(v)); });
    forEachEdge(mesh, [&](VertexId v, VertexId u) {
        scene.samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    });
}

/// A torus of 1,000 vertices, well away: webs are looked for in networks of that size.
inline void addTorusAside(Scene &scene)
{
    NeuralMesh torus;
    makeTorus(torus, 40, 25);
    for (VertexId v = 0; v < torus.idBound(); ++v)
        torus.position(v) = torus.position(v) / 2 + Point3(0, 10, 0);
    addMesh(scene, torus);
    addSamplesOf(scene, torus);
}

/// Around the scene's mesh and samples.
inline Box3 boundsOf(const Scene &scene)
{
    Box3 bounds;
    for (const Point3 &p : scene.points)
        bounds.Add(p);
    for (const Point3 &p : scene.samples)
        bounds.Add(p);
    return bounds;
}

/// Step 6 on the scene's network, in which every vertex has won. `mesh` is what it makes of it.
/// Returns how many webs were removed.
inline int collapseInactive(NeuralMesh &mesh, const Scene &scene)
{
    makeMesh(mesh, scene.points, scene.faces);
    const Box3 bounds = boundsOf(scene);
    GrowingNetwork network(mesh, bounds, GrowthParameters{});
    network.collapse({}, SampleSupport(bounds, scene.samples));
    return network.websRemoved();
}

/// How far the furthest place of the mesh is from all samples: of the middles of faces and edges.
inline Scalar furthestFromSamples(const NeuralMesh &mesh, const Scene &scene)
{
    Box3 bounds;
    for (const Point3 &p : scene.samples)
        bounds.Add(p);
    const SampleSupport support(bounds, scene.samples);
    Scalar furthest = 0;
    forEachFace(mesh, [&](VertexId v, VertexId u, VertexId w) {
        const Point3 &a = mesh.position(v);
        const Point3 &b = mesh.position(u);
        const Point3 &c = mesh.position(w);
        for (const Point3 &place : {(a + b) / 2, (b + c) / 2, (c + a) / 2, (a + b + c) / 3})
            furthest = std::max(furthest, std::sqrt(support.squaredDistance(place)));
    });
    return furthest;
}

/// How far the mesh is from the place.
inline Scalar distanceFromMesh(const NeuralMesh &mesh, const Point3 &place)
{
    Scalar least = std::numeric_limits<Scalar>::infinity();
    forEachVertex(mesh, [&](VertexId v) {
        least = std::min(least, projectOnStar(mesh, v, place).squaredDistance);
    });
    return std::sqrt(least);
}

} // namespace neuralmesh::test
