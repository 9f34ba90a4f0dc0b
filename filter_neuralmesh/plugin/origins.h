// SPDX-License-Identifier: GPL-3.0-or-later
// Layers that are results of an earlier run, and what they were made of. A filter leaves its result
// as the current layer: whoever runs it again, as a notebook does, means the scan and not the mesh.
#pragma once

#include <optional>
#include <string>

#include <common/ml_document/mesh_document.h>

#include "target_space.h"

/// Notes in a result what it was made of, and what it looks like.
void remember(MeshModel &result, const Origin &origin);

/// What a layer was made of, if it is a result that nobody has changed since.
std::optional<Origin> originOf(const MeshModel &layer);

/// The layer that a run with this Source works on, nullptr where there is none: the current one, or
/// if that is an unchanged result of the same Source, what it was made of.
const MeshModel *inputLayer(const MeshDocument &document, Source source);

/// What to say in the log where the current layer is a result of an earlier run; empty where it is
/// not.
std::string remarkOnOrigin(const MeshDocument &document, Source source);
