// SPDX-License-Identifier: GPL-3.0-or-later
#include "starting_mesh.h"

#include <algorithm>
#include <cmath>

#include "point_statistics.h"
#include "ring_topology.h"

namespace neuralmesh {

void makeTetrahedron(NeuralMesh &mesh, const Point3 &centre, Scalar circumradius)
{
    // Every other corner of a cube.
    static constexpr int corners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    static constexpr VertexId rings[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    mesh.Clear();
    std::vector<VertexId> noFreeSlots;
    const Scalar halfEdge = circumradius / std::sqrt(Scalar(3));
    for (const auto &corner : corners)
        addVertex(mesh, noFreeSlots, centre + Point3(corner[0], corner[1], corner[2]) * halfEdge);
    for (VertexId v = 0; v < 4; ++v)
        for (const VertexId u : rings[v])
            mesh.ring(v).pushBack(u);
}

void makeTetrahedronIn(NeuralMesh &mesh, const std::vector<Point3> &samples)
{
    constexpr double leastDeviation = 0.01;
    PrincipalAxes frame = principalAxes(samples);
    if (frame.axes.determinant() < 0)
        frame.axes.col(0) *= -1;
    for (int i = 0; i < 3; ++i)
        frame.axes.col(i) *= std::max(std::sqrt(frame.variances[i]), leastDeviation);

    makeTetrahedron(mesh, {0, 0, 0}, std::sqrt(Scalar(3)));
    for (NeuralVertex &vertex : mesh.vert) {
        const Eigen::Vector3d corner = frame.mean + frame.axes * toEigen(vertex.cP());
        vertex.P() = Point3(corner[0], corner[1], corner[2]);
    }
}

} // namespace neuralmesh
