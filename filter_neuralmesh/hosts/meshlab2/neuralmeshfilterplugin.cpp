// SPDX-License-Identifier: GPL-3.0-or-later
#include "neuralmeshfilterplugin.h"

#include <QObject>

#include <chrono>
#include <functional>
#include <memory>
#include <new>

#include "document.h"
#include "filter_parameters.h"
#include "filterparam.h"
#include "host_progress.h"
#include "hosts/common/error_sentences.h"
#include "hosts/common/progress_part.h"
#include "hosts/common/reconstruction.h"
#include "layers.h"
#include "meshfilterpluginmanager.h"
#include "target_space.h"

namespace neuralmesh::meshlab2 {
namespace {

using MakeTarget = std::function<TargetSpace(const Progress &opening)>;

template <class T> QVariant toVariant(const T &value)
{
    return value;
}

template <class T> QVariant toVariant(const std::vector<T> &values)
{
    QVariantList list;
    for (const T &value : values)
        list.append(value);
    return list;
}

/// The bar of a run. It ends when this does, as a failure unless it was said to be done.
class ProgressBar {
public:
    explicit ProgressBar(Document &document) : document_(document)
    {
        document_.beginFilterProgress(QObject::tr("Neural mesh"));
    }
    ~ProgressBar() { document_.finishFilterProgress(isDone_, QString()); }
    ProgressBar(const ProgressBar &) = delete;
    ProgressBar &operator=(const ProgressBar &) = delete;
    void done() { isDone_ = true; }

private:
    Document &document_;
    bool isDone_ = false;
};

/// Throws InvalidInput where the parameter names no layer.
Mesh startingMesh(const Document &document, const MeshFilterParameterValues &values)
{
    bool isIndex = false;
    const int index = values.value(QStringLiteral("startLayer")).toInt(&isIndex);
    if (!isIndex || index < 0 || index >= document.meshCount())
        throw InvalidInput("startMesh is a layer, but startLayer names none.");
    return worldMesh(document.mesh(index));
}

struct Carried {
    std::vector<AttributeValues> values;
    bool colour = false;
    bool quality = false;
};

Carried carriedOnto(const Mesh &mesh, const Document &document, const TargetSpace &target,
                    const Progress &progress)
{
    Carried carried;
    std::size_t vertices = 0;
    for (const int index : target.layers) {
        const Layer &layer = document.mesh(index);
        carried.colour = carried.colour || hasColour(layer);
        carried.quality = carried.quality || hasQuality(layer);
        vertices += static_cast<std::size_t>(layer.mesh.VN());
    }
    if (!carried.colour && !carried.quality)
        return carried;
    const std::size_t enough = AttributeTransfer::pointsPerVertex * mesh.positions.size();
    AttributeTransfer transfer(mesh);
    for (const int index : target.layers) {
        const Layer &layer = document.mesh(index);
        if (target.onFaces)
            transfer.addSurface(worldMesh(layer), attributes(layer), enough, progress);
        else
            transfer.addPoints(worldPoints(layer), attributes(layer), vertices / enough + 1,
                               progress);
    }
    carried.values = transfer.average();
    return carried;
}

Reconstruction reconstructed(const TargetSpace &target, const GrowthParameters &parameters,
                             const MeshFilterParameterValues &values, const Document &document,
                             const Progress &progress)
{
    const auto start = std::chrono::steady_clock::now();
    Reconstruction made;
    made.seed = parameters.seed;
    made.diagonal = target.sampler->frame().diagonal();
    const auto keep = [&](Mesh snapshot) { made.snapshots.push_back(std::move(snapshot)); };
    made.result = parameters.startMesh == StartMesh::given
                      ? reconstructFrom(startingMesh(document, values), *target.sampler, parameters,
                                        progress, keep)
                      : reconstruct(*target.sampler, parameters, progress, keep);
    made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return made;
}

/// Adds the layers, snapshots first, and says what the host is to know of them.
MeshFilterRunResult withLayers(const Reconstruction &made, const std::vector<Carried> &carried,
                               const TargetSpace &target, Document &document)
{
    MeshFilterRunResult result;
    std::vector<const Mesh *> meshes;
    for (const Mesh &snapshot : made.snapshots)
        meshes.push_back(&snapshot);
    meshes.push_back(&made.result.mesh);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const Carried &c = carried[i];
        result.newMeshIndices.push_back(
            addLayer(document, *meshes[i], c.values, c.colour, c.quality));
        const bool isSnapshot = i + 1 < meshes.size();
        result.outputTags
            << (isSnapshot
                    ? QStringLiteral("neural mesh %1").arg(qulonglong(meshes[i]->positions.size()))
                    : QStringLiteral("neural mesh"));
    }
    for (const int index : target.layers)
        result.sourceMeshIndices.push_back(index);
    forEachResult(made, [&](const char *name, const auto &value) {
        result.outputValues.insert(QLatin1String(name), toVariant(value));
    });
    result.infoMessages << QString::fromStdString(summary(made, terms()));
    if (!target.remark.empty())
        result.infoMessages << QString::fromStdString(target.remark);
    result.success = result.documentModified = true;
    return result;
}

MeshFilterRunResult run(const FilterParams &params, Document &document,
                        const MakeTarget &makeTarget)
{
    const MeshFilterParameterValues values = params.rawValues();
    const RandomSeed seed = params.getRandomSeed();
    const GrowthParameters parameters = growthParameters(values, seed.value);
    parameters.validate();
    ProgressBar bar(document);
    const Progress progress =
        throttledProgress(document.progressCallback(),
                          Deadline::in(values.value(QStringLiteral("timeLimit")).toDouble()));
    const TargetSpace target = makeTarget(part(progress, 0, shareOfOpening));
    const Reconstruction made =
        reconstructed(target, parameters, values, document, part(progress, shareOfOpening, 1));
    // All that may fail comes before the document changes.
    const bool carries = values.value(QStringLiteral("transferAttributes")).toBool();
    std::vector<Carried> carried(made.snapshots.size() + 1);
    if (carries) {
        for (std::size_t i = 0; i < made.snapshots.size(); ++i)
            carried[i] = carriedOnto(made.snapshots[i], document, target, progress);
        carried.back() = carriedOnto(made.result.mesh, document, target, progress);
    }
    MeshFilterRunResult result = withLayers(made, carried, target, document);
    result.infoMessages << seed.message();
    bar.done();
    return result;
}

MeshFilterRunResult failure(const QString &sentence)
{
    MeshFilterRunResult result;
    result.errorMessage = sentence;
    return result;
}

MakeTarget targetOf(const QString &filter, const FilterParams &params, const Document &document)
{
    const MeshFilterParameterValues values = params.rawValues();
    if (filter == QStringLiteral("reconstruct_surface_by_neural_mesh"))
        return [values, &document](const Progress &opening) {
            return layersOrFile(values, document, opening);
        };
    if (filter == QStringLiteral("create_neural_mesh_from_implicit_surface"))
        return [values](const Progress &opening) { return implicitSurface(values, opening); };
    if (filter == QStringLiteral("create_neural_mesh_from_parametric_surface"))
        return [values](const Progress &opening) { return parametricSurface(values, opening); };
    return {};
}

} // namespace
} // namespace neuralmesh::meshlab2

