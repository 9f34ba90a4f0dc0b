// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_results.h"

#include <common/plugins/interfaces/filter_plugin.h>

#include "error_sentences.h"

namespace {

QVariant toVariant(int value)
{
    return value;
}

QVariant toVariant(bool value)
{
    return value;
}

QVariant toVariant(double value)
{
    return value;
}

template <class T> QVariant toVariant(const std::vector<T> &values)
{
    Eigen::VectorXd vector(static_cast<Eigen::Index>(values.size()));
    for (std::size_t k = 0; k < values.size(); ++k)
        vector[static_cast<Eigen::Index>(k)] = values[k];
    return QVariant::fromValue(vector);
}

} // namespace

std::map<std::string, QVariant> resultValues(const neuralmesh::Reconstruction &reconstruction)
{
    std::map<std::string, QVariant> values;
    neuralmesh::forEachResult(reconstruction, [&](const char *name, const auto &value) {
        values[name] = toVariant(value);
    });
    return values;
}

std::string summary(const neuralmesh::Reconstruction &reconstruction)
{
    return neuralmesh::summary(reconstruction, filterTerms());
}
