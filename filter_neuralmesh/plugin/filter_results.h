// SPDX-License-Identifier: GPL-3.0-or-later
// What the filter tells its user about a reconstruction: returned values and the line in the log.
#pragma once

#include <QVariant>
#include <map>
#include <string>
#include <vector>

#include "neuralmesh/reconstruct.h"

struct Reconstruction {
    neuralmesh::Result result;
    std::vector<neuralmesh::Mesh> snapshots; ///< by vertex count, ascending
    std::uint64_t seed = 0;
    double diagonal = 1; ///< of the input's bounding box
    double seconds = 0;
};

/// The values returned to scripts, with the names of the interface. Only types that PyMeshLab
/// passes on: int, bool, double and vectors.
std::map<std::string, QVariant> resultValues(const Reconstruction &reconstruction);

/// Plain text: figures, and whether idle vertices were kept.
std::string summary(const Reconstruction &reconstruction);
