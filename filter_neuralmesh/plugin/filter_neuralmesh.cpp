// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_neuralmesh.h"

#include <chrono>
#include <cstring>

#include "error_sentences.h"
#include "filter_descriptions.h"
#include "filter_parameters.h"
#include "filter_results.h"
#include "host_progress.h"
#include "hosts/common/progress_part.h"
#include "layers.h"
#include "origins.h"
#include "parameter_names.h"

namespace {

/// The host refuses a filter without a class, and puts one into the menu of each class that it
/// knows. Of this bit it knows none, and a cast cannot make it: it is beyond the enumerators.
FilterPlugin::FilterClass inNoMenu()
{
    constexpr int unknown = 1 << 30;
    FilterPlugin::FilterClass filterClass = FilterPlugin::Generic;
    static_assert(sizeof filterClass == sizeof unknown, "A host tests its bits as an int.");
    std::memcpy(&filterClass, &unknown, sizeof unknown);
    return filterClass;
}

} // namespace

FilterNeuralMesh::FilterNeuralMesh()
{
    typeList = {FromLayers, FromImplicitSurface, FromParametricSurface, FromLayersByOldName};
    for (const ActionIDType id : typeList)
        actionList.push_back(new QAction(filterName(id), this));
}

QString FilterNeuralMesh::pluginName() const
{
    return "FilterNeuralMesh";
}

QString FilterNeuralMesh::vendor() const
{
    return "Neural Mesh Reconstruction";
}

QString FilterNeuralMesh::filterName(ActionIDType filter) const
{
    switch (filter) {
    case FromLayers: return "Surface Reconstruction: Neural Mesh";
    case FromLayersByOldName: return "Neural Mesh Reconstruction";
    case FromImplicitSurface: return "Neural Mesh from Implicit Surface";
    case FromParametricSurface: return "Neural Mesh from Parametric Surface";
    default: return QString();
    }
}

QString FilterNeuralMesh::pythonFilterName(ActionIDType filter) const
{
    switch (filter) {
    case FromLayers:
    case FromLayersByOldName: return "generate_surface_reconstruction_neural_mesh";
    case FromImplicitSurface: return "create_neural_mesh_from_implicit_surface";
    case FromParametricSurface: return "create_neural_mesh_from_parametric_surface";
    default: return QString();
    }
}

QString FilterNeuralMesh::filterInfo(ActionIDType filter) const
{
    switch (filter) {
    case FromLayers:
    case FromLayersByOldName: return aboutReconstruction();
    case FromImplicitSurface: return aboutImplicitSurface();
    case FromParametricSurface: return aboutParametricSurface();
    default: return QString();
    }
}

FilterPlugin::FilterClass FilterNeuralMesh::getClass(const QAction *action) const
{
    if (ID(action) == FromLayersByOldName)
        return inNoMenu();
    if (ID(action) == FromLayers)
        return static_cast<FilterClass>(FilterPlugin::Remeshing | FilterPlugin::PointSet);
    return FilterPlugin::MeshCreation;
}

FilterPlugin::FilterArity FilterNeuralMesh::filterArity(const QAction *) const
{
    return NONE; // a point file needs no layer either: the document may be empty
}

int FilterNeuralMesh::postCondition(const QAction *) const
{
    return MeshModel::MM_NONE; // existing layers stay as they are
}

RichParameterList FilterNeuralMesh::initParameterList(const QAction *action,
                                                      const MeshDocument &document)
{
    switch (ID(action)) {
    case FromLayers:
    case FromLayersByOldName: return reconstructionParameters(document);
    case FromImplicitSurface: return implicitParameters(document);
    case FromParametricSurface: return parametricParameters(document);
    default: return {};
    }
}

