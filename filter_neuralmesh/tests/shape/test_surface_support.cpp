// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shape/surface_support.h"

#include <gtest/gtest.h>

#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh {
namespace {

/// Right triangles in the plane z = 0, of legs of 3, 3 and 6, with their centres on the x axis at
/// 0, 10 and 20.
TriangleSoup threeTriangles()
{
    TriangleSoup soup;
    for (VertexId i = 0; i < 3; ++i) {
        const double leg = i == 2 ? 6 : 3;
        const Point3 corner(10.0 * i - leg / 3, -leg / 3, 0);
        soup.points.push_back(corner);
        soup.points.push_back(corner + Point3(leg, 0, 0));
        soup.points.push_back(corner + Point3(0, leg, 0));
        soup.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return soup;
}

TEST(SurfaceSupport, the_area_is_that_of_all_faces)
{
    EXPECT_DOUBLE_EQ(areaOf(threeTriangles()), 4.5 + 4.5 + 18);
    EXPECT_EQ(areaOf({}), 0);
}

TEST(SurfaceSupport, of_a_face_is_by_the_distance_of_its_centre_from_the_nearest_point)
{
    // Points over the centres, but the last: it is at a corner, which counts no more than any
    // other place.
    const test::Points points{{0, 0, 0.9}, {10, 0, 1.1}, {24, -2, 0}};
    const SurfaceSupport support = measureSupport(threeTriangles(), points, {1, 2});
    EXPECT_EQ(support.ofFace,
              (std::vector<Support>{Support::near, Support::notNear, Support::far}));
    EXPECT_DOUBLE_EQ(support.farShare, 18.0 / 27);
}

TEST(SurfaceSupport, no_face_is_far_where_there_is_none)
{
    const SurfaceSupport support = measureSupport({}, test::Points{{0, 0, 0}, {1, 1, 1}}, {1, 2});
    EXPECT_TRUE(support.ofFace.empty());
    EXPECT_EQ(support.farShare, 0);
}

} // namespace
} // namespace neuralmesh
