// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/neural_mesh.h"
#include "core/mesh/triangle.h"

namespace neuralmesh {

/// The point nearest to a query on one of the faces around a vertex.
struct StarProjection {
    VertexId corners[3];    ///< of the face; the first is the vertex whose star was searched
    Scalar weights[3];      ///< barycentric coordinates of the point, in the order of the corners
    Point3 residual;        ///< from the point to the query
    Scalar squaredDistance; ///< of the query to the point
};

/// Looks at every face in the star of v. Ericson, Real-Time Collision Detection (2005), §5.1.5.
StarProjection projectOnStar(const NeuralMesh &mesh, VertexId v, const Point3 &query);

/// Squared distance of the query to the nearest point of a triangle.
Scalar squaredDistanceTo(const Triangle &triangle, const Point3 &query);

} // namespace neuralmesh
