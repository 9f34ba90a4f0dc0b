// SPDX-License-Identifier: GPL-3.0-or-later
// A stand-in, as meshfilterplugin.h is. Where the seed is 0, this one "draws" 7.
#pragma once

#include "meshfilterplugin.h"

struct RandomSeed {
    unsigned int value = 0;
    QString message() const { return QStringLiteral("Random seed: %1").arg(value); }
};

class FilterParams {
public:
    explicit FilterParams(const MeshFilterParameterValues &values) : values_(values) {}
    const MeshFilterParameterValues &rawValues() const { return values_; }
    RandomSeed getRandomSeed() const
    {
        const unsigned int given = values_.value(QStringLiteral("randomSeed")).toUInt();
        return {given == 0 ? 7 : given};
    }

private:
    MeshFilterParameterValues values_;
};
