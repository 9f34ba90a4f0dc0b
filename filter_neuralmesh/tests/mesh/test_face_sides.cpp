// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/face_sides.h"

#include <gtest/gtest.h>

#include <tuple>

#include "neuralmesh/random.h"

namespace neuralmesh {
namespace {

using Key = std::tuple<VertexId, VertexId, FaceId, unsigned, bool>;

std::vector<Key> keysOf(const std::vector<FaceSide> &sides)
{
    std::vector<Key> keys;
    for (const FaceSide &s : sides)
        keys.emplace_back(s.low, s.high, s.face, s.corner, s.isRising);
    return keys;
}

TEST(FaceSides, come_together_at_the_edge_that_two_faces_share)
{
    //  3---2
    //  | / |
    //  0---1
    EXPECT_EQ(keysOf(sidesByEdge({{0, 1, 2}, {0, 2, 3}})), (std::vector<Key>{
                                                               {0, 1, 0, 0, true},
                                                               {0, 2, 0, 2, false},
                                                               {0, 2, 1, 0, true},
                                                               {0, 3, 1, 2, false},
                                                               {1, 2, 0, 1, true},
                                                               {2, 3, 1, 1, true},
                                                           }));
}

TEST(FaceSides, of_no_faces_are_none)
{
    EXPECT_TRUE(sidesByEdge({}).empty());
}

TEST(FaceSides, are_in_the_order_that_sorting_gives_whatever_the_faces)
{
    // Also faces that name a vertex twice, and edges of many faces: it is for others to refuse
    // them.
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        Random random(seed);
        std::vector<Corners> faces(200);
        std::vector<Key> expected;
        for (FaceId f = 0; f < faces.size(); ++f) {
            for (VertexId &corner : faces[f])
                corner = static_cast<VertexId>(random.below(20));
            for (unsigned c = 0; c < 3; ++c) {
                const VertexId a = faces[f][c];
                const VertexId b = faces[f][(c + 1) % 3];
                expected.emplace_back(std::min(a, b), std::max(a, b), f, c, a < b);
            }
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(keysOf(sidesByEdge(faces)), expected) << "seed " << seed;
    }
}

} // namespace
} // namespace neuralmesh
