// SPDX-License-Identifier: GPL-3.0-or-later
// What the filter tells its user about a reconstruction: returned values and the line in the log.
#pragma once

#include <QVariant>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/growth.h"

struct Reconstruction {
    neuralmesh::NeuralMesh mesh;
    std::vector<std::unique_ptr<neuralmesh::NeuralMesh>> snapshots; ///< by vertex count, ascending
    neuralmesh::GrowthReport growth;
    std::uint64_t seed = 0;
    double diagonal = 0; ///< of the input's bounding box: errors of the growth are in units of it
    double seconds = 0;
};

/// The values returned to scripts, with the names of the interface. Only types that PyMeshLab
/// passes on: int, bool, double and vectors.
std::map<std::string, QVariant> resultValues(const Reconstruction &result);

/// Plain text: figures, and whether idle vertices were kept.
std::string summary(const Reconstruction &result);
