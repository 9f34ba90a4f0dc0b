// SPDX-License-Identifier: GPL-3.0-or-later
#include "target_space.h"

#include "hosts/common/reconstruction.h"
#include "layers.h"
#include "neuralmesh/errors.h"
#include "neuralmesh/samplers.h"
#include "origins.h"
#include "parameter_names.h"

namespace {

using neuralmesh::InvalidInput;

/// The points of several layers, with a density for each where one is asked for.
class PointCollection {
public:
    explicit PointCollection(bool withDensity) : withDensity_(withDensity) {}

    void add(const MeshModel &layer)
    {
        layers_.push_back(&layer);
        std::vector<neuralmesh::Point> points = worldPoints(layer);
        if (points_.empty())
            points_ = std::move(points);
        else
            points_.insert(points_.end(), points.begin(), points.end());
        if (!withDensity_)
            return;
        const std::vector<double> qualities = vertexQualities(layer);
        qualities_.insert(qualities_.end(), qualities.begin(), qualities.end());
    }

    TargetSpace targetSpace(const QString &name)
    {
        auto sampler = neuralmesh::pointCloudSampler(std::move(points_), qualities_);
        const std::string remark = neuralmesh::outlierRemark(sampler->outliers());
        return {std::move(sampler), name, remark, {layers_, false}, {}};
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
    TargetSpace target = points.targetSpace(nameOf(layer));
    target.origin = {Source::pointsOfLayer, static_cast<unsigned int>(layer.id())};
    return target;
}

TargetSpace surfaceOfLayer(const MeshModel &layer, bool withDensity)
{
    if (layer.cm.fn == 0)
        throw InvalidInput(
            "The current layer has no faces, so it has no surface to sample: choose " +
            chosen("Source", 0, sourceLabels()[0].toStdString()) + ".");
    const std::vector<double> density =
        withDensity ? vertexQualities(layer) : std::vector<double>();
    return {neuralmesh::surfaceSampler(worldMesh(layer), density),
            nameOf(layer),
            {},
            {{&layer}, true},
            {Source::surfaceOfLayer, static_cast<unsigned int>(layer.id())}};
}

/// Whether a layer is what an earlier run made of the others: it adds nothing to their points.
bool isResultOfVisibleLayers(const MeshModel &layer)
{
    const std::optional<Origin> origin = originOf(layer);
    return origin && origin->source == Source::pointsOfVisibleLayers;
}

TargetSpace pointsOfVisibleLayers(const MeshDocument &document, bool withDensity)
{
    PointCollection points(withDensity);
    bool hasAny = false;
    for (const MeshModel &layer : document.meshIterator()) {
        if (!layer.isVisible() || layer.cm.vn == 0 || isResultOfVisibleLayers(layer))
            continue;
        points.add(layer);
        hasAny = true;
    }
    if (!hasAny)
        throw InvalidInput("No visible layer has vertices.");
    TargetSpace target = points.targetSpace("visible layers");
    target.origin = {Source::pointsOfVisibleLayers, 0};
    return target;
}

neuralmesh::Formula formula(const RichParameterList &parameters, const char *name)
{
    return {name, parameters.getString(name).toStdString()};
}

/// The path as the system has it. Where the locale lacks a letter, as C does, names are UTF-8.
std::string systemName(const QString &path)
{
    const QByteArray encoded = QFile::encodeName(path);
    const bool isInLocale = QFile::decodeName(encoded) == path;
    return (isInLocale ? encoded : path.toUtf8()).toStdString();
}

TargetSpace pointFile(const QString &path, bool withDensity, const neuralmesh::Progress &progress)
{
    if (path.isEmpty())
        throw InvalidInput(named("Source") + " is a point file, but " + named("PointFile") +
                           " names none.");
    if (withDensity)
        throw InvalidInput(named("DensityFromQuality") +
                           " is for layers: a point file has no vertex quality.");
    auto sampler = neuralmesh::pointFileSampler(systemName(path), progress);
    const std::string remark = neuralmesh::outlierRemark(sampler->outliers());
    const QString name = QFileInfo(path).completeBaseName();
    return {std::move(sampler),
            withoutDots(name.isEmpty() ? QFileInfo(path).fileName() : name),
            remark,
            {},
            {Source::pointFile, 0}};
}

/// The layer that is sampled. Throws InvalidInput where the document has none.
const MeshModel &layerFor(const MeshDocument &document, Source source)
{
    const MeshModel *layer = inputLayer(document, source);
    return layer == nullptr ? currentLayer(document) : *layer;
}

TargetSpace targetSpaceOf(Source source, const RichParameterList &parameters,
                          const MeshDocument &document, const neuralmesh::Progress &progress)
{
    const bool withDensity = parameters.getBool("DensityFromQuality");
    switch (source) {
    case Source::pointsOfLayer: return pointsOfLayer(layerFor(document, source), withDensity);
    case Source::surfaceOfLayer: return surfaceOfLayer(layerFor(document, source), withDensity);
    case Source::pointsOfVisibleLayers: return pointsOfVisibleLayers(document, withDensity);
    case Source::pointFile:
        return pointFile(parameters.getOpenFileName("PointFile"), withDensity, progress);
    case Source::none: break;
    }
    throw InvalidInput(named("Source") + " must be one of 0 to " +
                       std::to_string(sourceLabels().size() - 1) + ".");
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
    const auto source = static_cast<Source>(parameters.getEnum("Source"));
    if (source != Source::pointFile && !parameters.getOpenFileName("PointFile").isEmpty())
        throw InvalidInput(named("PointFile") + " names a file that would not be read: choose " +
                           chosen("Source", static_cast<int>(Source::pointFile),
                                  sourceLabels().back().toStdString()) +
                           ", or leave " + named("PointFile") + " empty.");
    TargetSpace target = targetSpaceOf(source, parameters, document, progress);
    if (source == Source::pointsOfLayer || source == Source::surfaceOfLayer)
        target.remark =
            remarkOnOrigin(document, source) + (target.remark.empty() ? "" : " ") + target.remark;
    return target;
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
            {},
            {}};
}
