// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers.h"

#include <vcg/complex/algorithms/update/bounding.h>
#include <vcg/complex/algorithms/update/normal.h>
#include <wrap/io_trimesh/io_mask.h>

#include <algorithm>

namespace neuralmesh::meshlab2 {
namespace {

using Mask = vcg::tri::io::Mask;

/// In double precision, which the host's matrix of floats does not compute in.
Point transformed(const QMatrix4x4 &matrix, const vcg::Point3f &p)
{
    Point result;
    for (int row = 0; row < 3; ++row)
        result[static_cast<std::size_t>(row)] =
            double(matrix(row, 0)) * double(p[0]) + double(matrix(row, 1)) * double(p[1]) +
            double(matrix(row, 2)) * double(p[2]) + double(matrix(row, 3));
    return result;
}

void setAttributes(VCGVertex &vertex, const AttributeValues &values, bool withColour,
                   bool withQuality)
{
    if (withColour)
        for (int k = 0; k < 4; ++k)
            vertex.C()[k] = static_cast<unsigned char>(
                std::clamp(values[static_cast<std::size_t>(k)] + 0.5, 0.0, 255.0));
    if (withQuality)
        vertex.Q() = static_cast<float>(values[4]);
}

} // namespace

bool hasColour(const Layer &layer)
{
    return (layer.ioMask & Mask::IOM_VERTCOLOR) != 0;
}

bool hasQuality(const Layer &layer)
{
    return (layer.ioMask & Mask::IOM_VERTQUALITY) != 0;
}

std::vector<Point> worldPoints(const Layer &layer)
{
    std::vector<Point> points;
    points.reserve(static_cast<std::size_t>(layer.mesh.VN()));
    for (const VCGVertex &vertex : layer.mesh.vert)
        if (!vertex.IsD())
            points.push_back(transformed(layer.transform, vertex.cP()));
    return points;
}

Mesh worldMesh(const Layer &layer)
{
    std::vector<VertexId> places(layer.mesh.vert.size());
    VertexId place = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!layer.mesh.vert[i].IsD())
            places[i] = place++;
    Mesh mesh;
    mesh.positions = worldPoints(layer);
    for (const VCGFace &face : layer.mesh.face) {
        if (face.IsD())
            continue;
        Corners corners;
        for (int c = 0; c < 3; ++c)
            corners[static_cast<std::size_t>(c)] = places[vcg::tri::Index(layer.mesh, face.cV(c))];
        mesh.triangles.push_back(corners);
    }
    return mesh;
}

std::vector<double> qualities(const Layer &layer)
{
    std::vector<double> values;
    for (const VCGVertex &vertex : layer.mesh.vert)
        if (!vertex.IsD())
            values.push_back(double(vertex.cQ()));
    return values;
}

std::vector<AttributeValues> attributes(const Layer &layer)
{
    std::vector<AttributeValues> values;
    for (const VCGVertex &vertex : layer.mesh.vert)
        if (!vertex.IsD()) {
            const vcg::Color4b &c = vertex.cC();
            values.push_back(
                {double(c[0]), double(c[1]), double(c[2]), double(c[3]), double(vertex.cQ())});
        }
    return values;
}

int addLayer(Document &document, const Mesh &mesh, const std::vector<AttributeValues> &values,
             bool withColour, bool withQuality)
{
    VCGMesh made;
    auto vertex = vcg::tri::Allocator<VCGMesh>::AddVertices(made, mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i, ++vertex) {
        const Point &p = mesh.positions[i];
        vertex->P() = vcg::Point3f(float(p[0]), float(p[1]), float(p[2]));
        if (!values.empty())
            setAttributes(*vertex, values[i], withColour, withQuality);
    }
    auto face = vcg::tri::Allocator<VCGMesh>::AddFaces(made, mesh.triangles.size());
    for (const Corners &corners : mesh.triangles) {
        for (int c = 0; c < 3; ++c)
            face->V(c) = &made.vert[corners[static_cast<std::size_t>(c)]];
        ++face;
    }
    vcg::tri::UpdateBounding<VCGMesh>::Box(made);
    vcg::tri::UpdateNormal<VCGMesh>::PerVertexNormalizedPerFaceNormalized(made);
    int mask = Mask::IOM_VERTNORMAL | Mask::IOM_FACENORMAL;
    if (withColour)
        mask |= Mask::IOM_VERTCOLOR;
    if (withQuality)
        mask |= Mask::IOM_VERTQUALITY;
    return document.addMesh(made, QStringLiteral("neural mesh"), mask);
}

} // namespace neuralmesh::meshlab2
