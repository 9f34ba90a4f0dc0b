// SPDX-License-Identifier: GPL-3.0-or-later
// The MeshLab filter plugin: translates between the host and the core, and does nothing else.
#pragma once

#include <functional>

#include <common/plugins/interfaces/filter_plugin.h>

#include "target_space.h"

class FilterNeuralMesh : public QObject, public FilterPlugin {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(FILTER_PLUGIN_IID)
    Q_INTERFACES(FilterPlugin)

public:
    /// The last one is the first by the name that it had up to 0.1.0, for scripts: no menu has it.
    enum FilterId { FromLayers, FromImplicitSurface, FromParametricSurface, FromLayersByOldName };

    FilterNeuralMesh();

    QString pluginName() const override;
    QString vendor() const override;

    QString filterName(ActionIDType filter) const override;
    QString pythonFilterName(ActionIDType filter) const override;
    QString filterInfo(ActionIDType filter) const override;
    FilterClass getClass(const QAction *action) const override;
    FilterArity filterArity(const QAction *action) const override;
    int postCondition(const QAction *action) const override;

    // The document version: the base class's looks into the current layer, which an empty
    // document does not have.
    RichParameterList initParameterList(const QAction *action,
                                        const MeshDocument &document) override;

    /// Makes one new layer, current, with the result. Throws MLException with a sentence for the
    /// user on bad input and on cancel, and leaves the document as it was.
    std::map<std::string, QVariant>
    applyFilter(const QAction *action, const RichParameterList &parameters, MeshDocument &document,
                unsigned int &postConditionMask, vcg::CallBackPos *callback) override;

private:
    /// Is told how far it is.
    using MakeTarget = std::function<TargetSpace(const neuralmesh::Progress &)>;

    std::map<std::string, QVariant> reconstruct(const RichParameterList &parameters,
                                                MeshDocument &document, vcg::CallBackPos *callback,
                                                const MakeTarget &makeTarget);
};
