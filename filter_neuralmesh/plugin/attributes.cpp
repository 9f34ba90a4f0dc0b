// SPDX-License-Identifier: GPL-3.0-or-later
#include "attributes.h"

#include <algorithm>

#include "layers.h"

namespace {

using neuralmesh::AttributeTransfer;
using neuralmesh::AttributeValues;

/// Attributes of the vertices that are not deleted, as worldPoints() numbers them.
std::vector<AttributeValues> vertexAttributes(const MeshModel &layer)
{
    std::vector<AttributeValues> values;
    for (const CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD()) {
            const auto &c = vertex.cC();
            values.push_back({double(c[0]), double(c[1]), double(c[2]), double(c[3]),
                              static_cast<double>(vertex.cQ())});
        }
    return values;
}

/// Every stride-th vertex.
void addVertices(AttributeTransfer &transfer, const MeshModel &layer, std::size_t stride,
                 const neuralmesh::Progress &progress)
{
    const std::vector<neuralmesh::Point> points = worldPoints(layer);
    const std::vector<AttributeValues> values = vertexAttributes(layer);
    transfer.addPoints(points, values, stride, progress);
}

bool anyHas(const AttributeSource &source, int mask)
{
    return std::any_of(source.layers.begin(), source.layers.end(),
                       [mask](const MeshModel *layer) { return layer->hasDataMask(mask); });
}

} // namespace

Attributes transferAttributes(const AttributeSource &source, const neuralmesh::Mesh &mesh,
                              const neuralmesh::Progress &progress)
{
    Attributes attributes;
    attributes.hasColour = anyHas(source, MeshModel::MM_VERTCOLOR);
    attributes.hasQuality = anyHas(source, MeshModel::MM_VERTQUALITY);
    if (!attributes.hasColour && !attributes.hasQuality)
        return attributes;
    const std::size_t enough = AttributeTransfer::pointsPerVertex * mesh.positions.size();
    std::size_t vertices = 0;
    for (const MeshModel *layer : source.layers)
        vertices += static_cast<std::size_t>(layer->cm.vn);
    AttributeTransfer transfer(mesh);
    for (const MeshModel *layer : source.layers)
        if (source.onFaces)
            transfer.addSurface(worldMesh(*layer), vertexAttributes(*layer), enough, progress);
        else
            addVertices(transfer, *layer, vertices / enough + 1, progress);
    attributes.values = transfer.average();
    return attributes;
}

void setAttributes(MeshModel &layer, const Attributes &attributes)
{
    if (attributes.hasColour)
        layer.updateDataMask(MeshModel::MM_VERTCOLOR);
    if (attributes.hasQuality)
        layer.updateDataMask(MeshModel::MM_VERTQUALITY);
    for (std::size_t i = 0; i < attributes.values.size(); ++i) {
        const AttributeValues &values = attributes.values[i];
        CVertexO &vertex = layer.cm.vert[i];
        if (attributes.hasColour)
            for (int k = 0; k < 4; ++k)
                vertex.C()[k] = static_cast<unsigned char>(
                    std::clamp(values[static_cast<std::size_t>(k)] + 0.5, 0.0, 255.0));
        if (attributes.hasQuality)
            vertex.Q() = static_cast<Scalarm>(values[4]);
    }
}
