// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/web_removal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/mesh/enumeration.h"
#include "core/mesh/mesh_checks.h"
#include "core/mesh/ring_surgery.h"
#include "core/mesh/ring_topology.h"
#include "core/network/star_projection.h"
#include "core/topology/owned_samples.h"
#include "core/topology/unsupported_patches.h"
#include "tests/meshes_for_tests.h"

namespace neuralmesh {
namespace {

constexpr VertexId places = 8; ///< vertices of a level

/// Two posts joined by a web of one face's width in front and at the back, so many levels high and
/// closed at top and bottom. The posts' inner walls are missing.
void makeWeb(NeuralMesh &mesh, Scalar gap, VertexId levels = 6)
{
    const Scalar loop[places][2] = {{1, -0.4}, {0, -1},        {-1, 0},      {0, 1},
                                    {1, 0.4},  {1 + gap, 0.4}, {3 + gap, 0}, {1 + gap, -0.4}};
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    for (VertexId level = 0; level < levels; ++level)
        for (const auto &[x, y] : loop)
            points.emplace_back(x, y, static_cast<Scalar>(level));
    const auto at = [](VertexId level, VertexId place) { return level * places + place % places; };
    // Clockwise seen from above, so each face looks outwards with its corners in this order.
    for (VertexId level = 0; level + 1 < levels; ++level)
        for (VertexId place = 0; place < places; ++place) {
            faces.push_back({{at(level, place), at(level + 1, place), at(level, place + 1)}});
            faces.push_back(
                {{at(level, place + 1), at(level + 1, place), at(level + 1, place + 1)}});
        }
    for (VertexId place = 1; place + 1 < places; ++place) {
        faces.push_back({{at(0, 0), at(0, place), at(0, place + 1)}});
        faces.push_back({{at(levels - 1, 0), at(levels - 1, place + 1), at(levels - 1, place)}});
    }
    test::makeMesh(mesh, points, faces);
}

/// Samples everywhere on the faces whose corners are all on one side of the gap, on the walls
/// between front and back, where there are no faces, and on the top, which joins the posts.
SampleSupport supportOfPosts(const NeuralMesh &mesh, Scalar gap, VertexId levels = 6)
{
    constexpr int steps = 8;
    const auto top = static_cast<Scalar>(levels - 1);
    std::vector<Point3> samples;
    const auto sampleTriangle = [&](const Point3 &a, const Point3 &b, const Point3 &c) {
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j)
                samples.push_back(a + (b - a) * i / steps + (c - a) * j / steps);
    };
    const FaceTable faces(mesh);
    for (FaceId face = 0; face < faces.size(); ++face) {
        const Corners &c = faces.corners(face);
        const auto isLeft = [&](VertexId v) { return mesh.position(v).X() < 1 + gap / 2; };
        const auto isOnTop = [&](VertexId v) { return mesh.position(v).Z() == top; };
        const bool isTop = isOnTop(c[0]) && isOnTop(c[1]) && isOnTop(c[2]);
        if (isTop || (isLeft(c[0]) == isLeft(c[1]) && isLeft(c[1]) == isLeft(c[2])))
            sampleTriangle(mesh.position(c[0]), mesh.position(c[1]), mesh.position(c[2]));
    }
    for (const Scalar x : {Scalar(1), 1 + gap}) {
        sampleTriangle({x, -0.4, 0}, {x, 0.4, 0}, {x, 0.4, top});
        sampleTriangle({x, -0.4, 0}, {x, 0.4, top}, {x, -0.4, top});
    }
    Box3 bounds;
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    return SampleSupport(bounds, samples);
}

/// The patch that a search finds first.
std::optional<Patch> firstPatch(PatchSearch &search)
{
    FaceId seed = 0;
    while (!search.isSeed(seed))
        ++seed;
    return search.find(seed, PatchExtent::core);
}

/// That of the web between the posts.
struct FoundWeb {
    NeuralMesh mesh;
    SampleSupport support;
    FaceTable faces;
    RefusedPatches refused;
    PatchSearch search;
    std::optional<Patch> patch;

    FoundWeb()
        : support(makeWebAndSupport(mesh)), faces(mesh), refused(mesh),
          search(mesh, faces, support, refused), patch(firstPatch(search))
    {
    }

