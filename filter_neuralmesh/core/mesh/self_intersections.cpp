// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/self_intersections.h"

#include <algorithm>

#include <vcg/complex/algorithms/clean.h>

#include "core/mesh/ring_topology.h"

namespace neuralmesh {

std::vector<VertexId> findIntersectingVertices(NeuralMesh &mesh)
{
    rebuildFaces(mesh);
    std::vector<NeuralFace *> faces;
    vcg::tri::Clean<NeuralMesh>::SelfIntersections(mesh, faces);
    std::vector<VertexId> corners;
    for (const NeuralFace *face : faces)
        for (int corner = 0; corner < 3; ++corner)
            corners.push_back(static_cast<VertexId>(vcg::tri::Index(mesh, face->cV(corner))));
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

} // namespace neuralmesh
