// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in, as meshfilterplugin.h is: layers, and a bar that may be cancelled.
#pragma once

#include <QMatrix4x4>
#include <QString>

#include <memory>
#include <vector>

#include <vcg/complex/append.h>
#include <wrap/callback.h>

#include "vcgmesh.h"

class Document {
public:
    struct MeshEntry {
        QMatrix4x4 transform;
        QString name;
        bool visible = true;
        int ioMask = 0;
        VCGMesh mesh;
    };

    int meshCount() const { return static_cast<int>(meshes_.size()); }
    MeshEntry &mesh(int i) { return *meshes_[static_cast<std::size_t>(i)]; }
    const MeshEntry &mesh(int i) const { return *meshes_[static_cast<std::size_t>(i)]; }
    int currentMeshIndex() const { return current_; }
    int addMesh(const VCGMesh &mesh, const QString &name = {}, int ioMask = 0)
    {
        auto entry = std::make_unique<MeshEntry>();
        vcg::tri::Append<VCGMesh, VCGMesh>::MeshCopyConst(entry->mesh, mesh);
        entry->name = name;
        entry->ioMask = ioMask;
        meshes_.push_back(std::move(entry));
        return current_ = meshCount() - 1;
    }

    vcg::CallBackPos *progressCallback() { return cancels ? refuse : accept; }
    void beginFilterProgress(const QString &) { ++begun; }
    void finishFilterProgress(bool success, const QString &) { (success ? finished : failed)++; }

    // What tests set and see.
    bool cancels = false;
    int begun = 0, finished = 0, failed = 0;

private:
    static bool accept(const int, const char *) { return true; }
    static bool refuse(const int, const char *) { return false; }

    std::vector<std::unique_ptr<MeshEntry>> meshes_;
    int current_ = -1;
};
