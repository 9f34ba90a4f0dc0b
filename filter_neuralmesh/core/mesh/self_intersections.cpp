// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/self_intersections.h"

#include <algorithm>

#include <vcg/complex/algorithms/clean.h>

#include "core/mesh/ring_topology.h"

namespace neuralmesh {

SelfIntersections findSelfIntersections(NeuralMesh &mesh)
{
    rebuildFaces(mesh);
    std::vector<NeuralFace *> faces;
    vcg::tri::Clean<NeuralMesh>::SelfIntersections(mesh, faces);
    SelfIntersections found;
    found.faces = static_cast<int>(faces.size());
    std::vector<VertexId> &corners = found.corners;
    for (const NeuralFace *face : faces)
        for (int corner = 0; corner < 3; ++corner)
            corners.push_back(static_cast<VertexId>(vcg::tri::Index(mesh, face->cV(corner))));
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return found;
}

} // namespace neuralmesh
