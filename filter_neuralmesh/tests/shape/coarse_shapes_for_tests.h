// SPDX-License-Identifier: GPL-3.0-or-later
// The coarse shape of points, checked to be what it says of itself.
#pragma once

#include <gtest/gtest.h>

#include "core/mesh/mesh_checks.h"
#include "core/shape/coarse_shape.h"
#include "tests/shape/inputs_for_tests.h"

namespace neuralmesh::test {

inline Workers alone; // threads change nothing: Growth.is_the_same_for_any_number_of_threads

/// No gap is wider.
inline constexpr double noHole = 100;
inline constexpr int vertices = 200;

inline CoarseShape shapeOf(const Points &points, NeuralMesh &mesh, double hole = noHole)
{
    const CoarseShape shape = findCoarseShape(mesh, points, points.size(), vertices, hole, alone);
    validate(mesh);
    const TopologyFigures figures = measureTopology(mesh);
    EXPECT_EQ(figures.components, shape.components);
    EXPECT_EQ(figures.genus, shape.genus);
    EXPECT_EQ(figures.boundaryLoops, shape.openings);
    return shape;
}

inline void expectShape(const Points &points, int components, int genus)
{
    NeuralMesh mesh;
    const CoarseShape shape = shapeOf(points, mesh);
    EXPECT_TRUE(shape.isTrusted);
    EXPECT_FALSE(shape.isSheet);
    EXPECT_EQ(shape.components, components);
    EXPECT_EQ(shape.genus, genus);
    EXPECT_LT(shape.unsupportedShare, 0.01);
    EXPECT_EQ(shape.missedShare, 0);
}

} // namespace neuralmesh::test
