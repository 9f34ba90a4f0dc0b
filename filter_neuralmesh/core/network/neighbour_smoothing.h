// SPDX-License-Identifier: GPL-3.0-or-later
// Step 3, second half (equations 3 to 5 of the paper): the winner's neighbours are smoothed within
// their tangent planes.
#pragma once

#include <vector>

#include "core/mesh/neural_mesh.h"

namespace neuralmesh {

/// On a boundary, where an umbrella would pull the surface in, a vertex is smoothed along the
/// boundary only.
class NeighbourSmoothing {
public:
    /// α_n, and how often the neighbours are smoothed.
    NeighbourSmoothing(Scalar rate, int passes) : rate_(rate), passes_(passes) {}

    struct Neighbour {
        Point3 position;
        Point3 sum;   ///< of the positions of its own neighbours, on a boundary those along it
        Point3 axis;  ///< normal of the surface; on a boundary its direction
        Point3 step;  ///< of the last pass
        Scalar share; ///< of one neighbour in the mean
        bool isOnBoundary;
    };

    /// The winner's neighbours in the order of its ring, with their new positions. The mesh stays
    /// as it is. Valid until the next call.
    const std::vector<Neighbour> &smooth(const NeuralMesh &mesh, VertexId winner);

private:
    void followSteps();
    void followStepsAtBoundary(const NeuralMesh &mesh, VertexId winner);

    Scalar rate_;
    int passes_;
    std::vector<Neighbour> neighbours_;
};

} // namespace neuralmesh
