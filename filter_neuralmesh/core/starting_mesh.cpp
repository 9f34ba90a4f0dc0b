// SPDX-License-Identifier: GPL-3.0-or-later
#include "starting_mesh.h"

#include <cmath>

#include "ring_topology.h"

namespace neuralmesh {

void makeTetrahedron(NeuralMesh& mesh, const Point3& centre, Scalar circumradius)
{
    // Every other corner of a cube.
    static constexpr int corners[4][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    static constexpr VertexId rings[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    mesh.Clear();
    std::vector<VertexId> noFreeSlots;
    const Scalar halfEdge = circumradius / std::sqrt(Scalar(3));
    for (const auto& corner : corners)
        addVertex(mesh, noFreeSlots,
                  centre + Point3(corner[0], corner[1], corner[2]) * halfEdge);
    for (VertexId v = 0; v < 4; ++v)
        for (const VertexId u : rings[v])
            mesh.ring(v).pushBack(u);
}

} // namespace neuralmesh
