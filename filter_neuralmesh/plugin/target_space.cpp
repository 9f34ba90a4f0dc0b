// SPDX-License-Identifier: GPL-3.0-or-later
#include "target_space.h"

#include <cstdio>

#include "layers.h"
#include "neuralmesh/errors.h"
#include "neuralmesh/samplers.h"

namespace {

using neuralmesh::InvalidInput;

/// Empty where no outliers were found.
std::string outlierRemark(const neuralmesh::Outliers &outliers)
{
    if (outliers.count == 0)
        return {};
    const bool isOne = outliers.count == 1;
    char share[32];
    std::snprintf(share, sizeof share, "%.2g", 100 * outliers.share);
    return (outliers.isEstimate ? "About " : "") + std::to_string(outliers.count) +
           (isOne ? " isolated point, " : " isolated points, ") + share + " % of the cloud, " +
           (isOne ? "is ignored." : "are ignored.");
}

/// The points of several layers, with a density for each where one is asked for.
class PointCollection {
public:
    explicit PointCollection(bool withDensity) : withDensity_(withDensity) {}

    void add(const MeshModel &layer)
    {
        layers_.push_back(&layer);
        const std::vector<neuralmesh::Point> points = worldPoints(layer);
        points_.insert(points_.end(), points.begin(), points.end());
        if (!withDensity_)
            return;
        const std::vector<double> qualities = vertexQualities(layer);
        qualities_.insert(qualities_.end(), qualities.begin(), qualities.end());
    }

    TargetSpace targetSpace(const QString &name)
    {
        auto sampler = neuralmesh::pointCloudSampler(points_, qualities_);
        const std::string remark = outlierRemark(sampler->outliers());
        return {std::move(sampler), name, remark, {layers_, false}};
    }

private:
    bool withDensity_;
    std::vector<const MeshModel *> layers_;
    std::vector<neuralmesh::Point> points_;
    std::vector<double> qualities_;
};

TargetSpace pointsOfLayer(const MeshModel &layer, bool withDensity)
{
    if (layer.cm.vn == 0)
        throw InvalidInput("The current layer has no vertices.");
    PointCollection points(withDensity);
    points.add(layer);
    return points.targetSpace(nameOf(layer));
}

TargetSpace surfaceOfLayer(const MeshModel &layer, bool withDensity)
{
    if (layer.cm.fn == 0)
        throw InvalidInput("The current layer has no faces, so it has no surface to sample: choose "
                           "its points as the Source.");
    const std::vector<double> density =
        withDensity ? vertexQualities(layer) : std::vector<double>();
    return {
        neuralmesh::surfaceSampler(worldMesh(layer), density), nameOf(layer), {}, {{&layer}, true}};
}

TargetSpace pointsOfVisibleLayers(const MeshDocument &document, bool withDensity)
{
    PointCollection points(withDensity);
    bool hasAny = false;
    for (const MeshModel &layer : document.meshIterator()) {
        if (!layer.isVisible() || layer.cm.vn == 0)
            continue;
        points.add(layer);
        hasAny = true;
    }
    if (!hasAny)
        throw InvalidInput("No visible layer has vertices.");
    return points.targetSpace("visible layers");
}

neuralmesh::Formula formula(const RichParameterList &parameters, const char *name)
{
    return {name, parameters.getString(name).toStdString()};
}

TargetSpace pointFile(const QString &path, bool withDensity, const neuralmesh::Progress &progress)
{
    if (path.isEmpty())
        throw InvalidInput("Source is a point file, but PointFile names none.");
    if (withDensity)
        throw InvalidInput("DensityFromQuality is for layers: a point file has no vertex quality.");
    const std::string encoded = QFile::encodeName(path).toStdString();
    auto sampler = neuralmesh::pointFileSampler(encoded, progress);
    const std::string remark = outlierRemark(sampler->outliers());
    const QString name = QFileInfo(path).completeBaseName();
    return {std::move(sampler),
            withoutDots(name.isEmpty() ? QFileInfo(path).fileName() : name),
            remark,
            {}};
}

} // namespace

QStringList sourceLabels()
{
    return {"Points of the current layer", "Surface of the current layer",
            "Points of all visible layers", "A point file on disk"};
}

TargetSpace makeTargetSpace(const RichParameterList &parameters, const MeshDocument &document,
                            const neuralmesh::Progress &progress)
{
    const bool withDensity = parameters.getBool("DensityFromQuality");
    switch (static_cast<Source>(parameters.getEnum("Source"))) {
    case Source::pointsOfLayer: return pointsOfLayer(currentLayer(document), withDensity);
    case Source::surfaceOfLayer: return surfaceOfLayer(currentLayer(document), withDensity);
    case Source::pointsOfVisibleLayers: return pointsOfVisibleLayers(document, withDensity);
    case Source::pointFile:
        return pointFile(parameters.getOpenFileName("PointFile"), withDensity, progress);
    }
    throw InvalidInput("Source must be one of 0 to " + std::to_string(sourceLabels().size() - 1) +
                       ".");
}

TargetSpace makeImplicitSurface(const RichParameterList &parameters,
                                const neuralmesh::Progress &progress)
{
    const neuralmesh::Box box{
        {parameters.getFloat("minX"), parameters.getFloat("minY"), parameters.getFloat("minZ")},
        {parameters.getFloat("maxX"), parameters.getFloat("maxY"), parameters.getFloat("maxZ")}};
    return {neuralmesh::implicitSurfaceSampler(formula(parameters, "expr"), box, progress),
            "implicit surface",
            {},
            {}};
}

TargetSpace makeParametricSurface(const RichParameterList &parameters,
                                  const neuralmesh::Progress &progress)
{
    const neuralmesh::Range u{parameters.getFloat("minU"), parameters.getFloat("maxU")};
    const neuralmesh::Range v{parameters.getFloat("minV"), parameters.getFloat("maxV")};
    return {neuralmesh::parametricSurfaceSampler(
                {formula(parameters, "x"), formula(parameters, "y"), formula(parameters, "z")}, u,
                v, progress),
            "parametric surface",
            {},
            {}};
}
