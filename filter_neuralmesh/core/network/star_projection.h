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

/// Whether the point lies on a boundary, as that of a query beyond the surface's edge does.
bool liesOnBoundary(const NeuralMesh &mesh, const StarProjection &p);

/// The residual, of which only what is normal to the face where the point lies on a boundary: how
/// far the query is beyond the surface's edge is no distance from the surface.
Point3 residualFromSurface(const NeuralMesh &mesh, const StarProjection &p);

/// Step 2, given the vertex nearest to a sample and the nearest point of the mesh: the nearest
/// vertex, or where that point is of another sheet or on a boundary, the nearest corner of its
/// face. See LearningRules.
VertexId winnerOf(const NeuralMesh &mesh, VertexId nearest, const StarProjection &p);

/// Squared distance of the query to the nearest point of a triangle.
Scalar squaredDistanceTo(const Triangle &triangle, const Point3 &query);

} // namespace neuralmesh
