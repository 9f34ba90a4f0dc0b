// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in for the header of this name of MeshLab's rewrite: of what it declares, that which the
// adapter in hosts/meshlab2 uses, with the same names, types and defaults. docs/hosts.md says from
// where they are known.
#pragma once

#include <QString>
#include <QStringList>
#include <QVariantMap>
#include <QVector>

class Document;
class FilterParams;

using MeshFilterParameterValues = QVariantMap;

struct MeshFilterRunResult {
    bool success = false;
    bool documentModified = false;
    QString errorMessage;
    QStringList infoMessages;
    QVector<int> newMeshIndices;
    QVector<int> sourceMeshIndices;
    QStringList outputTags;
    QVariantMap outputValues;
};

class MeshFilterPlugin {
public:
    virtual ~MeshFilterPlugin() = default;
    virtual QString pluginId() const = 0;
    virtual QString name() const = 0;
    virtual MeshFilterRunResult runFilter(const QString &filterId, const FilterParams &params,
                                          Document &doc) const = 0;
};
