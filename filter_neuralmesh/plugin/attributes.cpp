// SPDX-License-Identifier: GPL-3.0-or-later
#include "attributes.h"

#include <algorithm>
#include <cmath>

#include "core/space/plain_points.h"
#include "layers.h"
#include "neuralmesh/random.h"
#include "samplers/alias_table.h"

namespace {

using neuralmesh::AttributeTransfer;
using neuralmesh::AttributeValues;
using neuralmesh::Corners;
using neuralmesh::Point;

/// Of the places on faces at which attributes are looked at: the same at every run.
constexpr std::uint64_t seedOfPlaces = 1;

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

class LayerReader {
public:
    LayerReader(AttributeTransfer &transfer, const neuralmesh::UnitFrame &frame)
        : transfer_(transfer), frame_(frame)
    {
    }

    /// Every stride-th vertex.
    void addVertices(const MeshModel &layer, std::size_t stride)
    {
        const std::vector<Point> points = worldPoints(layer);
        const std::vector<AttributeValues> values = vertexAttributes(layer);
        for (std::size_t i = 0; i < points.size(); i += stride)
            transfer_.add(neuralmesh::toVcg(frame_.toUnit(points[i])), values[i]);
    }

    /// Places uniform on the faces.
    void addFaces(const MeshModel &layer, std::size_t count)
    {
        std::vector<vcg::Point3d> points;
        for (const Point &p : worldPoints(layer))
            points.push_back(neuralmesh::toVcg(p));
        const std::vector<AttributeValues> values = vertexAttributes(layer);
        const std::vector<Corners> faces = faceCorners(layer);
        std::vector<double> areas;
        for (const Corners &f : faces)
            areas.push_back(((points[f[1]] - points[f[0]]) ^ (points[f[2]] - points[f[0]])).Norm());
        const neuralmesh::AliasTable table(areas);
        neuralmesh::Random random(seedOfPlaces);
        for (std::size_t i = 0; i < count; ++i) {
            const Corners &f = faces[table.draw(random)];
            const double root = std::sqrt(random.unit()); // uniform in the triangle (Turk 1990)
            const double share = random.unit();
            const double w[3] = {1 - root, root * (1 - share), root * share};
            AttributeValues mixed{};
            for (std::size_t k = 0; k < mixed.size(); ++k)
                mixed[k] = w[0] * values[f[0]][k] + w[1] * values[f[1]][k] + w[2] * values[f[2]][k];
            transfer_.add(neuralmesh::toUnit(frame_, points[f[0]] * w[0] + points[f[1]] * w[1] +
                                                         points[f[2]] * w[2]),
                          mixed);
        }
    }

private:
    AttributeTransfer &transfer_;
    const neuralmesh::UnitFrame &frame_;
};

bool anyHas(const AttributeSource &source, int mask)
{
    return std::any_of(source.layers.begin(), source.layers.end(),
                       [mask](const MeshModel *layer) { return layer->hasDataMask(mask); });
}

} // namespace

Attributes transferAttributes(const AttributeSource &source, const neuralmesh::NeuralMesh &network,
                              const neuralmesh::UnitFrame &frame, const neuralmesh::Box3 &bounds)
{
    Attributes attributes;
    attributes.hasColour = anyHas(source, MeshModel::MM_VERTCOLOR);
    attributes.hasQuality = anyHas(source, MeshModel::MM_VERTQUALITY);
    if (!attributes.hasColour && !attributes.hasQuality)
        return attributes;
    const std::size_t enough =
        AttributeTransfer::pointsPerVertex * static_cast<std::size_t>(network.vn);
    std::size_t vertices = 0;
    for (const MeshModel *layer : source.layers)
        vertices += static_cast<std::size_t>(layer->cm.vn);
    AttributeTransfer transfer(network, bounds);
    LayerReader reader(transfer, frame);
    for (const MeshModel *layer : source.layers)
        if (source.onFaces)
            reader.addFaces(*layer, enough);
        else
            reader.addVertices(*layer, vertices / enough + 1);
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
