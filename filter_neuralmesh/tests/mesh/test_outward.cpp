// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/outward.h"

#include <gtest/gtest.h>

#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_topology.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

/// Octahedra of these sizes and places, each turned round where it says so.
struct Octahedron {
    Point3 centre;
    double radius;
    bool isTurned;
};

void makeOctahedra(NeuralMesh &mesh, const std::vector<Octahedron> &octahedra)
{
    NeuralMesh one;
    test::makeOctahedron(one);
    std::vector<Point3> points;
    std::vector<Corners> faces;
    for (const Octahedron &octahedron : octahedra) {
        const auto first = static_cast<VertexId>(points.size());
        for (VertexId v = 0; v < 6; ++v)
            points.push_back(octahedron.centre + one.position(v) * octahedron.radius);
        forEachFace(one, [&](VertexId a, VertexId b, VertexId c) {
            if (octahedron.isTurned)
                std::swap(b, c);
            faces.push_back({first + a, first + b, first + c});
        });
    }
    test::makeMesh(mesh, points, faces);
}

std::vector<double> volumesOf(const NeuralMesh &mesh)
{
    return signedVolumes(mesh, labelComponents(mesh));
}

TEST(Outward, each_component_is_turned_by_itself)
{
    // Together they have a volume above 0.
    NeuralMesh mesh;
    makeOctahedra(mesh, {{{0, 0, 0}, 2, false}, {{9, 0, 0}, 1, true}, {{0, 9, 0}, 1, false}});
    orientOutwards(mesh);
    validate(mesh);
    for (const double volume : volumesOf(mesh))
        EXPECT_GT(volume, 0);
}

TEST(Outward, the_wall_of_a_cavity_looks_into_it)
{
    // A solid in a cavity in a solid, whichever way they were.
    for (int turned = 0; turned < 8; ++turned) {
        NeuralMesh mesh;
        makeOctahedra(mesh, {{{0, 0, 0}, 3, (turned & 1) != 0},
                             {{0, 0, 0}, 2, (turned & 2) != 0},
                             {{0, 0, 0}, 1, (turned & 4) != 0}});
        orientOutwards(mesh);
        const std::vector<double> volumes = volumesOf(mesh);
        EXPECT_GT(volumes[0], 0);
        EXPECT_LT(volumes[1], 0);
        EXPECT_GT(volumes[2], 0);
    }
}

TEST(Outward, a_mesh_far_from_the_origin_is_as_one_near_it)
{
    // As small as rounding makes a sum about the origin of either sign.
    for (int place = 1; place <= 10; ++place)
        for (const bool isTurned : {false, true}) {
            NeuralMesh mesh;
            const Point3 centre(1234567.1 / place, -2345678.9 * place, 3141592.7 + place);
            makeOctahedra(mesh, {{centre, 1e-4, isTurned}});
            orientOutwards(mesh);
            EXPECT_NEAR(signedVolume(mesh) / (4e-12 / 3), 1, 1e-3);
        }
}

TEST(Outward, an_open_component_keeps_its_way_round)
{
    NeuralMesh mesh;
    test::makeSquare(mesh, 3);
    const NeighbourRing ring = mesh.ring(0);
    orientOutwards(mesh);
    EXPECT_TRUE(std::equal(ring.begin(), ring.end(), mesh.ring(0).begin()));
}

} // namespace
} // namespace neuralmesh
