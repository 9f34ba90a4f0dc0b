// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes bit for bit as they were: a change that was not meant shows here.
//
// Where a change is meant, a test that fails prints the new hash, which takes the old one's place.
// The hashes are of double precision without fused multiply-add, as on x86-64 by our flags; they
// are the same for g++ and clang++, with and without optimisation and sanitizers, on Windows, and
// for any number of threads. That is tested where this is built: by release, asan-ubsan, clang,
// debug and mingw.
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "core/growth.h"
#include "samplers/points/point_cloud_sampler.h"
#include "tests/points_for_tests.h"

namespace neuralmesh {
namespace {

using test::WorldPoints;

/// FNV-1a over 64-bit words.
class Hash {
public:
    void add(std::uint64_t word)
    {
        for (int byte = 0; byte < 8; ++byte)
            value_ = (value_ ^ ((word >> (8 * byte)) & 0xffU)) * 0x100000001b3ULL;
    }
    void add(double number)
    {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        add(bits);
    }

    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

/// Of the corners' positions and the triangles, in their order.
std::uint64_t hashOf(const NeuralMesh &mesh)
{
    Hash hash;
    for (const NeuralVertex &vertex : mesh.vert)
        for (int axis = 0; axis < 3 && !vertex.IsD(); ++axis)
            hash.add(vertex.cP()[axis]);
    for (const NeuralFace &face : mesh.face)
        for (int corner = 0; corner < 3; ++corner)
            hash.add(static_cast<std::uint64_t>(face.cV(corner) - mesh.vert.data()));
    return hash.value();
}

std::string inHex(std::uint64_t number)
{
    char text[20];
    std::snprintf(text, sizeof text, "0x%016llx", static_cast<unsigned long long>(number));
    return text;
}

void expectHash(const WorldPoints &points, GrowthParameters parameters, const char *expected)
{
    const PointCloudSampler sampler(points);
    for (const int threads : {1, 3, 8}) {
        parameters.threads = threads;
        NeuralMesh mesh;
        grow(mesh, sampler, parameters);
        EXPECT_EQ(inHex(hashOf(mesh)), expected) << threads << " threads";
    }
}

GrowthParameters withTarget(int target)
{
    GrowthParameters parameters;
    parameters.targetVertexCount = target;
    parameters.topology = Topology::ofStart;
    return parameters;
}

/// Points in the shell between two ellipsoids, without the C library's functions, which differ from
/// place to place. Those with y below `cut` are left out.
WorldPoints ellipsoid(std::size_t count, double thickness, double cut = -2)
{
    Random random(5);
    WorldPoints points;
    while (points.size() < count) {
        vcg::Point3d p = test::inUnitCube(random) * 2 - vcg::Point3d(1, 1, 1);
        const double length = p.Norm();
        if (length > 1 || length < 0.1)
            continue;
        p = p / length * (1 + thickness * (random.unit() - 0.5));
        if (p.Y() > cut)
            points.emplace_back(2 * p.X(), p.Y(), 0.3 * p.Z());
    }
    return points;
}

TEST(GoldenMeshes, by_default)
{
    expectHash(ellipsoid(5000, 0), withTarget(500), "0x6a4b4952c0566125");
}

TEST(GoldenMeshes, as_in_the_paper)
{
    GrowthParameters parameters = withTarget(500);
    parameters.splitRule = SplitRule::paper;
    parameters.edgeFlips = false;
    parameters.surfaceFit = false;
    parameters.startMesh = StartMesh::icosahedron;
    expectHash(ellipsoid(5000, 0), parameters, "0x2b4d9f746ac08b59");
}

/// Large enough for webs to be looked for.
TEST(GoldenMeshes, from_noise)
{
    GrowthParameters parameters = withTarget(1200);
    parameters.seed = 2;
    expectHash(ellipsoid(10000, 0.1), parameters, "0xaed293965e07798f");
}

TEST(GoldenMeshes, from_a_scan_of_one_side)
{
    expectHash(ellipsoid(5000, 0.01, 0.1), withTarget(1000), "0x3778ff2c845251b1");
}

TEST(GoldenMeshes, from_the_data)
{
    GrowthParameters parameters = withTarget(700);
    parameters.topology = Topology::learned;
    expectHash(ellipsoid(5000, 0), parameters, "0x5c414d1eacadfeb6");
}

} // namespace
} // namespace neuralmesh
