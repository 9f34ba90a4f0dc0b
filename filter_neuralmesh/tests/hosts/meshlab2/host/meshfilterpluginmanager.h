// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in, as meshfilterplugin.h is.
#pragma once

#include <memory>
#include <vector>

#include "meshfilterplugin.h"

class MeshFilterPluginManager {
public:
    void registerPlugin(std::unique_ptr<MeshFilterPlugin> plugin)
    {
        plugins.push_back(std::move(plugin));
    }
    std::vector<std::unique_ptr<MeshFilterPlugin>> plugins;
};
