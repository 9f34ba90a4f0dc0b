// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_documentation.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace {

QJsonObject describe(const RichParameter &parameter)
{
    QJsonObject description{{"name", parameter.name().toLower()},
                            {"title", parameter.fieldDescription()},
                            {"help", parameter.toolTip()},
                            {"advanced", parameter.isAdvanced()}};
    if (const auto *choice = dynamic_cast<const RichEnum *>(&parameter))
        description["choices"] = QJsonArray::fromStringList(choice->enumvalues);
    if (dynamic_cast<const RichPercentage *>(&parameter) != nullptr)
        description["percentage"] = true;
    return description;
}

} // namespace

QByteArray documentationOf(FilterNeuralMesh &plugin)
{
    const MeshDocument empty;
    QJsonArray filters;
    for (const QAction *action : plugin.actions()) {
        const auto id = plugin.ID(action);
        if (id == FilterNeuralMesh::FromLayersByOldName)
            continue;
        QJsonArray parameters;
        for (const RichParameter &parameter : plugin.initParameterList(action, empty))
            parameters.append(describe(parameter));
        filters.append(QJsonObject{{"name", plugin.pythonFilterName(id)},
                                   {"title", plugin.filterName(id)},
                                   {"info", plugin.filterInfo(id)},
                                   {"parameters", parameters}});
    }
    return QJsonDocument(filters).toJson(QJsonDocument::Compact);
}

const char *neuralmesh_documentation()
{
    static const QByteArray json = [] {
        FilterNeuralMesh plugin;
        return documentationOf(plugin);
    }();
    return json.constData();
}
