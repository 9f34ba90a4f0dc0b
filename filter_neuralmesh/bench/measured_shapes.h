// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes by which constants are judged, and how far a mesh is from one.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "neuralmesh/geometry.h"
#include "neuralmesh/parameters.h"
#include "neuralmesh/sampler.h"
#include "tests/shapes_for_tests.h"

namespace neuralmesh::bench {

/// What is reconstructed, and what it should become.
struct Target {
    test::Shape shape;
    test::WorldPoints clean; ///< points of the shape, those that are seen
    std::function<std::unique_ptr<Sampler>()> sampler;
    GrowthParameters parameters;
    /// Then the mesh is closed where nothing is known of the shape.
    bool isSeenFromOneSide = false;
};

struct MeasuredShape {
    std::string name;
    std::function<Target(std::uint64_t seed)> make;
};

/// Fingers, fins, creases, balls, a thin plate; clean and noisy (standard deviation of each
/// coordinate, per cent of the diagonal, behind the name), sparse, among outliers, from one side,
/// open, and by formulas.
const std::vector<MeasuredShape> &measuredShapes();

test::WorldFaces facesOf(const Mesh &mesh);

/// Of the bounding box.
double diagonalOf(const test::WorldPoints &points);

} // namespace neuralmesh::bench
