// SPDX-License-Identifier: GPL-3.0-or-later
#include "target_space.h"

#include "filter_parameters.h"
#include "hosts/common/reconstruction.h"
#include "neuralmesh/samplers.h"

namespace neuralmesh::meshlab2 {
namespace {

QVariant valueOf(const MeshFilterParameterValues &values, const char *id)
{
    return values.value(QLatin1String(id));
}

/// Throws InvalidInput where a density is asked for that the layer does not have.
std::vector<double> densityOf(const Layer &layer, bool isWanted)
{
    if (!isWanted)
        return {};
    if (!hasQuality(layer))
        throw InvalidInput("densityFromQuality: layer '" + layer.name.toStdString() +
                           "' has no vertex quality. Compute one first.");
    return qualities(layer);
}

TargetSpace pointsOf(const Document &document, const std::vector<int> &layers, bool withDensity)
{
    std::vector<Point> points;
    std::vector<double> density;
    for (const int index : layers) {
        const Layer &layer = document.mesh(index);
        const std::vector<Point> more = worldPoints(layer);
        const std::vector<double> moreDensity = densityOf(layer, withDensity);
        points.insert(points.end(), more.begin(), more.end());
        density.insert(density.end(), moreDensity.begin(), moreDensity.end());
    }
    auto sampler = pointCloudSampler(points, density);
    const std::string remark = outlierRemark(sampler->outliers());
    return {std::move(sampler), layers, false, remark};
}

TargetSpace visibleLayers(const Document &document, bool withDensity)
{
    std::vector<int> layers;
    for (int i = 0; i < document.meshCount(); ++i)
        if (document.mesh(i).visible && document.mesh(i).mesh.VN() > 0)
            layers.push_back(i);
    if (layers.empty())
        throw InvalidInput("No visible layer has vertices.");
    return pointsOf(document, layers, withDensity);
}

TargetSpace pointFile(const QString &path, bool withDensity, const Progress &progress)
{
    if (path.isEmpty())
        throw InvalidInput("source is a point file, but pointFile names none.");
    if (withDensity)
        throw InvalidInput("densityFromQuality is for layers: a point file has no vertex quality.");
    auto sampler = pointFileSampler(path.toUtf8().toStdString(), progress);
    const std::string remark = outlierRemark(sampler->outliers());
    return {std::move(sampler), {}, false, remark};
}

TargetSpace currentLayer(const Document &document, bool isSurface, bool withDensity)
{
    const int current = document.currentMeshIndex();
    if (current < 0 || current >= document.meshCount())
        throw InvalidInput(
            "There is no current layer: open or make a point cloud or a mesh first.");
    const Layer &layer = document.mesh(current);
    if (layer.mesh.VN() == 0)
        throw InvalidInput("The current layer has no vertices.");
    if (!isSurface)
        return pointsOf(document, {current}, withDensity);
    if (layer.mesh.FN() == 0)
        throw InvalidInput("The current layer has no faces, so it has no surface to sample: choose "
                           "source 'points'.");
    return {surfaceSampler(worldMesh(layer), densityOf(layer, withDensity)), {current}, true, {}};
}

Formula formula(const MeshFilterParameterValues &values, const char *id)
{
    return {id, valueOf(values, id).toString().toStdString()};
}

} // namespace

TargetSpace layersOrFile(const MeshFilterParameterValues &values, const Document &document,
                         const Progress &progress)
{
    const Source source = sourceOf(values);
    const bool withDensity = valueOf(values, "densityFromQuality").toBool();
    const QString path = valueOf(values, "pointFile").toString();
    if (source == Source::pointFile)
        return pointFile(path, withDensity, progress);
    if (!path.isEmpty())
        throw InvalidInput("pointFile is '" + path.toStdString() +
                           "', but source is no point file: leave it empty.");
    if (source == Source::visibleLayers)
        return visibleLayers(document, withDensity);
    return currentLayer(document, source == Source::surface, withDensity);
}

TargetSpace implicitSurface(const MeshFilterParameterValues &values, const Progress &progress)
{
    const auto corner = [&](const std::string &end) {
        Point p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = valueOf(values, (end + "XYZ"[k]).c_str()).toDouble();
        return p;
    };
    const Box box{corner("min"), corner("max")};
    return {implicitSurfaceSampler(formula(values, "expr"), box, progress), {}, false, {}};
}

TargetSpace parametricSurface(const MeshFilterParameterValues &values, const Progress &progress)
{
    const auto range = [&](const char *from, const char *to) {
        return Range{valueOf(values, from).toDouble(), valueOf(values, to).toDouble()};
    };
    return {
        parametricSurfaceSampler({formula(values, "x"), formula(values, "y"), formula(values, "z")},
                                 range("minU", "maxU"), range("minV", "maxV"), progress),
        {},
        false,
        {}};
}

} // namespace neuralmesh::meshlab2
