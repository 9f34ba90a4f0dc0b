// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of this project in MeshLab's rewrite; filters.json declares them. Includes what that
// host publishes, and nothing of the plugin for the MeshLab of today.
#pragma once

#include "meshfilterplugin.h"

class MeshFilterPluginManager;

class NeuralMeshFilterPlugin final : public MeshFilterPlugin {
public:
    QString pluginId() const override;
    QString name() const override;
    /// On any error, and when cancelled, the document is as it was, and success is false.
    MeshFilterRunResult runFilter(const QString &filterId, const FilterParams &params,
                                  Document &doc) const override;
};

void registerNeuralMeshFilterPlugin(MeshFilterPluginManager &pluginManager);