std::map<std::string, QVariant> FilterNeuralMesh::applyFilter(const QAction *action,
                                                              const RichParameterList &given,
                                                              MeshDocument &document,
                                                              unsigned int &postConditionMask,
                                                              vcg::CallBackPos *callback)
{
    postConditionMask = MeshModel::MM_NONE;
    // The desktop hands over only those parameters that a filter script names; the first of two of
    // a name counts.
    RichParameterList parameters = given;
    parameters.join(initParameterList(action, document));
    try {
        switch (ID(action)) {
        case FromLayers:
        case FromLayersByOldName:
            return reconstruct(parameters, document, callback,
                               [&](const neuralmesh::Progress &opening) {
                                   return makeTargetSpace(parameters, document, opening);
                               });
        case FromImplicitSurface:
            return reconstruct(parameters, document, callback,
                               [&](const neuralmesh::Progress &opening) {
                                   return makeImplicitSurface(parameters, opening);
                               });
        case FromParametricSurface:
            return reconstruct(parameters, document, callback,
                               [&](const neuralmesh::Progress &opening) {
                                   return makeParametricSurface(parameters, opening);
                               });
        default: wrongActionCalled(action); return {};
        }
    } catch (const neuralmesh::InvalidInput &error) {
        throw MLException(QString::fromStdString(sentenceFor(error)));
    } catch (const neuralmesh::Cancelled &) {
        throw MLException("Cancelled: the document is as it was.");
    } catch (const std::bad_alloc &) {
        throw MLException("Too little memory for this input and " +
                          QString::fromStdString(named("TargetVertNum")) + ".");
    }
}

std::map<std::string, QVariant> FilterNeuralMesh::reconstruct(const RichParameterList &parameters,
                                                              MeshDocument &document,
                                                              vcg::CallBackPos *callback,
                                                              const MakeTarget &makeTarget)
{
    const auto start = std::chrono::steady_clock::now();
    neuralmesh::GrowthParameters growthParameters = readGrowthParameters(parameters);
    growthParameters.validate();
    const neuralmesh::Progress progress =
        throttledProgress(callback, neuralmesh::Deadline::in(parameters.getFloat("TimeLimit")));
    const TargetSpace target =
        makeTarget(neuralmesh::part(progress, 0, neuralmesh::shareOfOpening));
    growthParameters.maxHoleSize =
        holeSizeInFrame(parameters, document, target.sampler->frame().diagonal());

    neuralmesh::Reconstruction result;
    result.seed = growthParameters.seed;
    result.diagonal = target.sampler->frame().diagonal();
    const neuralmesh::Progress growing = neuralmesh::part(progress, neuralmesh::shareOfOpening, 1);
    const auto keep = [&](neuralmesh::Mesh snapshot) {
        result.snapshots.push_back(std::move(snapshot));
    };
    result.result = growthParameters.startMesh == neuralmesh::StartMesh::given
                        ? neuralmesh::reconstructFrom(
                              worldMesh(startLayer(document, parameters.getMeshId("StartLayer"))),
                              *target.sampler, growthParameters, growing, keep)
                        : neuralmesh::reconstruct(*target.sampler, growthParameters, growing, keep);
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    log(summary(result));
    if (!target.remark.empty())
        log(target.remark);
    const bool withAttributes =
        !target.attributes.layers.empty() && parameters.getBool("TransferAttributes");
    // All that may fail comes before the document changes.
    const auto attributesOf = [&](const neuralmesh::Mesh &mesh) {
        return withAttributes ? transferAttributes(target.attributes, mesh, progress)
                              : Attributes{};
    };
    std::vector<Attributes> attributes;
    for (const neuralmesh::Mesh &snapshot : result.snapshots)
        attributes.push_back(attributesOf(snapshot));
    attributes.push_back(attributesOf(result.result.mesh));

    const auto addResult = [&](const neuralmesh::Mesh &mesh, const QString &name,
                               const Attributes &carried) {
        MeshModel &layer = addLayer(document, mesh, name);
        setAttributes(layer, carried);
        remember(layer, target.origin);
    };
    const QString label = target.name + " neural mesh";
    for (std::size_t i = 0; i < result.snapshots.size(); ++i) {
        const neuralmesh::Mesh &snapshot = result.snapshots[i];
        const QString count = QString::number(snapshot.positions.size());
        addResult(snapshot, label + " " + count, attributes[i]);
    }
    addResult(result.result.mesh, label, attributes.back());
    return resultValues(result);
}