    static SampleSupport makeWebAndSupport(NeuralMesh &mesh)
    {
        constexpr Scalar gap = 4;
        makeWeb(mesh, gap);
        return supportOfPosts(mesh, gap);
    }
};

std::vector<Refilling> findWebs(const NeuralMesh &mesh, const SampleSupport &support)
{
    RefusedPatches none(mesh);
    return neuralmesh::findWebs(mesh, support, none);
}

TEST(WebRemoval, refilling_a_web_leaves_a_closed_two_manifold_of_the_same_topology)
{
    constexpr Scalar gap = 4;
    NeuralMesh mesh;
    makeWeb(mesh, gap);
    validate(mesh);
    const std::vector<Refilling> webs = findWebs(mesh, supportOfPosts(mesh, gap));
    ASSERT_EQ(webs.size(), 1U);
    refillDisc(mesh, webs[0].rim, webs[0].interior, webs[0].triangles);
    validate(mesh);
    const TopologyFigures topology = measureTopology(mesh);
    EXPECT_EQ(topology.genus, 0);
    EXPECT_EQ(topology.components, 1);
}

TEST(WebRemoval, a_rim_that_takes_too_long_to_fill_stays)
{
    // Both webs have as good a filling. Of the higher one, the rim has nearly half of all vertices.
    constexpr Scalar gap = 4;
    for (const VertexId levels : {6U, 24U}) {
        NeuralMesh mesh;
        makeWeb(mesh, gap, levels);
        const std::vector<Refilling> webs = findWebs(mesh, supportOfPosts(mesh, gap, levels));
        EXPECT_EQ(webs.size(), levels == 6 ? 1U : 0U);
    }
}

TEST(WebRemoval, a_mesh_on_its_samples_stays_as_it_is)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 30, 12);
    std::vector<Point3> samples;
    Box3 bounds;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        samples.push_back(mesh.position(v));
        bounds.Add(mesh.position(v));
        for (const VertexId u : mesh.ring(v))
            samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    }
    EXPECT_TRUE(findWebs(mesh, SampleSupport(bounds, samples)).empty());
}

/// A limb that too few samples show is not cut off: samples at its tip would be missed.
TEST(WebRemoval, a_spike_with_a_sample_at_its_tip_stays)
{
    NeuralMesh mesh;
    test::makeTorus(mesh, 30, 12);
    std::vector<Point3> samples;
    Box3 bounds;
    for (VertexId v = 0; v < mesh.idBound(); ++v) {
        samples.push_back(mesh.position(v));
        for (const VertexId u : mesh.ring(v))
            samples.push_back((mesh.position(v) + mesh.position(u)) / 2);
    }
    mesh.position(0) = mesh.position(0) * 2;
    samples.push_back(mesh.position(0));
    for (const Point3 &sample : samples)
        bounds.Add(sample);
    EXPECT_TRUE(findWebs(mesh, SampleSupport(bounds, samples)).empty());
}

TEST(PatchSearch, finds_the_two_sheets_and_the_rim_of_a_web_as_one_disc)
{
    FoundWeb web;
    ASSERT_TRUE(web.patch);
    EXPECT_TRUE(web.patch->interior.empty());
    EXPECT_EQ(web.patch->faces.size() + 2,
              web.patch->rim.size()); // a disc without interior vertices
    web.search.release(*web.patch);
    for (const FaceId face : web.patch->faces)
        EXPECT_FALSE(web.search.isSeed(face)) << "it is found once";
}

/// Two square sides of a wall and the faces between them all around, as far apart as `thickness`.
void makePlate(NeuralMesh &mesh, VertexId size, Scalar thickness)
{
    std::vector<Point3> points;
    std::vector<test::Triangle> faces;
    for (const Scalar z : {Scalar(0), thickness})
        for (VertexId j = 0; j < size; ++j)
            for (VertexId i = 0; i < size; ++i)
                points.emplace_back(i, j, z);
    const VertexId other = size * size; // from a vertex to that behind it
    const auto at = [&](VertexId i, VertexId j) { return j * size + i; };
    const auto quad = [&](VertexId a, VertexId b, VertexId c, VertexId d) {
        faces.push_back({{a, b, c}});
        faces.push_back({{a, c, d}});
    };
    const auto wall = [&](VertexId a, VertexId b) { quad(a, b, b + other, a + other); };
    const VertexId last = size - 1;
    for (VertexId k = 0; k < last; ++k) {
        wall(at(k, 0), at(k + 1, 0));
        wall(at(last, k), at(last, k + 1));
        wall(at(k + 1, last), at(k, last));
        wall(at(0, k + 1), at(0, k));
        for (VertexId i = 0; i < last; ++i) {
            const VertexId a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1), d = at(i, k + 1);
            quad(a, d, c, b);
            quad(a + other, b + other, c + other, d + other);
        }
    }
    test::makeMesh(mesh, points, faces);
}

/// Samples of its sides, and of a piece of one edge.
constexpr VertexId sizeOfPlate = 14;
constexpr Scalar thickness = 2.5;
std::vector<Point3> samplesOfPlate(VertexId size = sizeOfPlate)
{
    constexpr Scalar step = 0.25;
    std::vector<Point3> samples;
    for (const Scalar z : {Scalar(0), thickness})
        for (Scalar x = 0; x <= size - 1; x += step)
            for (Scalar y = 0; y <= size - 1; y += step)
                samples.emplace_back(x, y, z);
    for (Scalar z = 0; z <= thickness; z += step)
        for (Scalar x = 0; x <= 3; x += step)
            samples.emplace_back(x, 0, z);
    return samples;
}