QString NeuralMeshFilterPlugin::pluginId() const
{
    return QStringLiteral("meshlab2.filter.neuralmesh");
}

QString NeuralMeshFilterPlugin::name() const
{
    return QObject::tr("Neural Mesh Reconstruction");
}

MeshFilterRunResult NeuralMeshFilterPlugin::runFilter(const QString &filterId,
                                                      const FilterParams &params,
                                                      Document &doc) const
{
    using namespace neuralmesh;
    const meshlab2::MakeTarget makeTarget = meshlab2::targetOf(filterId, params, doc);
    if (!makeTarget)
        return meshlab2::failure(QObject::tr("Unknown filter: %1").arg(filterId));
    try {
        return meshlab2::run(params, doc, makeTarget);
    } catch (const InvalidInput &error) {
        return meshlab2::failure(QString::fromStdString(sentenceFor(error, meshlab2::terms())));
    } catch (const Cancelled &) {
        return meshlab2::failure(QObject::tr("Cancelled: the document is as it was."));
    } catch (const std::bad_alloc &) {
        return meshlab2::failure(
            QObject::tr("Too little memory for this input and targetVertNum."));
    }
}

void registerNeuralMeshFilterPlugin(MeshFilterPluginManager &pluginManager)
{
    pluginManager.registerPlugin(std::make_unique<NeuralMeshFilterPlugin>());
}
