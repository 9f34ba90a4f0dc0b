// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers.h"

#include "core/errors.h"

namespace {

vcg::Matrix44d matrixOf(const MeshModel &layer)
{
    vcg::Matrix44d matrix;
    matrix.Import(layer.cm.Tr);
    return matrix;
}

} // namespace

const MeshModel &currentLayer(const MeshDocument &document)
{
    const MeshModel *layer = document.mm();
    if (layer == nullptr)
        throw neuralmesh::InvalidInput(
            "There is no current layer: open or make a point cloud or a mesh first.");
    return *layer;
}

std::vector<vcg::Point3d> worldPoints(const MeshModel &layer)
{
    if (layer.cm.vn == 0)
        throw neuralmesh::InvalidInput("The current layer has no vertices.");
    const vcg::Matrix44d matrix = matrixOf(layer);
    std::vector<vcg::Point3d> points;
    points.reserve(static_cast<std::size_t>(layer.cm.vn));
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD())
            points.push_back(matrix * vcg::Point3d::Construct(vertex.cP()));
    return points;
}

QString resultLabel(const MeshModel &input)
{
    QString name = QFileInfo(input.label()).completeBaseName();
    if (name.isEmpty())
        name = input.label();
    return name.replace('.', '_') + " neural mesh";
}

void addLayer(MeshDocument &document, const neuralmesh::NeuralMesh &network,
              const neuralmesh::UnitFrame &frame, const QString &label)
{
    CMeshO mesh;
    std::vector<std::size_t> places(network.vert.size());
    auto vertex =
        vcg::tri::Allocator<CMeshO>::AddVertices(mesh, static_cast<std::size_t>(network.vn));
    std::size_t place = 0;
    for (std::size_t id = 0; id < network.vert.size(); ++id) {
        if (network.vert[id].IsD())
            continue;
        vertex->P() = Point3m::Construct(frame.toWorld(network.vert[id].cP()));
        ++vertex;
        places[id] = place++;
    }
    auto face = vcg::tri::Allocator<CMeshO>::AddFaces(mesh, static_cast<std::size_t>(network.fn));
    for (const neuralmesh::NeuralFace &source : network.face) {
        for (int corner = 0; corner < 3; ++corner)
            face->V(corner) = &mesh.vert[places[vcg::tri::Index(network, source.cV(corner))]];
        ++face;
    }
    // Updates the bounding box and the normals too.
    document.addNewMesh(mesh, label, true);
}