/// A wall of which, besides its sides, a piece of one edge was scanned. What fills its rim along
/// the samples lies on the sides, which are there.
TEST(WebRemoval, a_wall_that_was_not_scanned_stays)
{
    NeuralMesh mesh;
    makePlate(mesh, sizeOfPlate, thickness);
    validate(mesh);
    const Box3 bounds({0, 0, 0}, {sizeOfPlate - 1, sizeOfPlate - 1, thickness});
    EXPECT_TRUE(findWebs(mesh, SampleSupport(bounds, samplesOfPlate())).empty());
}

int seedsOf(const NeuralMesh &mesh, const SampleSupport &support, const RefusedPatches &refused)
{
    const FaceTable faces(mesh);
    const PatchSearch search(mesh, faces, support, refused);
    int seeds = 0;
    for (FaceId face = 0; face < faces.size(); ++face)
        seeds += search.isSeed(face) ? 1 : 0;
    return seeds;
}

/// What stays is looked at again only where the mesh has moved.
TEST(RefusedPatches, a_wall_that_stays_is_searched_once_until_it_moves)
{
    NeuralMesh mesh;
    constexpr VertexId size = 8;
    makePlate(mesh, size, thickness);
    const SampleSupport support({{0, 0, 0}, {size - 1, size - 1, thickness}}, samplesOfPlate(size));
    RefusedPatches refused(mesh);
    EXPECT_GT(seedsOf(mesh, support, refused), 0);
    neuralmesh::findWebs(mesh, support, refused);
    EXPECT_EQ(seedsOf(mesh, support, refused), 0);

    // In the middle of the edge opposite to the piece that was scanned.
    const VertexId onRim = size * (size - 1) + size / 2;
    mesh.position(onRim).Y() += Scalar(0.1);
    EXPECT_EQ(seedsOf(mesh, support, refused), 0) << "a sample's pull";
    mesh.position(onRim).Y() += Scalar(0.9);
    const int seeds = seedsOf(mesh, support, refused);
    EXPECT_GT(seeds, 0);
    EXPECT_LE(seeds, mesh.valence(onRim));
}

/// Outside the edge where a side and the unscanned wall meet, one is as near as the other.
TEST(OwnedSamples, of_a_patch_are_those_beyond_its_rim_too)
{
    NeuralMesh mesh;
    makePlate(mesh, sizeOfPlate, thickness);
    std::vector<Point3> samples = samplesOfPlate();
    const std::size_t beyond = samples.size();
    for (Scalar x = 5; x < sizeOfPlate - 2; x += 0.07)
        for (const Scalar z : {Scalar(-0.2), thickness + Scalar(0.2)})
            samples.emplace_back(x, -0.3, z);
    const Box3 bounds({0, -1, -1}, {sizeOfPlate - 1, sizeOfPlate - 1, thickness + 1});
    const SampleSupport support(bounds, samples);
    const FaceTable faces(mesh);
    const RefusedPatches refused(mesh);
    PatchSearch search(mesh, faces, support, refused);
    const std::optional<Patch> wall = firstPatch(search);
    ASSERT_TRUE(wall);
    OwnedSamples owned(mesh, faces, support);
    for (auto sample = static_cast<SampleId>(beyond); sample < samples.size(); ++sample)
        EXPECT_TRUE(owned.squaredDistance(sample, search)) << sample - beyond;
    EXPECT_GE(owned.count(*wall, search), samples.size() - beyond);
}

/// Those of the walls that are missing: of no other is the web the nearest.
TEST(OwnedSamples, of_a_web_are_nearest_to_its_faces)
{
    FoundWeb web;
    ASSERT_TRUE(web.patch);
    const std::vector<Point3> &samples = web.support.samples();
    OwnedSamples owned(web.mesh, web.faces, web.support);
    std::size_t count = 0;
    std::size_t others = 0;
    for (SampleId sample = 0; sample < samples.size(); ++sample) {
        Scalar toWeb = std::numeric_limits<Scalar>::max();
        Scalar beside = toWeb;
        for (FaceId face = 0; face < web.faces.size(); ++face) {
            const Corners &c = web.faces.corners(face);
            Scalar &least = web.search.contains(face) ? toWeb : beside;
            least =
                std::min(least, squaredDistanceTo({web.mesh.position(c[0]), web.mesh.position(c[1]),
                                                   web.mesh.position(c[2])},
                                                  samples[sample]));
        }
        const std::optional<Scalar> found = owned.squaredDistance(sample, web.search);
        count += found ? 1 : 0;
        if (toWeb < beside * (1 - 1e-9)) {
            ASSERT_TRUE(found) << sample;
            EXPECT_GE(*found, toWeb * (1 - 1e-9)) << sample;
        } else if (beside < toWeb * (1 - 1e-9)) {
            others += found ? 1 : 0;
        }
    }
    // A nearer face may be one that the nearest vertex is no corner of.
    EXPECT_GT(count, 0U);
    EXPECT_LE(others, count / 20);
    EXPECT_EQ(owned.count(*web.patch, web.search), count);
}

} // namespace
} // namespace neuralmesh
