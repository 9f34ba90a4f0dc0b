// SPDX-License-Identifier: GPL-3.0-or-later
// What the filter tells its user about a reconstruction: returned values and the line in the log.
#pragma once

#include <QVariant>
#include <map>
#include <string>

#include "hosts/common/reconstruction.h"

/// The values returned to scripts. Only types that PyMeshLab passes on: int, bool, double and
/// vectors.
std::map<std::string, QVariant> resultValues(const neuralmesh::Reconstruction &reconstruction);

/// The line in the log, in the words of the filter's users.
std::string summary(const neuralmesh::Reconstruction &reconstruction);
