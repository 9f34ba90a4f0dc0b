// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers.h"

#include <cmath>

#include "core/mesh/manifold_mesh.h"
#include "core/space/plain_points.h"
#include "neuralmesh/errors.h"

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

const MeshModel &startLayer(const MeshDocument &document, unsigned int id)
{
    const MeshModel *layer = document.getMesh(id);
    if (layer == nullptr)
        throw neuralmesh::InvalidInput("StartMesh is a layer, but StartLayer names none.");
    return *layer;
}

std::vector<neuralmesh::Point> worldPoints(const MeshModel &layer)
{
    const vcg::Matrix44d matrix = matrixOf(layer);
    std::vector<neuralmesh::Point> points;
    points.reserve(static_cast<std::size_t>(layer.cm.vn));
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD())
            points.push_back(neuralmesh::toPlain(matrix * vcg::Point3d::Construct(vertex.cP())));
    return points;
}

std::vector<neuralmesh::Corners> faceCorners(const MeshModel &layer)
{
    std::vector<neuralmesh::VertexId> places(layer.cm.vert.size(), neuralmesh::noVertex);
    neuralmesh::VertexId place = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!layer.cm.vert[i].IsD())
            places[i] = place++;
    std::vector<neuralmesh::Corners> faces;
    faces.reserve(static_cast<std::size_t>(layer.cm.fn));
    for (const CFaceO &face : layer.cm.face) {
        if (face.IsD())
            continue;
        neuralmesh::Corners corners;
        for (int c = 0; c < 3; ++c)
            corners[static_cast<std::size_t>(c)] = places[vcg::tri::Index(layer.cm, face.cV(c))];
        faces.push_back(corners);
    }
    return faces;
}

std::vector<double> vertexQualities(const MeshModel &layer)
{
    if (!layer.hasDataMask(MeshModel::MM_VERTQUALITY))
        throw neuralmesh::InvalidInput("DensityFromQuality: layer '" + layer.label().toStdString() +
                                       "' has no vertex quality. Compute one first.");
    std::vector<double> qualities;
    qualities.reserve(static_cast<std::size_t>(layer.cm.vn));
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD())
            qualities.push_back(static_cast<double>(vertex.cQ()));
    return qualities;
}

void makeStartingMesh(neuralmesh::NeuralMesh &mesh, const MeshModel &layer,
                      const neuralmesh::UnitFrame &frame)
{
    std::vector<neuralmesh::Point3> points;
    for (const neuralmesh::Point &p : worldPoints(layer)) {
        if (!std::isfinite(neuralmesh::toVcg(p).SquaredNorm()))
            throw neuralmesh::InvalidInput("The starting layer has coordinates that are NaN, "
                                           "infinite or too large.");
        points.push_back(neuralmesh::toVcg(frame.toUnit(p)));
    }
    neuralmesh::makeManifold(mesh, points, faceCorners(layer));
}

QString nameOf(const MeshModel &layer)
{
    QString name = QFileInfo(layer.label()).completeBaseName();
    if (name.isEmpty())
        name = layer.label();
    return withoutDots(name);
}

QString withoutDots(QString name)
{
    return name.replace('.', '_');
}

MeshModel &addLayer(MeshDocument &document, const neuralmesh::NeuralMesh &network,
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
        vertex->P() = Point3m::Construct(neuralmesh::toWorld(frame, network.vert[id].cP()));
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
    return *document.addNewMesh(mesh, label, true);
}
