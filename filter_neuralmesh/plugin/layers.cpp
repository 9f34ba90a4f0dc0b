// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers.h"

#include "neuralmesh/errors.h"
#include "parameter_names.h"

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
        throw neuralmesh::InvalidInput(named("StartMesh") + " is a layer, but " +
                                       named("StartLayer") + " names none.");
    return *layer;
}

std::vector<neuralmesh::Point> worldPoints(const MeshModel &layer)
{
    const vcg::Matrix44d matrix = matrixOf(layer);
    std::vector<neuralmesh::Point> points;
    points.reserve(static_cast<std::size_t>(layer.cm.vn));
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD()) {
            const vcg::Point3d p = matrix * vcg::Point3d::Construct(vertex.cP());
            points.push_back({p.X(), p.Y(), p.Z()});
        }
    return points;
}

neuralmesh::Mesh worldMesh(const MeshModel &layer)
{
    std::vector<neuralmesh::VertexId> places(layer.cm.vert.size());
    neuralmesh::VertexId place = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!layer.cm.vert[i].IsD())
            places[i] = place++;
    neuralmesh::Mesh mesh;
    mesh.positions = worldPoints(layer);
    mesh.triangles.reserve(static_cast<std::size_t>(layer.cm.fn));
    for (const CFaceO &face : layer.cm.face) {
        if (face.IsD())
            continue;
        neuralmesh::Corners corners;
        for (int c = 0; c < 3; ++c)
            corners[static_cast<std::size_t>(c)] = places[vcg::tri::Index(layer.cm, face.cV(c))];
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

std::vector<double> vertexQualities(const MeshModel &layer)
{
    if (!layer.hasDataMask(MeshModel::MM_VERTQUALITY))
        throw neuralmesh::InvalidInput(named("DensityFromQuality") + ": layer '" +
                                       layer.label().toStdString() +
                                       "' has no vertex quality. Compute one first.");
    std::vector<double> qualities;
    qualities.reserve(static_cast<std::size_t>(layer.cm.vn));
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD())
            qualities.push_back(static_cast<double>(vertex.cQ()));
    return qualities;
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

MeshModel &addLayer(MeshDocument &document, const neuralmesh::Mesh &result, const QString &label)
{
    CMeshO mesh;
    auto vertex = vcg::tri::Allocator<CMeshO>::AddVertices(mesh, result.positions.size());
    for (const neuralmesh::Point &p : result.positions) {
        vertex->P() = Point3m::Construct(vcg::Point3d(p[0], p[1], p[2]));
        ++vertex;
    }
    auto face = vcg::tri::Allocator<CMeshO>::AddFaces(mesh, result.triangles.size());
    for (const neuralmesh::Corners &corners : result.triangles) {
        for (int c = 0; c < 3; ++c)
            face->V(c) = &mesh.vert[corners[static_cast<std::size_t>(c)]];
        ++face;
    }
    // Updates the bounding box and the normals too.
    return *document.addNewMesh(mesh, label, true);
}
