// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/topology/filling_cost.h"

#include <gtest/gtest.h>

#include <cmath>

#include "neuralmesh/random.h"

namespace neuralmesh {
namespace {

/// A loop of vertices around the origin, each off the plane by up to the height; its fan covers it.
std::vector<VertexId> makeLoop(NeuralMesh &mesh, Scalar height)
{
    constexpr int corners = 24;
    Random random(3);
    std::vector<VertexId> loop;
    for (int i = 0; i < corners; ++i) {
        const Scalar angle = 2 * M_PI * i / corners;
        const Scalar z = height * (2 * random.unit() - 1);
        loop.push_back(mesh.addVertex({std::cos(angle), std::sin(angle), z}));
    }
    return loop;
}

std::vector<Corners> fanOf(const std::vector<VertexId> &loop)
{
    std::vector<Corners> faces;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        faces.push_back({loop.front(), loop[i], loop[i + 1]});
    return faces;
}

TEST(FillingCost, no_filling_is_smaller_than_the_loops_vector_area)
{
    const SampleSupport support(Box3({-1, -1, -1}, {1, 1, 1}), {Point3(0, 0, 0)});
    for (const Scalar height : {0.0, 0.1, 1.0}) {
        NeuralMesh mesh;
        const std::vector<VertexId> loop = makeLoop(mesh, height);
        const FillingCost cost(mesh, support, loop);
        const double fan = cost.sizeInFaces(fanOf(loop));
        EXPECT_LE(cost.leastSizeInFaces(loop), fan * (1 + 1e-12)) << height;
        if (height == 0) {
            EXPECT_NEAR(cost.leastSizeInFaces(loop), fan, 1e-9);
        }
    }
}

} // namespace
} // namespace neuralmesh
