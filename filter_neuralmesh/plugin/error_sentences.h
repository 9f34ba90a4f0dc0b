// SPDX-License-Identifier: GPL-3.0-or-later
// The words that users of the filters know. No Qt here.
#pragma once

#include <string>

#include "hosts/common/host_terms.h"

/// Parameters are called as in dialogs and scripts, meshes are layers, files are opened in MeshLab.
const neuralmesh::HostTerms &filterTerms();

/// The sentence for the user, in plain text.
std::string sentenceFor(const neuralmesh::InvalidInput &error);
