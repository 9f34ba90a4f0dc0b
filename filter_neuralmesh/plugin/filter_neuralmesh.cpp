// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_neuralmesh.h"

#include <chrono>

#include "core/errors.h"
#include "core/growth.h"
#include "filter_parameters.h"
#include "filter_results.h"
#include "host_progress.h"
#include "layers.h"
#include "target_space.h"

FilterNeuralMesh::FilterNeuralMesh()
{
    typeList = {NeuralMeshReconstruction};
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
    case NeuralMeshReconstruction: return "Neural Mesh Reconstruction";
    default: return QString();
    }
}

QString FilterNeuralMesh::pythonFilterName(ActionIDType filter) const
{
    switch (filter) {
    case NeuralMeshReconstruction: return "generate_surface_reconstruction_neural_mesh";
    default: return QString();
    }
}

QString FilterNeuralMesh::filterInfo(ActionIDType filter) const
{
    switch (filter) {
    case NeuralMeshReconstruction:
        return "Reconstructs a closed surface from the points of the current layer with a growing "
               "neural network: a tetrahedron that is moved by random samples of the points and "
               "grows by vertex splits until it has exactly the number of vertices asked for. "
               "<br>Needs no normals; the result is a closed two-manifold of genus 0 with even "
               "triangles; the running time does not depend on the number of points. Not for open "
               "surfaces or surfaces with handles: the result has the topology of a sphere."
               "<br><br>See:<br>"
               "<i>I. Ivrissimtzis, W.-K. Jeong, H.-P. Seidel</i><br>"
               "<b>\"Using Growing Cell Structures for Surface Reconstruction\"</b><br>"
               "Shape Modeling International 2003";
    default: return QString();
    }
}

FilterPlugin::FilterClass FilterNeuralMesh::getClass(const QAction *) const
{
    return static_cast<FilterClass>(FilterPlugin::Remeshing | FilterPlugin::PointSet);
}

FilterPlugin::FilterArity FilterNeuralMesh::filterArity(const QAction *) const
{
    return SINGLE_MESH;
}

int FilterNeuralMesh::postCondition(const QAction *) const
{
    return MeshModel::MM_NONE; // existing layers stay as they are
}

RichParameterList FilterNeuralMesh::initParameterList(const QAction *action,
                                                      const MeshDocument &document)
{
    switch (ID(action)) {
    case NeuralMeshReconstruction: return reconstructionParameters(document);
    default: return {};
    }
}

std::map<std::string, QVariant> FilterNeuralMesh::applyFilter(const QAction *action,
                                                              const RichParameterList &parameters,
                                                              MeshDocument &document,
                                                              unsigned int &postConditionMask,
                                                              vcg::CallBackPos *callback)
{
    postConditionMask = MeshModel::MM_NONE;
    try {
        switch (ID(action)) {
        case NeuralMeshReconstruction: return reconstruct(parameters, document, callback);
        default: wrongActionCalled(action); return {};
        }
    } catch (const neuralmesh::InvalidInput &error) {
        throw MLException(error.what());
    } catch (const neuralmesh::Cancelled &cancelled) {
        throw MLException(cancelled.what());
    } catch (const std::bad_alloc &) {
        throw MLException("Too little memory for this input and TargetVertNum.");
    }
}

std::map<std::string, QVariant> FilterNeuralMesh::reconstruct(const RichParameterList &parameters,
                                                              MeshDocument &document,
                                                              vcg::CallBackPos *callback)
{
    const auto start = std::chrono::steady_clock::now();
    const neuralmesh::GrowthParameters growthParameters = readGrowthParameters(parameters);
    growthParameters.validate();
    const TargetSpace target = makeTargetSpace(parameters, document);
    const neuralmesh::UnitFrame &frame = target.sampler->frame();

    Reconstruction result;
    result.seed = growthParameters.seed;
    result.diagonal = frame.diagonal();
    if (growthParameters.startMesh == neuralmesh::StartMesh::given)
        makeStartingMesh(result.mesh, startLayer(document, parameters.getMeshId("StartLayer")),
                         frame);
    const auto keep = [&](std::unique_ptr<neuralmesh::NeuralMesh> snapshot) {
        result.snapshots.push_back(std::move(snapshot));
    };
    result.growth = neuralmesh::grow(result.mesh, *target.sampler, growthParameters,
                                     throttledProgress(callback), keep);
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

    log(summary(result));
    if (!target.remark.empty())
        log(target.remark);
    const QString label = target.name + " neural mesh";
    for (const auto &snapshot : result.snapshots)
        addLayer(document, *snapshot, frame, label + " " + QString::number(snapshot->vn));
    addLayer(document, result.mesh, frame, label);
    return resultValues(result);
}
